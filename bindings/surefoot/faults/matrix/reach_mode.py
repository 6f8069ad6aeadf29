"""Part of a run before the fault: brings the robot from its start to the onset of the fault."""

from __future__ import annotations

import math

from surefoot._core import Mode, WalkVelocity
from surefoot.faults.matrix.scenario import Scenario
from surefoot.sim import Push

RISE_REQUESTED = "rise requested"  # mode in which the fault begins right after the request to rise
# The following numbers are chosen; docs/reference/fault-injection.md lists them.
# Progress of the rise (0 .. 1) at which a fault begins: the legs carry the body and still raise it.
RISE_FRACTION = 0.4
RISE_TIME = 15.0  # [s] longest rise with folding; median 7 to 10 s (benchmarks/get_up.py)
SETTLE_TIME = 1.5  # [s] time of standing before the fault or the push; includes TorqueFade (0.25 s)
# Impulse of the push as a share of the LIP push limit. A healthy robot survives this push in place.
PUSH_FRACTION = 0.4
WALK_TIME = 2.0  # [s] time of walking before the fault; longer than the acceleration
# Velocity of a walking robot: forward [sqrt(g h)] and turn [sqrt(g/h)], h: height of the base. On a
# go1 0.4 m/s and 0.6 rad/s.
WALK_SPEED, WALK_TURN = 0.22, 0.1
PUSH_TIME, PUSH_LEAD = 0.1, 0.05  # [s] duration of the push; time from its start to the fault


def reach_mode(scenario: Scenario, mode: str) -> str:
    """Run a scenario until the moment in a mode at which a fault begins.

    Args:
        scenario: Scenario at its start.
        mode: Mode of the cell, or RISE_REQUESTED.

    Returns:
        "", or the reason why the robot did not reach this moment.
    """
    if scenario.taken_over:
        scenario.step()
        return _stand(scenario, mode) if scenario.update_armed() else "was not taken over"
    if not scenario.arm():
        return f"was not armed: {scenario.arming_failures}"
    if mode == "lying":
        scenario.run(0.2)
        return ""
    scenario.supervisor.request(Mode.RISE)
    if mode == RISE_REQUESTED:
        return ""
    if mode == "rising":
        return _rise(scenario)
    if not scenario.run_until_mode(Mode.STAND, RISE_TIME):
        return _progress_text(scenario)
    return _stand(scenario, mode)


def _stand(scenario: Scenario, mode: str) -> str:
    scenario.run(SETTLE_TIME)
    if mode == "pushed":
        plant = scenario.plant
        impulse = PUSH_FRACTION * plant.lip_push_limit("lateral", PUSH_TIME)
        plant.add_push(Push("lateral", impulse, PUSH_TIME, plant.time))
        scenario.run(PUSH_LEAD)
    if mode == "walking":
        return _walk(scenario)
    return "" if scenario.supervisor.mode == Mode.STAND else _progress_text(scenario)


def _walk(scenario: Scenario) -> str:
    height = float(scenario.plant.data.qpos[2])
    time = math.sqrt(height / 9.81)
    scenario.velocity = WalkVelocity(WALK_SPEED * height / time, 0.0, WALK_TURN / time)
    answer = scenario.supervisor.request(Mode.WALK)
    scenario.run(WALK_TIME)
    if scenario.supervisor.mode == Mode.WALK and scenario.supervisor.controller.walking:
        return ""
    return f"{_progress_text(scenario)}; walk: {answer.name}"


def _rise(scenario: Scenario) -> str:
    for _ in range(round(RISE_TIME / 0.002)):
        scenario.step()
        if scenario.supervisor.rise_progress > RISE_FRACTION:
            return ""
    return _progress_text(scenario)


def _progress_text(scenario: Scenario) -> str:
    supervisor = scenario.supervisor
    return f"got no further than {supervisor.mode.name}, {supervisor.damping_fault.name}"
