"""How the comparison with peers is run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from surefoot._core import Error

FOLDER = Path(".venv-peers")


def _ignore_progress(_: str) -> None:
    pass


@dataclass(frozen=True)
class PeerOptions:
    """Where the peers live and how ticks are interleaved.

    Attributes:
        urdf: The robot's; None looks it up by the robot's name.
        folder: Holds one environment per peer and what is compiled; made if it is not there.
        block: Ticks that one side computes before it is the other's turn.
        cpp: Compare in C++ too, where a compiler and the peer's headers allow.
        timeout: Longest time that a worker may take to start, and to answer a block [s].
        report_progress: Told what is going on, one line at a time: the first run installs for a minute.
    """

    urdf: Path | None = None
    folder: Path = FOLDER
    block: int = 25
    cpp: bool = True
    timeout: float = 30.0
    report_progress: Callable[[str], None] = _ignore_progress

    def __post_init__(self) -> None:
        if self.block < 1:
            raise Error(f"block: got {self.block}, expected 1 or more ticks")
        if not self.timeout > 0.0:
            raise Error(f"timeout: got {self.timeout}, expected more than 0 s")


class PeerError(Exception):
    """Why a peer did not run; ends in its row and never leaves run_peers()."""
