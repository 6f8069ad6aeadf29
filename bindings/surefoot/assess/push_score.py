"""Pushes in numbers: per direction, over seeds, against the limits; and the worst direction."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from surefoot.assess.card import Card
from surefoot.assess.condition import Condition
from surefoot.assess.push_limits import Limits
from surefoot.assess.sweep import Sweep, from_rows
from surefoot.assess.unit import PushUnit, push_units

KINDS = {"survive": "survived", "strict": "strict"}
LEAST_SEEDS = 20  # from which on a 5th percentile says more than the minimum
STANDARD = (0.1, 0.0)  # [s] length, [m] height: the push that the summary is about


def statistic(seeds: int) -> str:
    """Return in words what is made of the seeds."""
    if seeds >= LEAST_SEEDS:
        return f"5th percentile of {seeds} seeds"
    return f"minimum of {seeds} seed{'s' if seeds > 1 else ''}"


def low_end(values: list[float]) -> float:
    """Return the 5th percentile of many values, the minimum of few."""
    if len(values) < LEAST_SEEDS:
        return min(values)
    return float(np.percentile(values, 5.0))


def push_section(
    card: Card,
    name: str,
    limits: Limits,
    results: dict[tuple[str, str], dict[str, Any]],
    condition: Condition | None = None,
) -> dict[str, Any]:
    """Return what a contestant's pushes under a condition came to.

    Args:
        card: With the pushes.
        name: Of the contestant.
        limits: Of the robot.
        results: By contestant and key.
        condition: Under which; None for the usual one.
    """
    condition = condition or card.conditions[0]
    groups: dict[tuple[float, float], dict[float, list[PushUnit]]] = {}
    for unit in push_units(card, lambda *of: limits.of(*of).own):
        if unit.condition == condition:
            group = groups.setdefault((unit.duration, unit.lift), {})
            group.setdefault(unit.degrees, []).append(unit)
    tables = [_table(shape, group, limits, name, results) for shape, group in groups.items()]
    main = next((t for t in tables if (t["length_s"], t["height_m"]) == STANDARD), tables[0])
    return {
        "statistic": main["statistic"],
        "survive_percent_of_limit_p5": main["survive_percent_of_limit_p5"],
        "strict_percent_of_limit_p5": main["strict_percent_of_limit_p5"],
        "tables": tables,
        "broken": sorted(
            {text for t in tables for row in t["directions"] for text in row["broken"]}
        ),
    }


def _table(
    shape: tuple[float, float],
    group: dict[float, list[PushUnit]],
    limits: Limits,
    name: str,
    results: dict[tuple[str, str], dict[str, Any]],
) -> dict[str, Any]:
    rows = [
        _row(units, limits, [results[name, unit.key] for unit in units]) for units in group.values()
    ]
    seeds = len(next(iter(group.values())))
    worst = {
        f"{kind}_percent_of_limit_p5": min(row[kind]["percent_of_limit"] for row in rows)
        for kind in KINDS
    }
    length, height = shape
    return {
        "length_s": length,
        "height_m": height,
        "statistic": statistic(seeds),
        **worst,
        "directions": rows,
    }


def _row(units: list[PushUnit], limits: Limits, found: Iterable[dict[str, Any]]) -> dict[str, Any]:
    unit, found = units[0], list(found)
    limit = limits.of(unit.condition, unit.degrees, unit.duration, unit.lift)
    # What broke has survived nothing.
    sweeps = [from_rows(result["rows"]) if "rows" in result else Sweep() for result in found]
    row: dict[str, Any] = {
        "degrees": unit.degrees,
        "limit_ns": limit.own,
        "lip_ns": limit.lip,
        "quasi_static_ns": limit.quasi_static,
        "quasi_static_force_n": limit.quasi_static_force,
        "broken": sorted({result["broken"] for result in found if "broken" in result}),
    }
    for kind, attribute in KINDS.items():
        percents = [one.largest(attribute) for one in sweeps]
        impulse = low_end(percents) / 100.0 * limit.own
        row[kind] = {
            "percent_of_limit": low_end(percents),
            "percent_of_lip": 100.0 * impulse / limit.lip,
            "ns": impulse,
            "ns_per_kg": impulse / limits.pinned.mass,
            "seeds_percent_of_limit": percents,
        }
    return row
