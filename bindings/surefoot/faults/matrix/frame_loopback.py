"""Transport of samples as real frames: a UdpLink on loopback, in lockstep with the plant.

A socket of this process is the robot's end. Loopback delivers before send() returns, so the link
reads each frame in the period in which it was sent, and nothing waits for a clock. For this reason
the wall time of the link (UdpLink.state_age) is not tested here.
"""

from __future__ import annotations

import socket

from surefoot._core import LowState, UdpLink
from surefoot.protocol import default_generation, encode_low_state

_DEFAULT_GENERATION = "go1-v3.8"  # for robots without UDP frames
_ROBOTS_WITHOUT_FRAMES = ("go2",)  # DDS only


class FrameLoopback:
    """Both ends of a loopback link.

    Args:
        robot: Name of the robot; a robot without UDP frames uses go1-v3.8.
    """

    def __init__(self, robot: str) -> None:
        self._generation = _generation(robot)
        self._robot_socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._robot_socket.bind(("127.0.0.1", 0))
        port = self._robot_socket.getsockname()[1]
        self._link = UdpLink(port=port, generation=self._generation)
        self._address = ("127.0.0.1", self._link.local_port)

    def encode(self, state: LowState) -> bytes:
        """Return the frame of a sample."""
        return encode_low_state(state, self._generation)

    def receive(self, datagrams: list[bytes]) -> LowState:
        """Send datagrams as the robot and return the newest LowState of the link."""
        for data in datagrams:
            self._robot_socket.sendto(data, self._address)
        self._link.receive()
        return self._link.state

    def close(self) -> None:
        """Close the robot's socket; the link closes with this object."""
        self._robot_socket.close()


def _generation(robot: str) -> str:
    return _DEFAULT_GENERATION if robot in _ROBOTS_WITHOUT_FRAMES else default_generation(robot)
