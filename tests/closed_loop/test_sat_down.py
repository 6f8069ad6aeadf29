# SPDX-License-Identifier: BSD-3-Clause
"""A robot that was taken over as it stood, and lies by now."""

from __future__ import annotations

import surefoot
from surefoot import Mode, RequestStatus, Start
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.settings import COARSE_DT


class Scene:
    def __init__(self) -> None:
        self.plant = Plant("go1", PlantSettings(seed=3, physics_dt=COARSE_DT))
        options = surefoot.SupervisorOptions(start=Start.STANDING)
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        self.report = self.plant.reset()

    def run(self, seconds: float, until: Mode | None = None) -> list[Mode]:
        modes = []
        for _ in range(round(500 * seconds)):
            self.report = self.plant.step(self.supervisor.update(self.report))
            modes.append(self.supervisor.mode)
            if modes[-1] == until:
                break
        return modes


def test_it_is_armed_behind_checks_like_any_that_lies() -> None:
    scene = Scene()
    supervisor = scene.supervisor
    assert scene.run(0.5)[-1] == Mode.STAND
    assert supervisor.request(Mode.SIT) == RequestStatus.ACCEPTED
    assert scene.run(10.0, until=Mode.PASSIVE)[-1] == Mode.PASSIVE
    scene.run(0.5)
    supervisor.stop()
    assert scene.run(0.1)[-1] == Mode.DAMPING
    # At once it would be a program that stands on a robot that lies.
    supervisor.arm()
    assert Mode.STAND not in scene.run(0.2)
    for _ in range(40):
        if supervisor.arm() == RequestStatus.ACCEPTED:
            break
        scene.run(0.1)
    assert scene.run(0.2)[-1] == Mode.PASSIVE and supervisor.armed
    assert supervisor.request(Mode.RISE) == RequestStatus.ACCEPTED
    assert scene.run(15.0, until=Mode.STAND)[-1] == Mode.STAND
