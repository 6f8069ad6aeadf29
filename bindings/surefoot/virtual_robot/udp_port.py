"""Where datagrams come from and go to."""

from __future__ import annotations

import errno
import socket
from typing import Protocol

from surefoot._core import Error

Address = tuple[str, int]
Datagram = tuple[bytes, Address]

_MAX_DATAGRAM_SIZE = 2048  # [bytes]; the longest frame has 839
_RECEIVE_BUFFER_SIZE = 65536  # [bytes] of the kernel: old datagrams must not pile up behind a flood


class DatagramPort(Protocol):
    """A datagram socket, or something that behaves like one in a test."""

    def receive(self, limit: int) -> list[Datagram]:
        """Return what has arrived, oldest first, at most `limit` datagrams; never wait."""
        ...

    def send(self, data: bytes, address: Address) -> bool:
        """Send a datagram; False if it could not go out just now. Never wait."""
        ...


class UdpPort:
    """A UDP socket on an address of this machine.

    Args:
        host: Address to bind; "" or "0.0.0.0" for all.
        port: 0 .. 65535; 0 lets the system choose.

    Raises:
        Error: No such port; an address that is none, or none of this machine's.
        OSError: The port is in use or may not be used.

    Attributes:
        address: Host and port that are bound.
    """

    def __init__(self, host: str, port: int) -> None:
        if not 0 <= port <= 65535:
            raise Error(f"port: got {port}, expected a number from 0 to 65535")
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            self._bind(host, port)
        except BaseException:
            self._socket.close()
            raise
        self._socket.setblocking(False)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _RECEIVE_BUFFER_SIZE)
        self.address: Address = self._socket.getsockname()

    def _bind(self, host: str, port: int) -> None:
        try:
            self._socket.bind((host, port))
        except (socket.gaierror, UnicodeError):
            raise Error(f"bind: got '{host}', expected an IPv4 address of this machine") from None
        except OSError as problem:
            if problem.errno == errno.EADDRNOTAVAIL:
                raise Error(f"bind: '{host}' is no address of this machine") from None
            reasons = {
                errno.EADDRINUSE: "it is in use (another virtual robot?); give another --port",
                errno.EACCES: "no permission; ports below 1024 are the system's",
                errno.EPERM: "no permission",
            }
            reason = reasons.get(problem.errno or 0, problem.strerror)
            raise OSError(f"cannot listen on {host}:{port}: {reason}") from None

    def receive(self, limit: int) -> list[Datagram]:
        """Return what has arrived, oldest first, at most `limit` datagrams; never wait."""
        datagrams: list[Datagram] = []
        while len(datagrams) < limit:
            try:
                datagrams.append(self._socket.recvfrom(_MAX_DATAGRAM_SIZE))
            except BlockingIOError:
                break
            except OSError:  # what an earlier datagram met on its way comes back here
                break
        return datagrams

    def send(self, data: bytes, address: Address) -> bool:
        """Send a datagram; False if it could not go out just now. Never wait."""
        try:
            self._socket.sendto(data, address)
        except OSError:  # a full buffer, a network that is down, a sender's port 0
            return False
        return True

    def close(self) -> None:
        """Free the port."""
        self._socket.close()
