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
        urdf: URDF of the robot. None: the robot's name determines the URDF.
        folder: Folder of the peers' environments and executables; made if it does not exist.
        block: Number of ticks that one implementation computes in its turn.
        cpp: Whether to compare in C++ too. This needs a compiler, and a peer with headers.
        timeout: Longest time that a worker may take to start, and to compute a block [s].
        report_progress: Called with one line of text per step, for example of an installation.
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
    """Reason why a peer did not run; run_peers() puts this reason into the peer's row."""
