"""Filled scorecard: the results of all units as JSON values."""

from __future__ import annotations

from collections import Counter
from dataclasses import fields
from typing import Any

from surefoot._core import Robot
from surefoot.assess import plan
from surefoot.assess.condition import Condition
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_score import UnitResults, push_section
from surefoot.assess.settings import AssessSettings
from surefoot.assess.stand_score import stand_section
from surefoot.files.json_values import json_value
from surefoot.system.machine import describe_machine

StoredResults = dict[tuple[str, str], dict[str, Any]]
"""Results of all units in the store, by controller name and unit key."""


def score(
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
    card, name = settings.stand_card, settings.controller_under_test.name
    unit_results = controller_results(results, name)
    filled = {
        "robot": robot.name,
        "controller": name,
        "card": card.name,
        "pinned_pose": _stance_result(robot, limits),
        "push": push_section(plan.push_units(card, limits), limits, unit_results),
        "conditions": [
            _condition_result(settings, condition, limits, unit_results)
            for condition in card.conditions
            if plan.stand_units(card, condition)
            or plan.condition_push_units(card, condition, limits)
        ],
        "faults": _fault_result(settings, unit_results),
        "references": {
            reference.name: push_section(
                plan.reference_push_units(card, limits),
                limits,
                controller_results(results, reference.name),
            )
            for reference in plan.reference_controllers(settings)
        },
        "foreign_plant": foreign_plant,
        "settings": settings.to_dict(robot),
        "versions": describe_machine()["versions"],
    }
    result: dict[str, Any] = json_value(filled)
    return result


def controller_results(results: StoredResults, name: str) -> UnitResults:
    """Return the results of one controller, by unit key."""
    return {key: result for (controller, key), result in results.items() if controller == name}


def _stance_result(robot: Robot, limits: PushLimits) -> dict[str, Any]:
    stance = limits.stance
    return {
        "q_standing": list(robot.config.q_standing),
        "mass_kg": stance.mass,
        "com_height_m": stance.height,
        "reach_forward_m": stance.edge_distance(0.0),
        "reach_lateral_m": stance.edge_distance(90.0),
    }


def _condition_result(
    settings: AssessSettings, condition: Condition, limits: PushLimits, unit_results: UnitResults
) -> dict[str, Any]:
    card = settings.stand_card
    push_units = plan.condition_push_units(card, condition, limits)
    nominal = Condition(condition.name)
    changed_fields = {
        field.name: getattr(condition, field.name)
        for field in fields(Condition)
        if getattr(condition, field.name) != getattr(nominal, field.name)
    }
    return {
        "name": condition.name,
        "settings": changed_fields,
        "stand": stand_section(plan.stand_units(card, condition), unit_results),
        "push": push_section(push_units, limits, unit_results) if push_units else None,
    }


def _fault_result(settings: AssessSettings, unit_results: UnitResults) -> dict[str, Any] | None:
    """Return the summary of the fault matrix; None if the scorecard runs no cell."""
    cells = {unit.cell: unit_results[unit.key] for unit in plan.fault_units(settings)}
    if not cells:
        return None
    failures = {
        cell: result.get("reason") or result.get("broken")
        for cell, result in cells.items()
        if result.get("verdict") != "pass"
    }
    rows = Counter(cell.partition("/")[0] for cell in cells)
    failed = Counter(cell.partition("/")[0] for cell in failures)
    return {
        "passed": len(cells) - len(failures),
        "failed": len(failures),
        "rows": {row: {"cells": rows[row], "failed": failed[row]} for row in rows},
        "failures": failures,
    }
