"""Push results of a condition: statistics over seeds by direction, and the worst direction."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from surefoot.assess.push_limits import PushLimits
from surefoot.assess.scorecard import summary_push
from surefoot.assess.sweep import Sweep, rows_to_sweep
from surefoot.assess.work_units import PushUnit

CRITERIA = {"survive": "survived", "strict": "in_place"}
# Smallest number of seeds for a 5th percentile; for fewer seeds the statistic is the minimum.
# Derived: 1 / 0.05, so that one seed is 5 % of the seeds.
MIN_PERCENTILE_SEEDS = 20

UnitResults = Mapping[str, dict[str, Any]]
"""Results of the units of one controller, by unit key."""


def push_section(
    units: list[PushUnit], limits: PushLimits, unit_results: UnitResults
) -> dict[str, Any]:
    """Return the push section of the scorecard for one condition.

    Args:
        units: Push units, ordered by duration and height, then direction, then seed.
        limits: Push limits of the robot.
        unit_results: Results of the units, by key.
    """
    groups: dict[tuple[float, float], dict[float, list[PushUnit]]] = {}
    for unit in units:
        group = groups.setdefault((unit.duration, unit.push_height), {})
        group.setdefault(unit.direction_deg, []).append(unit)
    tables = [_table(shape, group, limits, unit_results) for shape, group in groups.items()]
    main = summary_table(tables)
    return {
        "statistic": main["statistic"],
        "survive_percent_of_limit_p5": main["survive_percent_of_limit_p5"],
        "strict_percent_of_limit_p5": main["strict_percent_of_limit_p5"],
        "broken": sorted({why for t in tables for row in t["directions"] for why in row["broken"]}),
        "tables": tables,
    }


def summary_table(tables: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the table of the pushes that the summary uses."""
    shapes = [(table["length_s"], table["height_m"]) for table in tables]
    return tables[shapes.index(summary_push(shapes))]


def statistic(seeds: int) -> str:
    """Return the name of the statistic that low_percentile() computes over a number of seeds."""
    if seeds >= MIN_PERCENTILE_SEEDS:
        return f"5th percentile of {seeds} seeds"
    return f"minimum of {seeds} seeds" if seeds > 1 else "1 seed"


def low_percentile(values: list[float]) -> float:
    """Return the 5th percentile; the minimum if there are fewer than MIN_PERCENTILE_SEEDS."""
    return float(np.percentile(values, 5.0)) if len(values) >= MIN_PERCENTILE_SEEDS else min(values)


def _table(
    shape: tuple[float, float],
    group: dict[float, list[PushUnit]],
    limits: PushLimits,
    unit_results: UnitResults,
) -> dict[str, Any]:
    rows = [_row(units, limits, unit_results) for units in group.values()]
    worst = {
        f"{kind}_percent_of_limit_p5": min(row[kind]["percent_of_limit"] for row in rows)
        for kind in CRITERIA
    }
    length, height = shape
    units = next(iter(group.values()))
    return {
        "length_s": length,
        "height_m": height,
        "statistic": statistic(len(units)),
        "step_percent": units[0].finest_step,
        **worst,
        "directions": rows,
    }


def _row(units: list[PushUnit], limits: PushLimits, unit_results: UnitResults) -> dict[str, Any]:
    unit = units[0]
    limit = limits.push_limit(unit.condition, unit.direction_deg, unit.duration, unit.push_height)
    results = [unit_results[one.key] for one in units]
    # A unit without a sweep counts as a unit that survived no push.
    sweeps = [rows_to_sweep(result["rows"]) if "rows" in result else Sweep() for result in results]
    row: dict[str, Any] = {
        "degrees": unit.direction_deg,
        "limit_ns": limit.limit,
        "lip_ns": limit.lip,
        "quasi_static_ns": limit.quasi_static,
        "quasi_static_force_n": limit.quasi_static_force,
        "broken": sorted({result["broken"] for result in results if "broken" in result}),
    }
    for kind, attribute in CRITERIA.items():
        percents = [one.largest_passed(attribute) for one in sweeps]
        impulse = low_percentile(percents) / 100.0 * limit.limit
        row[kind] = {
            "percent_of_limit": low_percentile(percents),
            "percent_of_lip": 100.0 * impulse / limit.lip,
            "ns": impulse,
            "ns_per_kg": impulse / limits.true_mass(unit.condition),
            "seeds_percent_of_limit": percents,
        }
    return row
