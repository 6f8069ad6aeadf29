"""Filled scorecard of walks: the results of all units as JSON values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from typing import Any

import numpy as np

from surefoot._core import Robot
from surefoot.assess.condition import Condition
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_score import UnitResults, low_percentile, statistic
from surefoot.assess.score import StoredResults, controller_results
from surefoot.assess.settings import AssessSettings
from surefoot.assess.walking import walk_plan
from surefoot.assess.walking.walk_scorecard import Velocity
from surefoot.assess.walking.walk_units import WalkPushUnit, WalkUnit
from surefoot.files.json_values import json_value
from surefoot.system.machine import describe_machine

FIGURES = (
    *("velocity_mean_error", "velocity_rmse", "roll_pitch_rms_deg", "cost_of_transport"),
    *("slip_mm_per_step", "touchdown_force_mg", "torque_hf_rms", "saturated_percent"),
    *("leg_contacts", "peak_power_w", "stance_error_mm"),
)
"""Figures of a walk of which the scorecard has the worst over the seeds, each axis for itself."""


def walk_score(
    settings: AssessSettings,
    robot: Robot,
    limits: PushLimits,
    results: StoredResults,
    foreign_plant: dict[str, Any] | None = None,
) -> dict[str, Any]:
    """Return the filled scorecard as JSON values.

    Args:
        settings: Settings of the assessment.
        robot: Model of the robot.
        limits: Push limits of the model.
        results: Results of all units.
        foreign_plant: Section of the foreign plant; None: there is no MJCF.
    """
    card, name = settings.walk_card, settings.controller_under_test.name
    unit_results = controller_results(results, name)
    filled = {
        "robot": robot.name,
        "controller": name,
        "card": card.name,
        "lip_limit_ns": _lip_limits(settings, limits),
        "walk": walk_section(settings, limits, unit_results),
        "conditions": [
            {
                "name": condition.name,
                "settings": _changed(condition),
                **_walks_row(walk_plan.condition_units(card, condition), unit_results),
            }
            for condition in (card.conditions[1:] if card.condition_seeds else ())
        ],
        "references": {
            reference.name: walk_section(
                settings, limits, controller_results(results, reference.name)
            )
            for reference in walk_plan.walking_references(settings)
        },
        "foreign_plant": foreign_plant,
        "settings": settings.to_dict(robot),
        "versions": describe_machine()["versions"],
    }
    result: dict[str, Any] = json_value(filled)
    return result


def walk_section(
    settings: AssessSettings, limits: PushLimits, unit_results: UnitResults
) -> dict[str, Any]:
    """Return the walks and pushes of one controller under the nominal condition."""
    card = settings.walk_card
    return {
        "velocities": [
            {
                "velocity": velocity,
                **_walks_row(walk_plan.velocity_units(card, velocity), unit_results),
            }
            for velocity in card.velocities
        ],
        "pushes": [
            _push_table(velocity, walk_plan.push_units(card, velocity, limits), unit_results)
            for velocity in card.push_velocities
        ],
    }


def _walks_row(units: Sequence[WalkUnit], unit_results: UnitResults) -> dict[str, Any]:
    results = [unit_results[unit.key] for unit in units]
    walks = [result for result in results if "fell" in result]
    return {
        "runs": len(results),
        "walked": sum(not walk["fell"] for walk in walks),
        "stood_at_end": sum(walk["stands_at_end"] for walk in walks),
        "broken": _broken(results),
        **{name: _worst([walk[name] for walk in walks]) for name in FIGURES},
    }


def _worst(values: list[Any]) -> Any:
    known = [value for value in values if value is not None]
    return np.max(known, axis=0) if known else None


def _push_table(
    velocity: Velocity, units: Sequence[WalkPushUnit], unit_results: UnitResults
) -> dict[str, Any]:
    groups: dict[float, list[WalkPushUnit]] = {}
    for unit in units:
        groups.setdefault(unit.direction_deg, []).append(unit)
    rows = [_push_row(degrees, group, unit_results) for degrees, group in groups.items()]
    return {
        "velocity": velocity,
        "statistic": statistic(len(next(iter(groups.values())))),
        "survive_percent_of_lip_p5": min(row["percent_of_lip"] for row in rows),
        "directions": rows,
    }


def _push_row(
    degrees: float, units: Sequence[WalkPushUnit], unit_results: UnitResults
) -> dict[str, Any]:
    results = [unit_results[unit.key] for unit in units]
    # A unit without a sweep counts as a unit that survived no push.
    percents = [result.get("percent_of_lip", 0.0) for result in results]
    percent = low_percentile(percents)
    return {
        "degrees": degrees,
        "lip_ns": units[0].limit,
        "percent_of_lip": percent,
        "ns": percent / 100.0 * units[0].limit,
        "seeds_percent_of_lip": percents,
        "broken": _broken(results),
    }


def _broken(results: list[dict[str, Any]]) -> list[str]:
    return sorted({result["broken"] for result in results if "broken" in result})


def _changed(condition: Condition) -> dict[str, Any]:
    nominal = Condition(condition.name)
    return {
        field.name: getattr(condition, field.name)
        for field in fields(Condition)
        if getattr(condition, field.name) != getattr(nominal, field.name)
    }


def _lip_limits(settings: AssessSettings, limits: PushLimits) -> dict[str, float]:
    nominal = settings.walk_card.conditions[0]
    directions = {"forward": 0.0, "lateral": 90.0}
    return {
        name: limits.push_limit(nominal, degrees, 0.1, 0.0).lip
        for name, degrees in directions.items()
    }
