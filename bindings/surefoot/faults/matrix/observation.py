"""Observation of a robot from the onset of a fault until the expected reaction has ended."""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot._core import FaultId, Mode, RequestStatus
from surefoot.faults.expectation import STOP_TIME, TIME_TOLERANCE, Expectation, Reaction
from surefoot.faults.matrix.command_monitor import is_damping
from surefoot.faults.matrix.reach_mode import RISE_TIME
from surefoot.faults.matrix.scenario import PERIOD, Scenario
from surefoot.sim.truth import has_fallen

# All times are chosen; longer times cost run time (641 cells per robot take 10 to 20 minutes).
# [s] Time of observation after the motors damp, or after the robot lies. Longer than TorqueFade
# (0.25 s): an error in this fade could give torque to damping motors again.
SETTLED_TIME = 0.6
# [s] Time of observing a standing robot, or of waiting until it damps. Longer than most detection
# times in fault_table().
STAND_TIME = 3.0
LIE_TIME = 1.2  # [s] time of observing a lying robot; longer than arming_time (1 s)
SIT_TIME = 9.0  # [s] longest time of sitting down; several times the 2 s of Supervisor.rise_time


@dataclass
class Observation:
    """Observed reaction of a robot.

    All times are in s and count from the first period in which Fault.is_observable() returns True;
    None: not observed.

    Attributes:
        damped_at: Time at which the motors first damped.
        torque_resumed_at: Time after `damped_at` at which the motors first had torques again.
        sat_at: Time at which the supervisor was first in mode SIT or PASSIVE.
        passive_at: Time at which the supervisor was first in mode PASSIVE with damping motors.
        stood_at: Time at which the supervisor was first in mode STAND.
        fell_at: Time at which, in mode STAND or WALK, a part other than a foot touched the ground,
            or the tilt exceeded 60 degrees.
        refused_at: Time at which arming and rising were first refused. observe() requests both in
            every period after Expectation.within; if the robot is not armed, in every period.
        accepted_at: Time at which arming or rising was accepted; the requests then end.
        mode: Mode of the supervisor at the end.
        max_descent_speed: Largest downward speed of the base [m/s].
        min_height: Smallest height of the base [m].
        max_rise: Largest rise of the base above its smallest height up to that time [m].
        duration: Time of the last observed period [s].
        reported_at: Time at which the supervisor reported the expected fault.
        latch_reason: Name of the fault for which damping latched; "none" if it did not latch.
        answers: Last answers to the requests to rise and to arm, as text.
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
    """Run a scenario from the onset of its fault for the time that the expectation needs.

    Args:
        scenario: Scenario in which the robot has reached the mode of the cell.
        expectation: Expected reaction.
        mode: Mode of the cell.
    """
    observed, periods = Observation(), 0
    expects_refusal = expectation.reaction == Reaction.REFUSE and mode == "lying"
    scenario.begin()
    count = _fault_count(scenario, expectation)
    for k in range(round(_max_duration(expectation, mode) / PERIOD)):
        due = k * PERIOD >= expectation.within - TIME_TOLERANCE or not scenario.armed
        if expects_refusal and due and observed.accepted_at is None:
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
        return expectation.within + SIT_TIME + (STOP_TIME if mode == "walking" else 0.0)
    if expectation.reaction in (Reaction.DAMP, Reaction.STAY):
        return expectation.within + STAND_TIME
    if mode == "rising":
        return RISE_TIME
    if expectation.reaction == Reaction.REFUSE:
        return expectation.within + LIE_TIME
    return LIE_TIME if mode == "lying" else STAND_TIME


def _is_complete(observed: Observation, expectation: Expectation, mode: str) -> bool:
    """Return True if the robot has reacted and was observed for long enough after its reaction."""
    reacted_at = observed.damped_at if expectation.reaction != Reaction.SIT else observed.passive_at
    if expectation.reaction in (Reaction.DAMP, Reaction.SIT, Reaction.STAY):
        return reacted_at is not None and observed.duration > reacted_at + SETTLED_TIME
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
    on_feet = current in (Mode.STAND, Mode.WALK)
    if on_feet and observed.fell_at is None and has_fallen(plant.data, plant.handles):
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
    """Return how often the supervisor has detected the expected fault; 0 if none is expected."""
    if not expectation.fault:
        return 0
    return int(scenario.supervisor.faults.count(FaultId[expectation.fault.upper()]))


def _request_rise(scenario: Scenario, observed: Observation, time: float) -> None:
    """Request a rise and, if the rise is refused, arming; write the answers into `observed`.

    Arming is not requested if the robot was armed before and the rise is refused with NOT_ARMED. In
    this case the arming checks may pass, so the supervisor could accept arming correctly.
    """
    rise = scenario.supervisor.request(Mode.RISE)
    done = rise == RequestStatus.ACCEPTED or (scenario.armed and rise == RequestStatus.NOT_ARMED)
    arm = None if done else scenario.supervisor.arm()
    observed.answers = f"rise: {rise.name}" + (f", arm: {arm.name}" if arm is not None else "")
    if RequestStatus.ACCEPTED in (rise, arm):
        observed.accepted_at = time if observed.accepted_at is None else observed.accepted_at
    elif observed.refused_at is None:
        observed.refused_at = time
