"""The card filled in: what came of every unit, as plain JSON types."""

from __future__ import annotations

from collections import Counter
from dataclasses import fields
from typing import Any

from surefoot._core import Robot
from surefoot.assess import plan
from surefoot.assess.condition import Condition
from surefoot.assess.push_limits import Limits
from surefoot.assess.push_score import Found, push_section
from surefoot.assess.settings import AssessSettings
from surefoot.assess.stand_score import stand_section
from surefoot.bench.machine import describe_machine
from surefoot.plain import plain

Results = dict[tuple[str, str], dict[str, Any]]
"""What is in the store, by contestant and key."""


def score(
    settings: AssessSettings, robot: Robot, limits: Limits, results: Results
) -> dict[str, Any]:
    """Return the filled card."""
    card, name = settings.card, settings.contestant.name
    found = of_contestant(results, name)
    filled = {
        "robot": robot.name,
        "controller": name,
        "card": card.name,
        "pinned_pose": _pose(robot, limits),
        "push": push_section(plan.pushes(card, limits), limits, found),
        "conditions": [
            _condition(settings, condition, limits, found)
            for condition in card.conditions
            if plan.stands(card, condition) or plan.condition_pushes(card, condition, limits)
        ],
        "faults": _faults(settings, found),
        "references": {
            reference.name: push_section(
                plan.reference_pushes(card, limits), limits, of_contestant(results, reference.name)
            )
            for reference in plan.references(settings)
        },
        "settings": settings.described(robot),
        "versions": describe_machine()["versions"],
    }
    result: dict[str, Any] = plain(filled)
    return result


def of_contestant(results: Results, name: str) -> Found:
    """Return what came of a contestant's units, by key."""
    return {key: result for (who, key), result in results.items() if who == name}


def _pose(robot: Robot, limits: Limits) -> dict[str, Any]:
    pinned = limits.pinned
    return {
        "q_standing": list(robot.config.q_standing),
        "mass_kg": pinned.mass,
        "com_height_m": pinned.height,
        "reach_forward_m": pinned.reach(0.0),
        "reach_lateral_m": pinned.reach(90.0),
    }


def _condition(
    settings: AssessSettings, condition: Condition, limits: Limits, found: Found
) -> dict[str, Any]:
    card = settings.card
    pushed = plan.condition_pushes(card, condition, limits)
    usual = Condition(condition.name)
    changed = {
        field.name: getattr(condition, field.name)
        for field in fields(Condition)
        if getattr(condition, field.name) != getattr(usual, field.name)
    }
    return {
        "name": condition.name,
        "settings": changed,
        "stand": stand_section(plan.stands(card, condition), found),
        "push": push_section(pushed, limits, found) if pushed else None,
    }


def _faults(settings: AssessSettings, found: Found) -> dict[str, Any] | None:
    """Return the matrix of faults in brief; None where none was run."""
    cells = {unit.cell: found[unit.key] for unit in plan.faults(settings)}
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
