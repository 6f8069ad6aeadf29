"""Figures of a benchmark as a table of text."""

from __future__ import annotations

from typing import Any

from surefoot.bench.timing_statistics import PERCENTILES

ROW_MEANINGS = {
    "tick": "LowState to LowCmd: update() of StandController or WalkController",
    "state_to_torque": "WholeBodyController::update() alone",
    "paced": "LowState to LowCmd once per period for one second, sleeping in between",
    "null": "an idle loop as long as a tick: its tail shows the jitter of the machine",
}
NOTE = (
    "Timed in C++, without pauses between LowStates except in paced. Times are wall times; columns "
    "cpu have\nthe CPU time of the thread. Stages are timed in separate passes. Slowest: the "
    "largest median over all passes\nof one LowState; max is mostly due to the machine, and other "
    "processes also lengthen the tail."
)
FAILED = "SOME CALLS FAILED: their times are not times of solved ticks."


def bench_text(b: dict[str, Any]) -> str:
    """Return the figures of a benchmark as text."""
    lines = [f"{b['robot']}, {b['form']} form, {b['rate']:g} Hz", machine_line(b["machine"])]
    for name, scenario in b["scenarios"].items():
        fell = "; the robot falls at the end" if scenario["fell"] else ""
        lines += ["", f"{name}: {scenario['reports']} LowStates{fell}"]
        if scenario["tick"]["walking"]:
            lines.append("  " + _walking(scenario))
        lines += _table([_HEADER, *(_row(row, scenario[row]) for row in ROW_MEANINGS)])
        lines.append("  " + _stages(scenario["stages_wall_us"]))
        lines.append("  " + _first_pass(scenario["tick"]["first_pass"]))
    failed = any(s[row]["failures"] for s in b["scenarios"].values() for row in ROW_MEANINGS)
    return "\n".join([*lines, "", *([FAILED] if failed else []), NOTE])


def machine_line(m: dict[str, Any]) -> str:
    """Return processor, system, versions and build in one line."""
    versions = ", ".join(f"{name} {v}" for name, v in m["versions"].items() if v is not None)
    governor = f"governor {m['governor'] or 'unknown'}"
    parts = [m["cpu"] or "unknown processor", f"{m['cores']} cores", governor]
    build = [m["build"]] if "build" in m else []  # present only if the tick program ran
    if m.get("memory_locked"):
        build.append("memory locked")
    return ", ".join([*parts, m["system"], versions, *build])


_CPU_PERCENTILES = ("p50", "p99", "p99.9", "max")
_HEADER = [
    "[us]",
    "n",
    *PERCENTILES,
    "slowest",
    *(f"cpu {name}" for name in _CPU_PERCENTILES),
    "> 1 ms",
    "iterations",
    "heap",
    "faults",
    "failed",
    "what",
]


def _row(name: str, figures: dict[str, Any]) -> list[str]:
    wall, cpu = figures["wall_us"], figures["cpu_us"]
    counts = {int(k): v for k, v in figures["iterations"].items()}
    mean = sum(k * v for k, v in counts.items()) / sum(counts.values())
    return [
        name,
        str(wall["n"]),
        *(f"{wall[k]:.1f}" for k in PERCENTILES),
        f"{figures['slowest_us']:.1f}",
        *(f"{cpu[k]:.1f}" for k in _CPU_PERCENTILES),
        str(figures["missed"]["1kHz"]),
        f"{mean:.2f}, max {max(counts)}" if max(counts) else "-",
        str(figures["allocations"]),
        str(figures["page_faults"]),
        str(figures["failures"]),
        ROW_MEANINGS[name],
    ]


def _table(rows: list[list[str]]) -> list[str]:
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    lines = []
    for row in rows:
        name, *numbers, what = (
            cell.ljust(width) if k in (0, len(row) - 1) else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        )
        lines.append("  ".join(["  " + name, *numbers, what]).rstrip())
    return lines


def _walking(scenario: dict[str, Any]) -> str:
    tick, ratio = scenario["tick"], scenario["tick_over_quiet"]
    compared = "" if ratio is None else f"; median CPU time {ratio:.2f} of that of quiet"
    return f"the robot steps in {tick['walking']} of {tick['wall_us']['n']} ticks{compared}"


def _first_pass(first: dict[str, int]) -> str:
    return (
        f"first pass, excluded from the figures: heap {first['allocations']}, "
        f"faults {first['page_faults']}"
    )


def _stages(stages: dict[str, dict[str, float]]) -> str:
    parts = (
        f"{name} {times['p50']:.2f} ({times['p99']:.1f}, {times['slowest']:.1f})"
        for name, times in stages.items()
    )
    return "stages p50 (p99, slowest): " + ", ".join(parts)
