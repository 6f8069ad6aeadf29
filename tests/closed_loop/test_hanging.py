# SPDX-License-Identifier: BSD-3-Clause
"""A hanging robot that is requested to rise sits down and can be armed again."""

from __future__ import annotations

from collections.abc import Callable

import surefoot
from surefoot import FaultId, Mode, RequestStatus
from surefoot.sim import Plant, PlantSettings


def test_robot_stopped_after_a_hanging_fault_can_be_armed_again() -> None:
    plant = Plant("go1", PlantSettings(seed=1, hung=True))
    state = plant.reset()
    options = surefoot.SupervisorOptions(power_level=1)
    supervisor = surefoot.Supervisor(plant.robot, options=options)

    def run(seconds: float, until: Callable[[], bool]) -> bool:
        nonlocal state
        for _ in range(round(500 * seconds)):
            if until():
                return True
            state = plant.step(supervisor.update(state))
        return until()

    assert run(5.0, lambda: supervisor.arming.ready)
    assert supervisor.arm() == RequestStatus.ACCEPTED
    assert run(0.1, lambda: supervisor.armed)
    assert supervisor.request(Mode.RISE) == RequestStatus.ACCEPTED
    assert run(20.0, lambda: supervisor.mode == Mode.SIT)
    assert FaultId.HANGING in supervisor.faults.active
    supervisor.stop()
    assert run(0.1, lambda: supervisor.mode == Mode.DAMPING)
    assert run(5.0, lambda: supervisor.arming.ready), supervisor.arming.failures(plant.robot)
    assert supervisor.arm() == RequestStatus.ACCEPTED
