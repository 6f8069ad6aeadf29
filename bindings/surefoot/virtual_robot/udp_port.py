"""UDP port that receives and sends datagrams without blocking."""

from __future__ import annotations

import errno
import socket
from typing import Protocol

from surefoot._core import Error

Address = tuple[str, int]
Datagram = tuple[bytes, Address]

# [bytes] Size of the buffer for one datagram. Chosen: larger than the longest frame (839 bytes), so
# that the link detects a datagram of a wrong length.
_MAX_DATAGRAM_SIZE = 2048
# [bytes] Size of the receive buffer in the kernel. Chosen: about 78 frames of 839 bytes. With a
# larger buffer, a flood queues more datagrams.
_RECEIVE_BUFFER_SIZE = 65536


class DatagramPort(Protocol):
    """Interface of a datagram socket; tests can replace the socket by another implementation."""

    def receive(self, limit: int) -> list[Datagram]:
        """Return at most `limit` datagrams that have arrived, oldest first, without blocking."""
        ...

    def send(self, data: bytes, address: Address) -> bool:
        """Send a datagram without blocking; return False if it could not be sent."""
        ...


class UdpPort:
    """A UDP socket on an address of this machine.

    Args:
        host: Address to bind; "" or "0.0.0.0" for all addresses.
        port: Port to bind, 0 .. 65535; 0: the system chooses a port.

    Raises:
        Error: The port is out of range, or the host is not an address of this machine.
        OSError: The port is in use or not permitted.

    Attributes:
        address: Host and port to which the socket is bound.
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
                raise Error(f"bind: got '{host}', expected an address of this machine") from None
            reasons = {
                errno.EADDRINUSE: "it is in use (another virtual robot?); choose another --port",
                errno.EACCES: "no permission; choose a port from 1024 on",
                errno.EPERM: "no permission",
            }
            reason = reasons.get(problem.errno or 0, problem.strerror)
            raise OSError(f"cannot listen on {host}:{port}: {reason}") from None

    def receive(self, limit: int) -> list[Datagram]:
        """Return at most `limit` datagrams that have arrived, oldest first, without blocking."""
        datagrams: list[Datagram] = []
        while len(datagrams) < limit:
            try:
                datagrams.append(self._socket.recvfrom(_MAX_DATAGRAM_SIZE))
            except BlockingIOError:
                break
            except OSError:  # the system reports an error of a datagram that was sent before
                break
        return datagrams

    def send(self, data: bytes, address: Address) -> bool:
        """Send a datagram without blocking; return False if it could not be sent."""
        try:
            self._socket.sendto(data, address)
        except OSError:  # the buffer is full, the network is down, or the port of the peer is 0
            return False
        return True

    def close(self) -> None:
        """Close the socket."""
        self._socket.close()
