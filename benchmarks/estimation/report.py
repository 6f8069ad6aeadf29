"""Results as rows: robot, case, figure, limit, value, pass or miss, worst seed."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from estimation.consistency import within_band
from estimation.evaluation import Task
from estimation.metrics import Result, find_metric

HEADER = ("robot", "case", "figure", "limit", "got", "unit", "", "worst", "of seed")


@dataclass(frozen=True)
class Row:
    """One figure of one robot; `passed` is None if the figure has no limit."""

    robot: str
    case: str
    figure: str
    asked: str
    got: float
    unit: str
    passed: bool | None
    worst: float | None
    worst_seed: int | None
    seeds: int

    def cells(self) -> tuple[str, ...]:
        """Return the cells of the row as text."""
        got = "none" if math.isnan(self.got) else f"{self.got:.4g}"
        verdict = {True: "pass", False: "MISS", None: ""}[self.passed]
        worst = "" if self.worst is None else f"{self.worst:.4g}"
        seed = "" if self.worst_seed is None else str(self.worst_seed)
        labels = self.robot, self.case, self.figure, self.asked
        return (*labels, got, self.unit, verdict, worst, seed)

    def json(self) -> dict[str, Any]:
        """Return the row as JSON values."""
        return {
            **self.__dict__,
            "got": _finite_or_none(self.got),
            "worst": _finite_or_none(self.worst),
        }


def summarise(results: Iterable[tuple[Task, Result]]) -> list[Row]:
    """Return a row for every robot, case and figure."""
    groups: dict[tuple[str, str], dict[int, Result]] = {}
    for task, result in results:
        groups.setdefault((task.robot, task.case), {})[task.seed] = result
    rows = []
    for (robot, case), seeds in sorted(groups.items()):
        names = list(dict.fromkeys(name for result in seeds.values() for name in result.values))
        for name in names:
            values = {seed: r.values[name] for seed, r in seeds.items() if name in r.values}
            got, seed, worst = find_metric(case, name).merge(values)
            rows.append(_row(robot, case, name, len(values), got, worst, seed))
        for name, got in _consistency(seeds).items():
            rows.append(_row(robot, case, name, len(seeds), got))
    return rows


def _consistency(seeds: dict[int, Result]) -> dict[str, float]:
    all_series = [result.series for result in seeds.values() if result.series]
    out = {}
    for name in ("NIS", "NEES") if all_series else ():
        squares = [series[name] for series in all_series]
        dofs = [series[f"{name} dof"] for series in all_series]
        out[f"{name} in band"], out[f"{name} mean"] = within_band(squares, dofs)
    return out


def _row(
    robot: str,
    case: str,
    name: str,
    seeds: int,
    got: float,
    worst: float | None = None,
    worst_seed: int | None = None,
) -> Row:
    metric = find_metric(case, name)
    verdict = metric.passes(got)
    leading_cells = robot, case, name, metric.limit_text, got, metric.unit, verdict
    return Row(*leading_cells, worst, worst_seed, seeds)


def _finite_or_none(value: float | None) -> float | None:
    return float(f"{value:.6g}") if value is not None and math.isfinite(value) else None


def table(rows: list[Row]) -> str:
    """Return the rows as a text table."""
    lines = [HEADER, *(row.cells() for row in rows)]
    widths = [max(len(line[k]) for line in lines) for k in range(len(HEADER))]
    text = [
        "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip()
        for line in lines
    ]
    misses = sum(row.passed is False for row in rows)
    passes = sum(row.passed is True for row in rows)
    return "\n".join([*text, f"{passes} pass, {misses} miss"])
