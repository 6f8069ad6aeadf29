"""Faults of the link: what becomes of a report's frame on its way."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from surefoot.faults.kinds.fault import Fault
from surefoot.protocol import crc32

FrameChange = Callable[[bytes, int], list[bytes]]
"""Datagrams that arrive in the k-th period in place of a frame."""


class LinkFault(Fault):
    """Frames do not arrive as they were sent.

    Args:
        damage: What becomes of them.
    """

    uses_frames = True

    def __init__(self, damage: FrameChange) -> None:
        self._damage = damage

    def change_frame(self, frame: bytes, k: int) -> list[bytes]:
        """Return what arrives."""
        return self._damage(frame, k)


def no_frame(frame: bytes, k: int) -> list[bytes]:
    """Lose it."""
    return []


def frozen_frame() -> FrameChange:
    """Return what sends the first frame for ever."""
    kept: list[bytes] = []

    def damage(frame: bytes, k: int) -> list[bytes]:
        kept.append(frame)
        return kept[:1]

    return damage


def flipped_bit(frame: bytes, k: int) -> list[bytes]:
    """Turn one bit round, without the CRC's knowing."""
    damaged = bytearray(frame)
    damaged[(37 * k) % len(frame)] ^= 1 << k % 8
    return [bytes(damaged)]


def random_bytes(frame: bytes, k: int) -> list[bytes]:
    """Send anything, as long as a frame."""
    return [np.random.default_rng(k).bytes(len(frame))]


def truncated(frame: bytes, k: int) -> list[bytes]:
    """Cut a frame off."""
    return [frame[: len(frame) // 2]]


def wrong_length(size: int) -> FrameChange:
    """Return what sends frames as long as another generation's, their CRC right."""

    def damage(frame: bytes, k: int) -> list[bytes]:
        body = frame[: size - 4].ljust(size - 4, b"\0")
        return [body + crc32(body).to_bytes(4, "little")]

    return damage


def random_loss(share: float) -> FrameChange:
    """Return what loses frames by chance."""
    rng = np.random.default_rng(5)
    return lambda frame, k: [] if rng.uniform() < share else [frame]


def intermittent(damage: FrameChange, every: int, length: int = 1) -> FrameChange:
    """Return damage that comes every so many frames for a few."""
    return lambda frame, k: damage(frame, k) if k % every < length else [frame]


def delayed(ticks: int, every: int = 1) -> FrameChange:
    """Return what brings every so many'th frame so many periods late, the others at once."""
    waiting: list[tuple[int, bytes]] = []

    def damage(frame: bytes, k: int) -> list[bytes]:
        due = [f for when, f in waiting if when <= k]
        waiting[:] = [entry for entry in waiting if entry[0] > k]
        if k % every:
            return [frame, *due]
        waiting.append((k + ticks, frame))
        return due

    return damage


def swapped(every: int) -> FrameChange:
    """Return what lets a frame be overtaken by the next, every so many."""
    return delayed(1, every)


def duplicated(frame: bytes, k: int) -> list[bytes]:
    """Bring it twice."""
    return [frame, frame]
