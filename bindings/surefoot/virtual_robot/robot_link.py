"""The robot's end of the wire: frames in, frames out, and to whom."""

from __future__ import annotations

import math

import numpy as np

from surefoot import protocol
from surefoot._core import Error
from surefoot.protocol import ReceivedLowCmd
from surefoot.virtual_robot.channel import Channel
from surefoot.virtual_robot.settings import VirtualRobotSettings
from surefoot.virtual_robot.udp_port import Address, DatagramPort

MAX_DATAGRAMS_PER_CYCLE = 32  # datagrams read: a peer that floods must not stall the physics
_MIN_PEER_HOLD_TIME = 0.1  # [s] for which who commanded last is answered, and nobody else
_RNG_STREAM = 10  # of random numbers; the plant has 0 .. 3


class RobotLink:
    """Receives commands and counts what is none; sends to whom commands it.

    Where nobody does, whoever spoke last in frames of any generation, or blank, is answered, so
    that a program can tell what robot this is. While somebody does, nobody else is.

    Args:
        port: Where datagrams come from and go to.
        settings: Generation, loss, delay, seed.

    Attributes:
        peer: Whom reports go to; None before anyone spoke.
        received: Datagrams that arrived.
        commands: Valid commands among them.
        overtaken: Commands that a newer one of the same cycle made void: no motor saw them.
        repeated: Commands that are byte for byte the one before. Many in a moving program mean that
            it sends on what it no longer computes.
        rejected: Number of the others by reason.
        sent: Datagrams sent, those that get lost on the way among them.
        unsent: Datagrams that could not be sent.
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
        """Datagrams that got lost on their way in and out."""
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
        """Send a frame to the peer at a time [s]; also what is due by now of earlier ones."""
        if self.peer is not None:
            self.sent += 1
            self._outgoing.put((frame, self.peer), time)
        for datagram in self._outgoing.take(time):
            self.unsent += not self._port.send(*datagram)

    def _is_query(self, data: bytes) -> bool:
        """Return whether a datagram is that of a program which does not know the robot yet."""
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
    """Return whether a datagram is all zero, as the SDK sends before a program's first command."""
    return 0 < len(data) == data.count(0)


def rejection_reason(data: bytes, generation: str) -> str:
    """Return in two words why a datagram is no LowCmd of a generation.

    protocol.decode_low_cmd() says it in a sentence with the numbers of the case; these can be
    counted. go1-v3.8 and b1-v3.8 have LowCmds of one length, which nothing tells apart.
    """
    if is_blank(data):
        return "blank"
    if len(data) != protocol.frame_sizes(generation)[0]:
        lengths = {protocol.frame_sizes(name)[0] for name in protocol.GENERATIONS}
        return "wrong generation" if len(data) in lengths else "wrong length"
    if generation.endswith("-v3.8"):  # the others' headers have neither of the two
        if data[:2] != b"\xfe\xef":
            return "wrong head"
        if data[2] != 0xFF:
            return "wrong level"
    if int.from_bytes(data[-4:], "little") != protocol.crc32(data[:-4]):
        return "wrong crc"
    return "not finite"
