"""Faults of the link: changes of the LowState frames between robot and supervisor."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from surefoot.faults.kinds.fault import Fault
from surefoot.protocol import crc32

FrameChange = Callable[[bytes, int], list[bytes]]
"""Function of a frame and the period k; it returns the datagrams that arrive instead."""


class LinkFault(Fault):
    """Frames do not arrive as the robot sent them.

    Args:
        change: Function that changes the frames.
    """

    uses_frames = True

    def __init__(self, change: FrameChange) -> None:
        self._change = change

    def change_frame(self, frame: bytes, k: int) -> list[bytes]:
        """Return the datagrams that arrive instead of the frame."""
        return self._change(frame, k)


def no_frame(frame: bytes, k: int) -> list[bytes]:
    """Return no datagram: the frame is lost."""
    return []


def frozen_frame() -> FrameChange:
    """Return a change that delivers the first frame in every period."""
    kept: list[bytes] = []

    def change(frame: bytes, k: int) -> list[bytes]:
        kept.append(frame)
        return kept[:1]

    return change


def flipped_bit(frame: bytes, k: int) -> list[bytes]:
    """Flip one bit of the frame; do not correct the CRC."""
    damaged = bytearray(frame)
    damaged[(37 * k) % len(frame)] ^= 1 << k % 8
    return [bytes(damaged)]


def random_bytes(frame: bytes, k: int) -> list[bytes]:
    """Replace the frame by random bytes of the same length."""
    return [np.random.default_rng(k).bytes(len(frame))]


def truncated(frame: bytes, k: int) -> list[bytes]:
    """Cut off the second half of the frame."""
    return [frame[: len(frame) // 2]]


def wrong_length(size: int) -> FrameChange:
    """Return a change that gives frames a length of `size` bytes and a valid CRC."""

    def change(frame: bytes, k: int) -> list[bytes]:
        body = frame[: size - 4].ljust(size - 4, b"\0")
        return [body + crc32(body).to_bytes(4, "little")]

    return change


def random_loss(share: float) -> FrameChange:
    """Return a change that loses frames at random with probability `share`."""
    rng = np.random.default_rng(5)  # any fixed seed, so that runs repeat
    return lambda frame, k: [] if rng.uniform() < share else [frame]


def intermittent(change: FrameChange, every: int, length: int = 1) -> FrameChange:
    """Return a change that acts on the first `length` frames in each cycle of `every` frames."""
    return lambda frame, k: change(frame, k) if k % every < length else [frame]


def delayed(period_count: int, every: int = 1) -> FrameChange:
    """Return a change that delays one in `every` frames by `period_count` periods."""
    waiting: list[tuple[int, bytes]] = []

    def change(frame: bytes, k: int) -> list[bytes]:
        due = [f for when, f in waiting if when <= k]
        waiting[:] = [entry for entry in waiting if entry[0] > k]
        if k % every:
            return [frame, *due]
        waiting.append((k + period_count, frame))
        return due

    return change


def swapped(every: int) -> FrameChange:
    """Return a change after which one in `every` frames arrives after the next frame."""
    return delayed(1, every)


def duplicated(frame: bytes, k: int) -> list[bytes]:
    """Deliver the frame twice."""
    return [frame, frame]
