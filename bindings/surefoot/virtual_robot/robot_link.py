"""Robot's end of the link: receives and sends frames, and chooses the peer."""

from __future__ import annotations

import math

import numpy as np

from surefoot import protocol
from surefoot._core import Error
from surefoot.protocol import ReceivedLowCmd
from surefoot.virtual_robot.channel import Channel
from surefoot.virtual_robot.settings import VirtualRobotSettings
from surefoot.virtual_robot.udp_port import Address, DatagramPort

MAX_DATAGRAMS_PER_CYCLE = (
    32  # limit of datagrams read, so that a flood does not stall the simulation
)
_MIN_PEER_HOLD_TIME = 0.1  # [s] after a valid command, in which only its sender is answered
_RNG_STREAM = 10  # first of two random streams; the plant has 0 .. 3


class RobotLink:
    """Link that decodes commands, counts rejected datagrams, and sends samples to one peer.

    The peer is the sender of the last valid command. If no valid command arrived for the hold time
    (the larger of settings.timeout and 0.1 s), the peer is the sender of the last datagram that has
    the length of any generation's LowCmd or is blank. So a program can find out the generation of
    this robot.

    Args:
        port: Port that receives and sends datagrams.
        settings: Generation, loss, delay and seed.

    Attributes:
        peer: Address that samples are sent to; None before the first peer.
        received: Number of datagrams that arrived.
        commands: Number of valid commands among them.
        overtaken: Number of commands replaced by a newer one in the same cycle; the motors did not
            receive them.
        repeated: Number of commands equal to the one before in every byte. If the robot should
            move, many of them mean that the sender repeats a command without computing a new one.
        rejected: Number of rejected datagrams, by reason.
        sent: Number of datagrams sent, including those that the channel loses.
        unsent: Number of datagrams that could not be sent.
    """

    def __init__(self, port: DatagramPort, settings: VirtualRobotSettings) -> None:
        self._port = port
        self._generation = settings.generation
        self._lengths = {protocol.frame_sizes(name)[0] for name in protocol.GENERATIONS}
        impairments = settings.drop, settings.delay, settings.jitter
        rngs = [np.random.default_rng([settings.seed, _RNG_STREAM + k]) for k in range(2)]
        self._incoming, self._outgoing = (Channel(*impairments, rng) for rng in rngs)
        self.peer: Address | None = None
        self.received = self.commands = self.overtaken = self.repeated = 0
        self.sent = self.unsent = 0
        self._last_command = b""
        self._peer_hold_time = max(settings.timeout, _MIN_PEER_HOLD_TIME)  # [s] after a command
        self._last_command_time = -math.inf  # [s]
        self.rejected: dict[str, int] = {}

    @property
    def lost(self) -> tuple[int, int]:
        """Numbers of lost datagrams: incoming, outgoing."""
        return self._incoming.lost, self._outgoing.lost

    def receive(self, time: float) -> ReceivedLowCmd | None:
        """Return the newest valid command that arrived by a time [s], or None."""
        for datagram in self._port.receive(MAX_DATAGRAMS_PER_CYCLE):
            self._incoming.put(datagram, time)
        newest = None
        for data, sender in self._incoming.take(time):
            self.received += 1
            cmd = self._decode(data)
            if cmd is not None:
                self.peer, self._last_command_time = sender, time
                self.overtaken += newest is not None
                newest = cmd
            elif time - self._last_command_time > self._peer_hold_time and self._is_query(data):
                self.peer = sender
        return newest

    def send(self, frame: bytes, time: float) -> None:
        """Send a frame to the peer at a time [s], and earlier frames whose delay is over."""
        if self.peer is not None:
            self.sent += 1
            self._outgoing.put((frame, self.peer), time)
        for datagram in self._outgoing.take(time):
            self.unsent += not self._port.send(*datagram)

    def _is_query(self, data: bytes) -> bool:
        """Return whether a datagram may come from a program that looks for the generation."""
        return len(data) in self._lengths or is_blank(data)

    def _decode(self, data: bytes) -> ReceivedLowCmd | None:
        try:
            cmd = protocol.decode_low_cmd(data, self._generation)
        except Error:
            reason = rejection_reason(data, self._generation)
            self.rejected[reason] = self.rejected.get(reason, 0) + 1
            return None
        self.commands += 1
        self.repeated += data == self._last_command
        self._last_command = data
        return cmd


def is_blank(data: bytes) -> bool:
    """Return whether a datagram is all zero: the SDK sends such ones before the first command."""
    return 0 < len(data) == data.count(0)


def rejection_reason(data: bytes, generation: str) -> str:
    """Return in two words why a datagram is not a LowCmd of a generation.

    The reasons can be counted; protocol.decode_low_cmd() raises a full message. LowCmd frames of
    go1-v3.8 and b1-v3.8 have the same length and cannot be distinguished.
    """
    if is_blank(data):
        return "blank"
    if len(data) != protocol.frame_sizes(generation)[0]:
        lengths = {protocol.frame_sizes(name)[0] for name in protocol.GENERATIONS}
        return "wrong generation" if len(data) in lengths else "wrong length"
    if generation.endswith("-v3.8"):  # frames of other generations have no such header
        if data[:2] != b"\xfe\xef":
            return "wrong head"
        if data[2] != 0xFF:
            return "wrong level"
    if int.from_bytes(data[-4:], "little") != protocol.crc32(data[:-4]):
        return "wrong crc"
    return "not finite"
