"""What a robot does after a fault has begun, until it has done what is expected of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot._core import FaultId, Mode, RequestStatus
from surefoot.faults.expectation import TIME_TOLERANCE, Expectation, Reaction
from surefoot.faults.matrix.command_monitor import is_damping
from surefoot.faults.matrix.reach_mode import RISE_TIME
from surefoot.faults.matrix.scenario import PERIOD, Scenario
from surefoot.sim.truth import has_fallen

SETTLED_TIME = 0.6  # [s] that a latched damping, and a rest, are looked at
STAND_TIME = 3.0  # [s] that standing is looked at, and waited for a fall
LIE_TIME = 1.2  # [s] of lying
SIT_TIME = 9.0  # [s] that sitting down may take


@dataclass
class Observation:
    """What was seen; times since the fault was there to be seen [s], None for never.

    Attributes:
        damped_at: When the motors damped first.
        torque_resumed_at: When they had torques again after that.
        sat_at: When it began to sit down, or let go on its way up.
        passive_at: When it lay, motors damping, not latched.
        stood_at: When it stood first.
        fell_at: When, while standing, something but a foot touched the ground, or it tilted beyond 60
            degrees.
        refused_at: When arming and rising were refused first; asked in every period from the time
            stated on.
        accepted_at: When one of them was accepted; then it is asked no more.
        mode: At the end.
        max_descent_speed: Greatest speed of the body downwards [m/s].
        min_height: Of the body's height [m].
        max_rise: Greatest height of the body above the lowest before it [m].
        duration: Seen for so long.
        reported_at: When the fault expected was told.
        latch_reason: Name of the fault that the damping latched for.
        answers: What a request to rise and one to arm were told last.
    """

    damped_at: float | None = None
    torque_resumed_at: float | None = None
    sat_at: float | None = None
    passive_at: float | None = None
    stood_at: float | None = None
    fell_at: float | None = None
    refused_at: float | None = None
    accepted_at: float | None = None
    mode: Mode = Mode.PASSIVE
    max_descent_speed: float = 0.0
    min_height: float = math.inf
    max_rise: float = 0.0
    duration: float = 0.0
    reported_at: float | None = None
    latch_reason: str = ""
    answers: str = ""


def observe(scenario: Scenario, expectation: Expectation, mode: str) -> Observation:
    """Go on with a scene whose fault begins now, for as long as the expectation needs."""
    observed, periods = Observation(), 0
    refuses = expectation.reaction == Reaction.REFUSE and mode == "lying"
    scenario.begin()
    count = _fault_count(scenario, expectation)
    for k in range(round(_max_duration(expectation, mode) / PERIOD)):
        due = k * PERIOD >= expectation.within - TIME_TOLERANCE or not scenario.armed
        if refuses and due and observed.accepted_at is None:
            _request_rise(scenario, observed, k * PERIOD)
        scenario.step()
        if periods or scenario.fault.is_observable(scenario.plant):
            _observe_period(scenario, observed, periods * PERIOD)
            if observed.reported_at is None and _fault_count(scenario, expectation) > count:
                observed.reported_at = periods * PERIOD
            periods += 1
        if _is_complete(observed, expectation, mode):
            break
    if mode == "lying" and expectation.reaction in (Reaction.WATCH, Reaction.DEGRADE):
        _request_rise(scenario, observed, periods * PERIOD)
    return observed


def _max_duration(expectation: Expectation, mode: str) -> float:
    if expectation.reaction == Reaction.SIT:
        return expectation.within + SIT_TIME
    if expectation.reaction in (Reaction.DAMP, Reaction.STAY):
        return expectation.within + STAND_TIME
    if mode == "rising":
        return RISE_TIME
    if expectation.reaction == Reaction.REFUSE:
        return expectation.within + LIE_TIME
    return LIE_TIME if mode == "lying" else STAND_TIME


def _is_complete(observed: Observation, expectation: Expectation, mode: str) -> bool:
    """Return whether what is expected, or its contrary, has been seen for long enough."""
    since = observed.damped_at if expectation.reaction != Reaction.SIT else observed.passive_at
    if expectation.reaction in (Reaction.DAMP, Reaction.SIT, Reaction.STAY):
        return since is not None and observed.duration > since + SETTLED_TIME
    if mode != "rising":
        return False
    ends = [t for t in (observed.stood_at, observed.damped_at) if t is not None]
    return bool(ends) and observed.duration > min(ends) + 2.0 * SETTLED_TIME


def _observe_period(scenario: Scenario, observed: Observation, time: float) -> None:
    current, is_damped = scenario.supervisor.mode, is_damping(scenario.command)
    if is_damped and observed.damped_at is None:
        observed.damped_at = time
    if not is_damped and observed.damped_at is not None and observed.torque_resumed_at is None:
        observed.torque_resumed_at = time
    if current in (Mode.SIT, Mode.PASSIVE) and observed.sat_at is None:
        observed.sat_at = time
    if current == Mode.PASSIVE and is_damped and observed.passive_at is None:
        observed.passive_at = time
    if current == Mode.STAND and observed.stood_at is None:
        observed.stood_at = time
    plant = scenario.plant
    if current == Mode.STAND and observed.fell_at is None and has_fallen(plant.data, plant.handles):
        observed.fell_at = time
    observed.mode, observed.duration, observed.latch_reason = (
        current,
        time,
        scenario.supervisor.damping_fault.name.lower(),
    )
    height = float(plant.data.qpos[2])
    observed.min_height = min(observed.min_height, height)
    observed.max_rise = max(observed.max_rise, height - observed.min_height)
    observed.max_descent_speed = max(observed.max_descent_speed, -float(plant.data.qvel[2]))


def _fault_count(scenario: Scenario, expectation: Expectation) -> int:
    """Return how often the fault expected has begun."""
    if not expectation.fault:
        return 0
    return int(scenario.supervisor.faults.count(FaultId[expectation.fault.upper()]))


def _request_rise(scenario: Scenario, observed: Observation, time: float) -> None:
    """Ask to rise, and where that is refused to arm; a robot that was disarmed may be again."""
    rise = scenario.supervisor.request(Mode.RISE)
    done = rise == RequestStatus.ACCEPTED or (scenario.armed and rise == RequestStatus.NOT_ARMED)
    arm = None if done else scenario.supervisor.arm()
    observed.answers = f"rise: {rise.name}" + (f", arm: {arm.name}" if arm is not None else "")
    if RequestStatus.ACCEPTED in (rise, arm):
        observed.accepted_at = time if observed.accepted_at is None else observed.accepted_at
    elif observed.refused_at is None:
        observed.refused_at = time
