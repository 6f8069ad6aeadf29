"""Results of the quiet stands under a condition: how many passed, and the largest errors."""

from __future__ import annotations

from typing import Any

from surefoot.assess.push_score import UnitResults
from surefoot.assess.work_units import StandUnit


def stand_section(units: list[StandUnit], unit_results: UnitResults) -> dict[str, Any]:
    """Return the stand section of the scorecard for one condition."""
    results = [unit_results[unit.key] for unit in units]
    completed = [result for result in results if "broken" not in result]
    by_heading = {
        f"{heading:g}": _worst([unit_results[u.key] for u in units if u.heading == heading])
        for heading in dict.fromkeys(unit.heading for unit in units)
    }
    return {
        "runs": len(results),
        "passed": sum(result["passed"] for result in completed),
        "stood": sum(result["stood"] for result in completed),
        **_worst(results),
        "headings_deg": by_heading,
        "broken": sorted({result["broken"] for result in results if "broken" in result}),
    }


def _worst(results: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the largest value of each error over all runs; None: no run has a value."""
    names = ("tilt_deg", "height_mm", "foot_mm")
    return {
        name: max((r[name] for r in results if r.get(name) is not None), default=None)
        for name in names
    }
