"""The web server of the page: its address is checked before anything is served."""

from __future__ import annotations

import contextlib
import errno
import functools
import io
import ipaddress
import socket
from collections.abc import Iterator
from typing import Any

import viser
import websockets.asyncio.server

from surefoot._core import Error


def open_server(host: str, port: int, title: str) -> viser.ViserServer:
    """Serve an empty page.

    Args:
        host: Address of this machine to listen on.
        port: 0 .. 65535; 0 lets the system choose.
        title: Of the panel.

    Raises:
        Error: No such port, no such address.
        OSError: The port is in use or may not be used.
    """
    port = _check_address(host, port)
    # viser says on stdout where it listens, in a frame of its own; the command says it in a line.
    with contextlib.redirect_stdout(io.StringIO()), _same_origin_only(host, port):
        server = viser.ViserServer(host=host, port=port, label=title, verbose=False)
    if server.get_port() != port:  # taken in between: viser moves on to the next one
        close_server(server)
        raise OSError(f"cannot listen on {host}:{port}: it is in use; give another --port")
    return server


def close_server(server: viser.ViserServer) -> None:
    """Stop serving, without viser's own words about it."""
    with contextlib.redirect_stdout(io.StringIO()):
        server.stop()


@contextlib.contextmanager
def _same_origin_only(host: str, port: int) -> Iterator[None]:
    """While a server opens on a loopback address: let no other site's pages connect to it.

    A browser lets any page open a socket to this machine, and viser takes whoever comes; a site
    that happens to be open must not move a robot's gains.
    """
    module: Any = websockets.asyncio.server
    serve = module.serve
    address = ipaddress.ip_address(socket.gethostbyname(host))
    if not address.is_loopback:  # by what name others reach this machine is not known here
        yield
        return
    # A program that is no browser says no origin; one that is leaves port 80 out.
    names = {host, str(address), "localhost"}
    origins = [None, *(f"http://{name}:{port}" for name in names)]
    origins += [f"http://{name}" for name in names if port == 80]
    module.serve = functools.partial(serve, origins=origins)
    try:
        yield
    finally:
        module.serve = serve


def _check_address(host: str, port: int) -> int:
    """Raise unless the address is free; return the port, chosen if it was 0."""
    if not 0 <= port <= 65535:
        raise Error(f"--port: got {port}, expected a number from 0 to 65535")
    if not host:
        raise Error("--bind: got '', expected an IPv4 address of this machine")
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as probe:
        # As the server itself: a port that a former page has just left is free.
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((host, port))
        except (socket.gaierror, UnicodeError):
            raise Error(f"--bind: got '{host}', expected an IPv4 address of this machine") from None
        except OSError as problem:
            if problem.errno == errno.EADDRNOTAVAIL:
                raise Error(f"--bind: '{host}' is no address of this machine") from None
            reasons = {
                errno.EADDRINUSE: "it is in use; give another --port",
                errno.EACCES: "no permission; ports below 1024 are the system's",
            }
            reason = reasons.get(problem.errno or 0, problem.strerror)
            raise OSError(f"cannot listen on {host}:{port}: {reason}") from None
        return int(probe.getsockname()[1])
