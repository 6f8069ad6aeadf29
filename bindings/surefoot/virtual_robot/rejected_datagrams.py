"""Counts of the datagrams that a virtual robot rejected, and what was wrong with their lengths."""

from __future__ import annotations

from typing import Any

from surefoot import protocol

WRONG_GENERATION = "wrong generation"
WRONG_LENGTH = "wrong length"
# Number of different lengths that are counted one by one. Chosen: more than programs of all
# generations send. A flood of random datagrams must not fill the memory.
_MAX_LENGTHS = 8


class RejectedDatagrams:
    """Counts of rejected datagrams.

    Args:
        generation: Generation of the frames that the robot accepts.

    Attributes:
        counts: Number of datagrams by reason.
    """

    def __init__(self, generation: str) -> None:
        self._generation = generation
        self._expected_size = protocol.frame_sizes(generation)[0]
        self._lengths: dict[int, int] = {}
        self._news: list[str] = []
        self.counts: dict[str, int] = {}

    def add(self, reason: str, data: bytes) -> None:
        """Count a datagram that was rejected for a reason of rejection_reason()."""
        self.counts[reason] = self.counts.get(reason, 0) + 1
        if reason not in (WRONG_GENERATION, WRONG_LENGTH):
            return
        size = len(data)
        if size not in self._lengths:
            if len(self._lengths) == _MAX_LENGTHS:
                return
            self._news.append(self._warning(size))
        self._lengths[size] = self._lengths.get(size, 0) + 1

    def take_news(self) -> list[str]:
        """Return a warning for each length that arrived for the first time since the last call."""
        news, self._news = self._news, []
        return news

    def text(self) -> str:
        """Return the number of datagrams and of each reason as text, most frequent first."""
        if not self.counts:
            return "0"
        reasons = sorted(self.counts.items(), key=lambda item: -item[1])
        text = ", ".join(f"{reason} {count}" for reason, count in reasons)
        if self._lengths:
            got = " and ".join(f"{size} bytes{_of(_generations(size))}" for size in self._lengths)
            text += f": {got}, expected {self._expected_size} bytes of {self._generation}"
        return f"{sum(self.counts.values())} ({text})"

    def lengths(self) -> list[dict[str, Any]]:
        """Return the wrong lengths as JSON values: bytes, generations, count, what was expected."""
        return [
            {
                "bytes": size,
                "generations": _generations(size),
                "count": count,
                "expected_bytes": self._expected_size,
                "expected_generation": self._generation,
            }
            for size, count in self._lengths.items()
        ]

    def _warning(self, size: int) -> str:
        names = _generations(size)
        remedy = f"; start this robot with --sdk {names[0]}, or use another SDK" if names else ""
        return (
            f"rejected a command: got {size} bytes{_of(names) or ', no frame of any generation'}, "
            f"expected {self._expected_size} bytes of {self._generation}{remedy}"
        )


def _generations(size: int) -> list[str]:
    """Return the generations whose LowCmd frames have this length [bytes]."""
    return [name for name in protocol.GENERATIONS if protocol.frame_sizes(name)[0] == size]


def _of(generations: list[str]) -> str:
    return f" of {' or '.join(generations)}" if generations else ""
