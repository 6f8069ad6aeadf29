"""Observation of a robot from the onset of a fault until the expected reaction is complete."""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot._core import FaultId, Mode, RequestStatus
from surefoot.faults.expectation import TIME_TOLERANCE, Expectation, Reaction
from surefoot.faults.matrix.command_monitor import is_damping
from surefoot.faults.matrix.reach_mode import RISE_TIME
from surefoot.faults.matrix.scenario import PERIOD, Scenario
from surefoot.sim.truth import has_fallen

# Chosen by hand; above: run time, 495 cells a robot in 4 to 11 minutes.
# [s] of observation after latched damping, or after the robot lies: torques that return would do so
# within TorqueFade's 0.25 s.
SETTLED_TIME = 0.6
# [s] of observing a standing robot, or waiting for it to damp: above most times of fault_table().
STAND_TIME = 3.0
LIE_TIME = 1.2  # [s] of observing a lying robot: above the arming_time of 1 s
SIT_TIME = 9.0  # [s] limit of sitting down: several times the 2 s of a rise


@dataclass
class Observation:
    """Observed reaction. Times count from the first observable period [s]; None: not observed.

    Attributes:
        damped_at: Time at which the motors first damped.
        torque_resumed_at: Time at which they had torques again after that.
        sat_at: Time at which the supervisor was first in mode SIT or PASSIVE.
        passive_at: Time at which it was first in mode PASSIVE with damping motors.
        stood_at: Time at which it was first in mode STAND.
        fell_at: Time at which, in mode STAND, a part other than a foot touched the ground, or the
            tilt exceeded 60 degrees.
        refused_at: Time at which arming and rising were first refused. They are requested in every
            period from Expectation.within on, or at once if the robot is not armed.
        accepted_at: Time at which one of them was accepted; requests end then.
        mode: Mode at the end.
        max_descent_speed: Largest downward speed of the base [m/s].
        min_height: Smallest height of the base [m].
        max_rise: Largest height of the base above its smallest height before [m].
        duration: Duration of the observation [s].
        reported_at: Time at which the expected fault was reported.
        latch_reason: Name of the fault for which damping latched.
        answers: Last answers to the requests to rise and to arm.
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
    """Run a scenario from the onset of its fault, for as long as the expectation needs."""
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
    """Return True if the expected reaction, or its opposite, was observed for long enough."""
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
    """Return how often the expected fault has begun."""
    if not expectation.fault:
        return 0
    return int(scenario.supervisor.faults.count(FaultId[expectation.fault.upper()]))


def _request_rise(scenario: Scenario, observed: Observation, time: float) -> None:
    """Request a rise and, if it is refused, arming.

    A robot that was armed and now refuses with NOT_ARMED is not armed again, because its arming
    checks may rightly pass.
    """
    rise = scenario.supervisor.request(Mode.RISE)
    done = rise == RequestStatus.ACCEPTED or (scenario.armed and rise == RequestStatus.NOT_ARMED)
    arm = None if done else scenario.supervisor.arm()
    observed.answers = f"rise: {rise.name}" + (f", arm: {arm.name}" if arm is not None else "")
    if RequestStatus.ACCEPTED in (rise, arm):
        observed.accepted_at = time if observed.accepted_at is None else observed.accepted_at
    elif observed.refused_at is None:
        observed.refused_at = time
