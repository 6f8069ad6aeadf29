"""Motion of a robot from its start to the moment at which a fault begins."""

from __future__ import annotations

from surefoot._core import Mode
from surefoot.faults.matrix.scenario import Scenario
from surefoot.sim import Push

RISE_REQUESTED = "rise requested"  # mode that ends with the request to rise
# Chosen by hand; docs/faults.md states them.
RISE_FRACTION = 0.4  # share of the rise at which a fault begins: legs carry the body, not yet up
RISE_TIME = 15.0  # [s] limit of a rise; get-ups take 7 to 10 s in the median (benchmarks/get_up.py)
SETTLE_TIME = 1.5  # [s] of standing before the fault or the push: the fade (0.25 s) is over
PUSH_FRACTION = 0.4  # of the LIP push limit: survived in place without a fault
PUSH_TIME, PUSH_LEAD = 0.1, 0.05  # [s] duration of the push; part of it before the fault


def reach_mode(scenario: Scenario, mode: str) -> str:
    """Bring a robot to the moment at which a fault of a mode begins.

    Returns:
        "", or the reason why the robot did not get there.
    """
    if scenario.taken_over:
        scenario.step()
        return _stand(scenario, mode) if scenario.is_armed() else "was not taken over"
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
    return "" if scenario.supervisor.mode == Mode.STAND else _progress_text(scenario)


def _rise(scenario: Scenario) -> str:
    for _ in range(round(RISE_TIME / 0.002)):
        scenario.step()
        if scenario.supervisor.rise_progress > RISE_FRACTION:
            return ""
    return _progress_text(scenario)


def _progress_text(scenario: Scenario) -> str:
    supervisor = scenario.supervisor
    return f"got no further than {supervisor.mode.name}, {supervisor.damping_fault.name}"
