"""The plan: a card's units, in the order in which they are run."""

from __future__ import annotations

from collections.abc import Iterator

from surefoot.assess.card import STANDARD, Card
from surefoot.assess.condition import Condition
from surefoot.assess.contestant import REFERENCES, Contestant
from surefoot.assess.fault_unit import FaultUnit
from surefoot.assess.push_limits import Limits
from surefoot.assess.settings import AssessSettings
from surefoot.assess.sweep import FINEST, first_level
from surefoot.assess.unit import PushUnit, StandUnit
from surefoot.assess.worker import Work
from surefoot.faults import choose_cells

OTHER_FINEST = 5.0  # [%] step of sweeps that are not STANDARD, which are most of a full card
BRIEF = ("*/standing",)  # cells of the matrix of faults in brief


def works(settings: AssessSettings, limits: Limits) -> Iterator[Work]:
    """Yield everything that an assessment runs: pushes, conditions, faults, references."""
    card, contestant = settings.card, settings.contestant
    for unit in pushes(card, limits):
        yield Work(unit, contestant)
    for condition in card.conditions:
        for stand in stands(card, condition):
            yield Work(stand, contestant)
        for unit in condition_pushes(card, condition, limits):
            yield Work(unit, contestant)
    for fault in faults(settings):
        yield Work(fault, contestant)
    for reference in references(settings):
        for unit in reference_pushes(card, limits):
            yield Work(unit, reference)


def pushes(card: Card, limits: Limits) -> list[PushUnit]:
    """Return the pushes under the usual condition."""
    return [
        unit
        for duration in card.lengths_s
        for lift in card.heights_m
        for unit in _around(
            card.conditions[0], card.degrees, duration, lift, card.drawn(card.seeds), limits
        )
    ]


def condition_pushes(card: Card, condition: Condition, limits: Limits) -> list[PushUnit]:
    """Return the pushes under a further condition, if there are any."""
    if not condition.pushes or condition == card.conditions[0]:
        return []
    seeds = card.drawn(card.condition_seeds)
    return _around(condition, card.condition_degrees, *STANDARD, seeds, limits)


def reference_pushes(card: Card, limits: Limits) -> list[PushUnit]:
    """Return the pushes that reference controllers get: those that the summary is about."""
    return _around(card.conditions[0], card.degrees, *card.main, card.drawn(card.seeds), limits)


def stands(card: Card, condition: Condition) -> list[StandUnit]:
    """Return the quiet stands under a condition."""
    return [
        StandUnit(condition, heading, seed)
        for heading in condition.headings_deg
        for seed in card.drawn(card.condition_seeds)
    ]


def faults(settings: AssessSettings) -> list[FaultUnit]:
    """Return the cells of the matrix of faults; they are about the Supervisor of "surefoot"."""
    if settings.card.faults == "none" or settings.contestant.name != "surefoot":
        return []
    patterns = BRIEF if settings.card.faults == "brief" else ()
    return [FaultUnit(cell.id) for cell in choose_cells(patterns)]


def references(settings: AssessSettings) -> list[Contestant]:
    """Return who else is pushed."""
    if not settings.card.references:
        return []
    return [Contestant(name) for name in REFERENCES if name != settings.contestant.name]


def _around(
    condition: Condition,
    degrees: list[float],
    duration: float,
    lift: float,
    seeds: range,
    limits: Limits,
) -> list[PushUnit]:
    finest = FINEST if (duration, lift) == STANDARD else OTHER_FINEST
    limit = {angle: limits.of(condition, angle, duration, lift).own for angle in degrees}
    return [
        PushUnit(condition, angle, duration, lift, seed, limit[angle], first_level(turn), finest)
        for angle in degrees
        for turn, seed in enumerate(seeds)
    ]
