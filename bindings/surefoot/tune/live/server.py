"""Web server of the page, with a check of its address."""

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
    """Start a server with an empty page.

    Args:
        host: Address of this machine to listen on.
        port: TCP port, 0 .. 65535; 0 lets the system choose.
        title: Title of the panel.

    Raises:
        Error: The port is out of range, or the host is not an address of this machine.
        OSError: The port is in use or not permitted.
    """
    port = _check_address(host, port)
    # Suppress the box that viser prints on stdout; the command prints the address in one line.
    with contextlib.redirect_stdout(io.StringIO()), _same_origin_only(host, port):
        server = viser.ViserServer(host=host, port=port, label=title, verbose=False)
    if server.get_port() != port:  # another process took the port, so viser uses the next port
        close_server(server)
        raise OSError(f"cannot listen on {host}:{port}: it is in use; choose another --port")
    return server


def close_server(server: viser.ViserServer) -> None:
    """Stop the server and suppress viser's message about it."""
    with contextlib.redirect_stdout(io.StringIO()):
        server.stop()


@contextlib.contextmanager
def _same_origin_only(host: str, port: int) -> Iterator[None]:
    """Restrict a server that opens inside this context to connections from its own page.

    The restriction applies only to loopback addresses. A browser lets every page open a WebSocket
    to this machine, and viser accepts all connections. Without the restriction, another open web
    site could change the gains of a robot.
    """
    module: Any = websockets.asyncio.server
    serve = module.serve
    address = ipaddress.ip_address(socket.gethostbyname(host))
    if not address.is_loopback:  # the names of this machine in the network are unknown here
        yield
        return
    # Clients other than browsers send no origin; browsers omit port 80.
    names = {host, str(address), "localhost"}
    origins = [None, *(f"http://{name}:{port}" for name in names)]
    origins += [f"http://{name}" for name in names if port == 80]
    module.serve = functools.partial(serve, origins=origins)
    try:
        yield
    finally:
        module.serve = serve


def _check_address(host: str, port: int) -> int:
    """Check the address, and return the TCP port to listen on: `port`, or a free port if it is 0.

    Raises:
        Error: The port is out of range, or the host is not an address of this machine.
        OSError: The port is in use or not permitted.
    """
    if not 0 <= port <= 65535:
        raise Error(f"--port: got {port}, expected a number from 0 to 65535")
    if not host:
        raise Error("--bind: got '', expected an IPv4 address of this machine")
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as probe:
        # As the server does, accept a port that another page has just closed.
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((host, port))
        except (socket.gaierror, UnicodeError):
            raise Error(f"--bind: got '{host}', expected an IPv4 address of this machine") from None
        except OSError as problem:
            if problem.errno == errno.EADDRNOTAVAIL:
                raise Error(f"--bind: got '{host}', expected an address of this machine") from None
            reasons = {
                errno.EADDRINUSE: "it is in use; choose another --port",
                errno.EACCES: "no permission; choose a port from 1024 on",
            }
            reason = reasons.get(problem.errno or 0, problem.strerror)
            raise OSError(f"cannot listen on {host}:{port}: {reason}") from None
        return int(probe.getsockname()[1])
