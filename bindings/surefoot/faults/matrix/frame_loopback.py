"""The way of a report through real frames: a UdpLink on loopback, in lockstep with the plant.

The robot's end is a socket of this process; loopback delivers before send() returns, so what was
sent in a period is there when the link is read in it, and nothing waits for a clock. What the link
says of wall time, UdpLink.state_age, is therefore not put to the test here.
"""

from __future__ import annotations

import socket

from surefoot._core import LowState, UdpLink
from surefoot.protocol import default_generation, encode_low_state

_DEFAULT_GENERATION = "go1-v3.8"  # a go2 has no UDP frames of its own
_ROBOTS_WITHOUT_FRAMES = ("go2",)


class FrameLoopback:
    """Both ends.

    Args:
        robot: Its name; a robot without frames of its own speaks go1-v3.8.
    """

    def __init__(self, robot: str) -> None:
        self._generation = _generation(robot)
        self._robot_socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._robot_socket.bind(("127.0.0.1", 0))
        port = self._robot_socket.getsockname()[1]
        self._link = UdpLink(port=port, generation=self._generation)
        self._address = ("127.0.0.1", self._link.local_port)

    def encode(self, state: LowState) -> bytes:
        """Return a report's frame."""
        return encode_low_state(state, self._generation)

    def receive(self, datagrams: list[bytes]) -> LowState:
        """Send datagrams as the robot and return the link's newest report, as a loop has it."""
        for data in datagrams:
            self._robot_socket.sendto(data, self._address)
        self._link.receive()
        return self._link.state

    def close(self) -> None:
        """Close the robot's socket; the link goes with this object."""
        self._robot_socket.close()


def _generation(robot: str) -> str:
    return _DEFAULT_GENERATION if robot in _ROBOTS_WITHOUT_FRAMES else default_generation(robot)
