"""Results of the solver comparison as a table of text."""

from __future__ import annotations

from typing import Any

from surefoot.bench.result_text import machine_line

HEADER: tuple[str, ...] = (
    "[us]",
    "start",
    "p50",
    "p99",
    "max",
    "cpu p50",
    "cpu p99",
    "iterations",
    "mallocs",
    "failed",
    "no status",
    "wrong",
    "undetected",
    "interface",
)
NOTE = (
    "Times of one solve, with all conversions that the format of the solver requires. failed: the "
    "solver reports a failure,\nor crashed. wrong: primal residual, dual residual or "
    "complementarity of the answer above {accepted:g}; the benchmark\ncomputes them in the same "
    "way for all solvers. undetected: reported as solved but wrong. cpu: CPU time of the\nthread, "
    "which includes the reading of the clock. interface: language of the API that is called."
)


def solvers_text(result: dict[str, Any]) -> str:
    """Return the result of run_solvers() as text."""
    parts = [machine_line(result["machine"])]
    reasons: dict[str, None] = {}
    for name, sequence in result["sequences"].items():
        rows = [HEADER]
        entries = {"(nothing)": sequence["baseline"], **sequence["solvers"]}
        for solver, entry in entries.items():
            for mode in ("warm", "cold"):
                _add_rows(rows, reasons, solver, mode, entry)
        title = (
            f"{name}: {sequence['ticks']} QPs, {sequence['variables']} variables, "
            f"{sequence['equalities']} equalities, {sequence['inequalities']} two-sided constraints"
        )
        parts += ["", title, *_align(rows)]
    return "\n".join([*parts, "", NOTE.format(**result), *reasons])


def _add_rows(
    rows: list[tuple[str, ...]],
    reasons: dict[str, None],
    solver: str,
    mode: str,
    entry: dict[str, Any],
) -> None:
    if entry.get("reason"):
        reasons[f"{solver}: {entry['reason']}"] = None
        return
    mode_statistics = entry[mode]
    if mode_statistics["reason"]:
        reasons[f"{solver} {mode}: {mode_statistics['reason']}"] = None
    if "n" in mode_statistics:
        rows.append(_row(solver, mode, entry, mode_statistics, is_baseline=solver == "(nothing)"))


def _row(
    solver: str,
    mode: str,
    entry: dict[str, Any],
    mode_statistics: dict[str, Any],
    is_baseline: bool,
) -> tuple[str, ...]:
    wall, cpu = mode_statistics["wall_us"], mode_statistics["cpu_us"]
    times = [wall["p50"], wall["p99"], wall["max"], cpu["p50"], cpu["p99"]]
    numbers = ["-" if value is None else f"{value:.2f}" for value in times]
    if is_baseline:
        return (solver, mode, *numbers, *["-"] * 6, entry["interface"])
    counts = ("failures", "no_status", "wrong", "said_solved_but_wrong")
    steps, mallocs = mode_statistics["iterations"]["mean"], mode_statistics["allocations"]["mean"]
    return (
        solver,
        mode,
        *numbers,
        "-" if steps is None else f"{steps:.1f}",
        "-" if mallocs is None else f"{mallocs:.1f}",
        *(str(mode_statistics[name]) for name in counts),
        entry["interface"],
    )


def _align(rows: list[tuple[str, ...]]) -> list[str]:
    widths = [max(len(row[k]) for row in rows) for k in range(len(HEADER))]
    ends = (0, 1, len(HEADER) - 1)
    return [
        "  ".join(
            cell.ljust(width) if k in ends else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    ]
