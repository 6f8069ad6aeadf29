"""A bench as a table for people."""

from __future__ import annotations

from typing import Any

from surefoot.bench.settings import PUSH_SHARE
from surefoot.bench.timing import PERCENTILES

STAGES = {
    "tick": "StandController.update()",
    "estimate": "StateEstimator.update() alone",
    "whole_body": "WholeBodyController.update() alone, holding the first pose",
    "null": "an empty Python call",
}
NOTE = (
    "Wall time of calls from Python: each includes the clock's share, which the empty call shows, "
    "and\nthe binding's overhead of about a microsecond. The first call is among them. Parts run "
    "alone, so they\nneed not add up to a tick. Where other programs share the processor, the "
    "tail is theirs."
)
FAILED = "SOME CALLS FAILED: what they took is not the time of a tick that was solved."


def bench_text(b: dict[str, Any]) -> str:
    """Return what run_bench() returned for people to read."""
    head = ["[us]", "n", *PERCENTILES, "iterations", "failed", "what"]
    rows = [_row(b, stage) for stage in STAGES]
    widths = [max(len(row[k]) for row in (head, *rows)) for k in range(len(head))]
    lines = []
    for row in (head, *rows):
        name, *numbers, what = (
            cell.ljust(width) if k in (0, len(head) - 1) else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        )
        lines.append("  ".join([name, *numbers, what]).rstrip())
    title = (
        f"{b['robot']}, {b['form']} form: {b['ticks']} reports at {b['rate']:g} Hz, real sensors, "
        f"half-way a push of {b['push_ns']:.2f} N.s ({100 * PUSH_SHARE:.0f} %)"
    )
    notes = [FAILED, NOTE] if any(b["failures"].values()) else [NOTE]
    return "\n".join([title, machine_line(b["machine"]), "", *lines, "", *notes])


def machine_line(m: dict[str, Any]) -> str:
    """Return the machine in one line."""
    versions = ", ".join(f"{name} {v}" for name, v in m["versions"].items() if v is not None)
    governor = f"governor {m['governor'] or 'unknown'}"
    parts = [m["cpu"] or "unknown processor", f"{m['cores']} cores", governor]
    return ", ".join([*parts, m["system"], f"Python {m['python']}", versions])


def _row(b: dict[str, Any], stage: str) -> list[str]:
    times = b[f"{stage}_us"]
    spread = b["iterations"].get(stage)
    iterations = f"{spread['mean']:.2f}, max {spread['max']}" if spread else "-"
    failed = str(b["failures"].get(stage, "-"))
    numbers = [f"{times[name]:.1f}" for name in PERCENTILES]
    return [stage, str(times["n"]), *numbers, iterations, failed, STAGES[stage]]
