"""Plan of an assessment: the units of work of a scorecard, in the order in which they run."""

from __future__ import annotations

from collections.abc import Iterator

from surefoot.assess.condition import Condition
from surefoot.assess.controller_under_test import REFERENCE_CONTROLLERS, ControllerUnderTest
from surefoot.assess.fault_unit import FaultUnit
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.scorecard import STANDARD_PUSH, Scorecard
from surefoot.assess.settings import AssessSettings
from surefoot.assess.sweep import FINEST_STEP, first_level
from surefoot.assess.work_units import PushUnit, StandUnit
from surefoot.assess.worker import WorkItem
from surefoot.faults import choose_cells

# [% of the push limit] Finest step of the sweeps of all pushes other than STANDARD_PUSH. Chosen:
# coarser than FINEST_STEP, because most sweeps of a full scorecard are of this kind, and a finer
# step takes more runs.
OTHER_FINEST_STEP = 5.0
BRIEF_CELLS = ("*/standing",)  # patterns of the fault matrix cells that faults = "brief" runs


def planned_work(settings: AssessSettings, limits: PushLimits) -> Iterator[WorkItem]:
    """Yield all work of an assessment: pushes, conditions, faults, reference controllers."""
    card, controller_under_test = settings.stand_card, settings.controller_under_test
    for unit in push_units(card, limits):
        yield WorkItem(unit, controller_under_test)
    for condition in card.conditions:
        for stand in stand_units(card, condition):
            yield WorkItem(stand, controller_under_test)
        for unit in condition_push_units(card, condition, limits):
            yield WorkItem(unit, controller_under_test)
    for fault in fault_units(settings):
        yield WorkItem(fault, controller_under_test)
    for reference in reference_controllers(settings):
        for unit in reference_push_units(card, limits):
            yield WorkItem(unit, reference)


def push_units(card: Scorecard, limits: PushLimits) -> list[PushUnit]:
    """Return the pushes under the nominal condition."""
    return [
        unit
        for duration in card.lengths_s
        for push_height in card.heights_m
        for unit in _push_units_around(
            card.conditions[0],
            card.directions_deg,
            duration,
            push_height,
            card.seed_range(card.seeds),
            limits,
        )
    ]


def condition_push_units(
    card: Scorecard, condition: Condition, limits: PushLimits
) -> list[PushUnit]:
    """Return the pushes under a further condition; empty if the condition has no pushes."""
    if not condition.pushes or condition == card.conditions[0]:
        return []
    seeds = card.seed_range(card.condition_seeds)
    return _push_units_around(
        condition, card.condition_directions_deg, *STANDARD_PUSH, seeds, limits
    )


def reference_push_units(card: Scorecard, limits: PushLimits) -> list[PushUnit]:
    """Return the pushes of each reference controller: only the pushes that the summary uses."""
    return _push_units_around(
        card.conditions[0],
        card.directions_deg,
        *card.summary_push,
        card.seed_range(card.seeds),
        limits,
    )


def stand_units(card: Scorecard, condition: Condition) -> list[StandUnit]:
    """Return the quiet stands under a condition."""
    return [
        StandUnit(condition, heading, seed)
        for heading in condition.headings_deg
        for seed in card.seed_range(card.condition_seeds)
    ]


def fault_units(settings: AssessSettings) -> list[FaultUnit]:
    """Return the fault matrix cells; empty for other controllers than "surefoot".

    The cells test the Supervisor, which only "surefoot" has.
    """
    if settings.stand_card.faults == "none" or settings.controller_under_test.name != "surefoot":
        return []
    patterns = BRIEF_CELLS if settings.stand_card.faults == "brief" else ()
    return [FaultUnit(cell.id) for cell in choose_cells(patterns)]


def reference_controllers(settings: AssessSettings) -> list[ControllerUnderTest]:
    """Return the reference controllers of the scorecard, except the controller under test."""
    if not settings.stand_card.references:
        return []
    return [
        ControllerUnderTest(name)
        for name in REFERENCE_CONTROLLERS
        if name != settings.controller_under_test.name
    ]


def _push_units_around(
    condition: Condition,
    directions_deg: list[float],
    duration: float,
    push_height: float,
    seeds: range,
    limits: PushLimits,
) -> list[PushUnit]:
    finest_step = FINEST_STEP if (duration, push_height) == STANDARD_PUSH else OTHER_FINEST_STEP
    limit_by_direction = {
        angle: limits.push_limit(condition, angle, duration, push_height).limit
        for angle in directions_deg
    }
    return [
        PushUnit(
            condition,
            angle,
            duration,
            push_height,
            seed,
            limit_by_direction[angle],
            first_level(seed_index),
            finest_step,
        )
        for angle in directions_deg
        for seed_index, seed in enumerate(seeds)
    ]
