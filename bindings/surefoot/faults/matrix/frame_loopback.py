"""Transport of samples as encoded frames: a UdpLink on loopback, in lockstep with the plant.

A socket of this process sends frames as the robot. Loopback delivers a frame before send() returns,
so the link reads each frame in the period in which it was sent. Nothing waits for the wall clock.
For this reason the matrix does not test wall times, such as UdpLink.state_age.
"""

from __future__ import annotations

import socket

from surefoot._core import LowState, UdpLink
from surefoot.protocol import default_generation, encode_low_state

_DEFAULT_GENERATION = "go1-v3.8"  # frame generation for robots without UDP frames
_ROBOTS_WITHOUT_FRAMES = ("go2",)  # robots that use only DDS


class FrameLoopback:
    """Both ends of a link on loopback.

    Args:
        robot: Name of the robot; for a robot without UDP frames, the link uses go1-v3.8.
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
        """Close the socket of the robot; the link closes when this object is deleted."""
        self._robot_socket.close()


def _generation(robot: str) -> str:
    return _DEFAULT_GENERATION if robot in _ROBOTS_WITHOUT_FRAMES else default_generation(robot)
