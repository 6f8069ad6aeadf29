"""Programs that run in a process of their own, because what they try may crash or hang."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import dataclass

_MAX_TIME = 120.0  # [s]


@dataclass(frozen=True)
class ProbeResult:
    """End of a program.

    Attributes:
        works: Whether the program ended without an error.
        text: What it printed; after an error, its last line or the exit status.
    """

    works: bool
    text: str


def run_probe(program: str) -> ProbeResult:
    """Run a Python program; it fails if it does not end within 120 s."""
    try:
        result = subprocess.run(
            [sys.executable, "-c", program], capture_output=True, text=True, timeout=_MAX_TIME
        )
    except subprocess.TimeoutExpired:
        return ProbeResult(False, f"no answer within {_MAX_TIME:g} s")
    if result.returncode == 0:
        return ProbeResult(True, result.stdout.strip())
    lines = result.stderr.strip().splitlines() or [f"exit status {result.returncode}"]
    return ProbeResult(False, lines[-1])
