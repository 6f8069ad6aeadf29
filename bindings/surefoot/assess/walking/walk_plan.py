"""Plan of an assessment of walking: its units of work, in the order in which they run."""

from __future__ import annotations

from collections.abc import Iterator

from surefoot.assess.condition import Condition
from surefoot.assess.controller_under_test import WALKING_REFERENCES, ControllerUnderTest
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.settings import AssessSettings
from surefoot.assess.sweep import first_level
from surefoot.assess.walking.walk_scorecard import Velocity, WalkScorecard
from surefoot.assess.walking.walk_units import PHASES, PUSH_DURATION, WalkPushUnit, WalkUnit
from surefoot.assess.worker import WorkItem


def planned_walks(settings: AssessSettings, limits: PushLimits) -> Iterator[WorkItem]:
    """Yield all work: velocities, pushes, conditions, and the nominal part of the references."""
    card, under_test = settings.walk_card, settings.controller_under_test
    for one in (under_test, *walking_references(settings)):
        for velocity in card.velocities:
            for walk in velocity_units(card, velocity):
                yield WorkItem(walk, one)
        for velocity in card.push_velocities:
            for push in push_units(card, velocity, limits):
                yield WorkItem(push, one)
    for condition in card.conditions[1:]:
        for walk in condition_units(card, condition):
            yield WorkItem(walk, under_test)


def velocity_units(card: WalkScorecard, velocity: Velocity) -> list[WalkUnit]:
    """Return the walks with one velocity under the nominal condition."""
    nominal = card.conditions[0]
    return [
        WalkUnit(nominal, nominal.headings_deg[0], velocity, card.walk_s, seed)
        for seed in card.seed_range(card.seeds)
    ]


def condition_units(card: WalkScorecard, condition: Condition) -> list[WalkUnit]:
    """Return the walks under a further condition."""
    return [
        WalkUnit(condition, heading, card.condition_velocity, card.walk_s, seed)
        for heading in condition.headings_deg
        for seed in card.seed_range(card.condition_seeds)
    ]


def push_units(card: WalkScorecard, velocity: Velocity, limits: PushLimits) -> list[WalkPushUnit]:
    """Return the pushes at one velocity, ordered by direction, then seed."""
    nominal = card.conditions[0]
    return [
        WalkPushUnit(
            nominal,
            velocity,
            degrees,
            seed,
            index % PHASES,
            limits.push_limit(nominal, degrees, PUSH_DURATION, 0.0).lip,
            first_level(index),
        )
        for degrees in card.push_directions_deg
        for index, seed in enumerate(card.seed_range(card.push_seeds))
    ]


def walking_references(settings: AssessSettings) -> list[ControllerUnderTest]:
    """Return the reference controllers of the scorecard, except the controller under test."""
    if not settings.walk_card.references:
        return []
    return [
        ControllerUnderTest(name, walks=True)
        for name in WALKING_REFERENCES
        if name != settings.controller_under_test.name
    ]
