"""Options of the comparison with peers."""

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
    """Folders of the peers, and settings of the interleaved timing.

    Attributes:
        urdf: URDF of the robot; None to find it by the robot's name.
        folder: Folder of the peers' environments and executables; made if it does not exist.
        block: Ticks that one implementation computes before the next one's turn.
        cpp: Whether to compare in C++ too, if there is a compiler and the peer has headers.
        timeout: Longest time that a worker may take to start, and to compute a block [s].
        report_progress: Called with one line of text per step; the first run installs for a minute.
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
    """Reason why a peer did not run; run_peers() puts it into the row of the peer."""
