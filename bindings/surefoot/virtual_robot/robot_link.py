"""Robot's end of the link: receives and sends frames, and selects the peer."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from surefoot import protocol
from surefoot._core import Error, FrameExtras, LowState
from surefoot.protocol import ReceivedLowCmd
from surefoot.virtual_robot.channel import Channel
from surefoot.virtual_robot.rejected_datagrams import (
    WRONG_GENERATION,
    WRONG_LENGTH,
    RejectedDatagrams,
)
from surefoot.virtual_robot.settings import VirtualRobotSettings
from surefoot.virtual_robot.udp_port import Address, Datagram, DatagramPort

# Largest number of datagrams read per cycle, so that a flood does not stall the simulation. Chosen:
# larger than the burst of a controller after a stall. With a larger value, reading may take longer
# than a cycle of 1 ms.
MAX_DATAGRAMS_PER_CYCLE = 32
# [s] Lower limit of the hold time: for this long after a valid command, a query does not change the
# peer. A valid command of another sender changes the peer at once. Equal to the default timeout
# after which the motors damp.
_MIN_PEER_HOLD_TIME = 0.1
_RNG_STREAM = 10  # number of the first of two random streams; the plant uses 0 .. 3


class RobotLink:
    """Link that decodes commands, counts rejected datagrams, and sends samples to one peer.

    The peer is the sender of the last valid command. The hold time is the larger one of
    settings.timeout and 0.1 s. If no valid command arrived for longer than the hold time, the peer
    is the sender of the last query. A query is a datagram that is not a valid command, but is blank
    or has the length of the LowCmd of any frame generation. The robot answers a query with samples,
    whose length shows the frame generation of this robot.

    Args:
        port: Port that receives and sends datagrams.
        settings: Settings of the robot and its link.

    Attributes:
        peer: Address to which samples are sent; None before the first command or query.
        received: Number of datagrams that arrived.
        commands: Number of datagrams with a valid command.
        overtaken: Number of commands that were replaced by a newer command in the same cycle; the
            motors did not receive them.
        repeated: Number of commands that equal the command before in every byte. If the robot
            should move, a large number means that the sender computes no new commands.
        rejected: Rejected datagrams, counted by reason.
        sent: Number of datagrams sent, including those that the channel loses.
        unsent: Number of datagrams that could not be sent.
    """

    def __init__(self, port: DatagramPort, settings: VirtualRobotSettings) -> None:
        self._port = port
        self._generation = settings.generation
        self._lengths = {protocol.frame_sizes(name)[0] for name in protocol.GENERATIONS}
        impairments = settings.drop, settings.delay, settings.jitter
        rngs = [np.random.default_rng([settings.seed, _RNG_STREAM + k]) for k in range(2)]
        self._incoming: Channel[Datagram] = Channel(*impairments, rngs[0])
        self._outgoing: Channel[Datagram] = Channel(*impairments, rngs[1])
        self._extras = _battery_extras()
        self.peer: Address | None = None
        self.received = self.commands = self.overtaken = self.repeated = 0
        self.sent = self.unsent = 0
        self._last_command = b""
        self._peer_hold_time = max(settings.timeout, _MIN_PEER_HOLD_TIME)  # [s] after a command
        self._last_command_time = -math.inf  # [s]
        self.rejected = RejectedDatagrams(settings.generation)

    @property
    def lost(self) -> tuple[int, int]:
        """Numbers of lost datagrams: incoming, outgoing."""
        return self._incoming.lost, self._outgoing.lost

    def receive(self, time: float) -> ReceivedLowCmd | None:
        """Read datagrams, and return the newest valid command that arrived by a time [s], or None.

        None: no valid command arrived since the last call.
        """
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

    def send_state(self, state: LowState, time: float) -> None:
        """Send a LowState to the peer at a time [s], if there is a peer."""
        if self.peer is None:
            return
        try:
            frame = protocol.encode_low_state(state, self._generation, self._extras)
        except Error:  # the simulation diverged: a value is NaN or infinite
            self.unsent += 1
            return
        self.send(frame, time)

    def take_news(self) -> list[str]:
        """Return warnings about rejected datagrams since the last call."""
        return self.rejected.take_news()

    def rejected_text(self) -> str:
        """Return the number of rejected datagrams and of each reason as text."""
        return self.rejected.text()

    def rejected_counts(self) -> dict[str, int]:
        """Return the number of rejected datagrams by reason."""
        return self.rejected.counts

    def rejected_lengths(self) -> list[dict[str, Any]]:
        """Return the wrong lengths of datagrams as JSON values."""
        return self.rejected.lengths()

    def _is_query(self, data: bytes) -> bool:
        """Return True if an invalid datagram is a query; see the class."""
        return len(data) in self._lengths or is_blank(data)

    def _decode(self, data: bytes) -> ReceivedLowCmd | None:
        try:
            cmd = protocol.decode_low_cmd(data, self._generation)
        except Error:
            self.rejected.add(rejection_reason(data, self._generation), data)
            return None
        self.commands += 1
        self.repeated += data == self._last_command
        self._last_command = data
        return cmd


def _battery_extras() -> FrameExtras:
    """Return readings of the B1's battery for which LowState has no fields: chosen constants."""
    extras = FrameExtras()
    extras.BQ_NTC[:], extras.MCU_NTC[:] = 30, 32
    extras.cell_vol[:4] = 3850
    return extras


def is_blank(data: bytes) -> bool:
    """Return True if all bytes of a datagram are 0; the SDK sends this before the first command."""
    return 0 < len(data) == data.count(0)


def rejection_reason(data: bytes, generation: str) -> str:
    """Return one of a few short reasons why a datagram is not a LowCmd of a generation.

    The link counts the datagrams of each reason. The error of protocol.decode_low_cmd() has a full
    message. LowCmd frames of go1-v3.8 and b1-v3.8 have the same length and cannot be distinguished.
    """
    if is_blank(data):
        return "blank"
    if len(data) != protocol.frame_sizes(generation)[0]:
        lengths = {protocol.frame_sizes(name)[0] for name in protocol.GENERATIONS}
        return WRONG_GENERATION if len(data) in lengths else WRONG_LENGTH
    if generation.endswith("-v3.8"):  # only frames of v3.8 have this header
        if data[:2] != b"\xfe\xef":
            return "wrong head"
        if data[2] != 0xFF:
            return "wrong level"
    if int.from_bytes(data[-4:], "little") != protocol.crc32(data[:-4]):
        return "wrong crc"
    return "not finite"
