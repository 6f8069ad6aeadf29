# SPDX-License-Identifier: BSD-3-Clause
"""A robot that was taken over as it stood sits down as any other does, and lies by then."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
import surefoot
from surefoot import FaultId, Mode, RequestStatus, Start
from surefoot.faults.joint_faults import power_level
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.settings import COARSE_DT

SILENCE = 0.5  # [s] of the operator


class Scene:
    """A robot that stands from the start; its battery may run low, its operator fall silent."""

    def __init__(self, robot: str = "go1", load: float = 0.0, most: float = math.inf) -> None:
        self.plant = Plant(robot, PlantSettings(seed=3, physics_dt=COARSE_DT, payload_kg=load))
        options = surefoot.SupervisorOptions(
            start=Start.STANDING,
            power_level=power_level(robot),
            operator_timeout=SILENCE,
            payload_limit=most,
        )
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        self.report = self.plant.reset()
        self.operator, self.battery = True, 50  # there; [%]
        self.sinking = 0.0  # [m/s] greatest

    def run(self, seconds: float, until: Mode | None = None) -> list[Mode]:
        modes = []
        for _ in range(round(500 * seconds)):
            if self.operator:
                self.supervisor.heartbeat()
            self.report.bms.SOC = self.battery
            self.report = self.plant.step(self.supervisor.update(self.report))
            self.sinking = max(self.sinking, -self.plant.truth.v[2])
            modes.append(self.supervisor.mode)
            if modes[-1] == until:
                break
        return modes


def asked(scene: Scene) -> None:
    assert scene.supervisor.request(Mode.SIT) == RequestStatus.ACCEPTED


def operator_silent(scene: Scene) -> None:
    scene.operator = False


def battery_low(scene: Scene) -> None:
    scene.battery = 1


@pytest.mark.parametrize("why", [asked, operator_silent, battery_low])
@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_it_sits_down_slowly(robot: str, why: Callable[[Scene], None]) -> None:
    scene = Scene(robot)
    assert set(scene.run(1.0)) == {Mode.STAND}
    assert scene.supervisor.height == 1.0
    why(scene)
    modes = scene.run(10.0, until=Mode.PASSIVE)
    assert modes[-1] == Mode.PASSIVE
    assert modes.count(Mode.SIT) > 500  # 1 s, of two
    scene.run(1.0)
    assert scene.sinking < 0.4
    if why is operator_silent:
        assert FaultId.OPERATOR in scene.supervisor.faults.active
    if why is battery_low:
        assert FaultId.BATTERY in scene.supervisor.faults.active


def test_one_that_bears_too_much_stays_down_until_it_is_armed_anew() -> None:
    scene = Scene(load=5.0, most=2.0)
    supervisor = scene.supervisor
    assert scene.run(4.0, until=Mode.SIT)[-1] == Mode.SIT
    scene.run(0.5)  # nothing estimates the load any more; it is there all the same
    assert FaultId.PAYLOAD in supervisor.faults.active
    assert supervisor.request(Mode.STAND) == RequestStatus.NOT_READY
    assert scene.run(10.0, until=Mode.PASSIVE)[-1] == Mode.PASSIVE
    scene.run(2.0)
    assert supervisor.faults.count(FaultId.PAYLOAD) == 1
    assert supervisor.request(Mode.RISE) == RequestStatus.NOT_ARMED
    assert supervisor.arm() == RequestStatus.ACCEPTED  # the operator has seen to it
    scene.run(0.1)
    assert supervisor.request(Mode.RISE) == RequestStatus.ACCEPTED


def test_it_is_armed_behind_checks_like_any_that_lies() -> None:
    scene = Scene()
    supervisor = scene.supervisor
    assert scene.run(0.5)[-1] == Mode.STAND
    asked(scene)
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


@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_one_that_was_armed_again_where_it_sank_does_not_come_up_to_sit_down(robot: str) -> None:
    scene = Scene(robot)
    scene.run(1.0)
    scene.supervisor.stop()
    scene.run(4.0)
    assert scene.supervisor.arm() == RequestStatus.ACCEPTED
    scene.run(2.0)
    assert scene.supervisor.mode == Mode.STAND
    before = scene.plant.truth.q[2]
    asked(scene)
    highest = before
    for _ in range(20):
        scene.run(0.2)
        highest = max(highest, scene.plant.truth.q[2])
    assert scene.supervisor.mode == Mode.PASSIVE
    assert highest < before + 0.01
