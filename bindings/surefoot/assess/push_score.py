"""Pushes in numbers: per direction, over seeds, against the limits; and the worst direction."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from surefoot.assess.card import main_push
from surefoot.assess.push_limits import Limits
from surefoot.assess.sweep import Sweep, from_rows
from surefoot.assess.unit import PushUnit

KINDS = {"survive": "survived", "strict": "strict"}
MANY = 20  # seeds from which on a 5th percentile says more than the minimum

Found = Mapping[str, dict[str, Any]]
"""What came of one contestant's units, by key."""


def push_section(units: list[PushUnit], limits: Limits, found: Found) -> dict[str, Any]:
    """Return what pushes of one condition came to.

    Args:
        units: One after the other: lengths and heights, directions, seeds.
        limits: Of the robot.
        found: By key.
    """
    groups: dict[tuple[float, float], dict[float, list[PushUnit]]] = {}
    for unit in units:
        group = groups.setdefault((unit.duration, unit.lift), {})
        group.setdefault(unit.degrees, []).append(unit)
    tables = [_table(shape, group, limits, found) for shape, group in groups.items()]
    main = main_table(tables)
    return {
        "statistic": main["statistic"],
        "survive_percent_of_limit_p5": main["survive_percent_of_limit_p5"],
        "strict_percent_of_limit_p5": main["strict_percent_of_limit_p5"],
        "broken": sorted({why for t in tables for row in t["directions"] for why in row["broken"]}),
        "tables": tables,
    }


def main_table(tables: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the table of the pushes that the summary is about."""
    shapes = [(table["length_s"], table["height_m"]) for table in tables]
    return tables[shapes.index(main_push(shapes))]


def statistic(seeds: int) -> str:
    """Return in words what is made of the seeds."""
    if seeds >= MANY:
        return f"5th percentile of {seeds} seeds"
    return f"minimum of {seeds} seeds" if seeds > 1 else "1 seed"


def low_end(values: list[float]) -> float:
    """Return the 5th percentile of many values, the minimum of few."""
    return float(np.percentile(values, 5.0)) if len(values) >= MANY else min(values)


def _table(
    shape: tuple[float, float], group: dict[float, list[PushUnit]], limits: Limits, found: Found
) -> dict[str, Any]:
    rows = [_row(units, limits, found) for units in group.values()]
    worst = {
        f"{kind}_percent_of_limit_p5": min(row[kind]["percent_of_limit"] for row in rows)
        for kind in KINDS
    }
    length, height = shape
    units = next(iter(group.values()))
    return {
        "length_s": length,
        "height_m": height,
        "statistic": statistic(len(units)),
        "step_percent": units[0].finest,
        **worst,
        "directions": rows,
    }


def _row(units: list[PushUnit], limits: Limits, found: Found) -> dict[str, Any]:
    unit = units[0]
    limit = limits.of(unit.condition, unit.degrees, unit.duration, unit.lift)
    results = [found[one.key] for one in units]
    # What has no sweep has survived nothing.
    sweeps = [from_rows(result["rows"]) if "rows" in result else Sweep() for result in results]
    row: dict[str, Any] = {
        "degrees": unit.degrees,
        "limit_ns": limit.own,
        "lip_ns": limit.lip,
        "quasi_static_ns": limit.quasi_static,
        "quasi_static_force_n": limit.quasi_static_force,
        "broken": sorted({result["broken"] for result in results if "broken" in result}),
    }
    for kind, attribute in KINDS.items():
        percents = [one.largest(attribute) for one in sweeps]
        impulse = low_end(percents) / 100.0 * limit.own
        row[kind] = {
            "percent_of_limit": low_end(percents),
            "percent_of_lip": 100.0 * impulse / limit.lip,
            "ns": impulse,
            "ns_per_kg": impulse / limits.mass(unit.condition),
            "seeds_percent_of_limit": percents,
        }
    return row
