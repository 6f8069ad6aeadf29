# SPDX-License-Identifier: BSD-3-Clause
"""A robot that was taken over while standing sits down slowly and lies at the end."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
import surefoot
from surefoot import FaultId, Mode, RequestStatus, Start
from surefoot.robot.power_level import power_level
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.settings import COARSE_DT

pytestmark = pytest.mark.slow

OPERATOR_TIMEOUT = 0.5  # [s] without a heartbeat


class Scene:
    """A robot that stands from the start; battery and operator heartbeat can be changed."""

    def __init__(
        self, robot: str = "go1", load: float = 0.0, payload_limit_kg: float = math.inf
    ) -> None:
        self.plant = Plant(robot, PlantSettings(seed=3, physics_dt=COARSE_DT, payload_kg=load))
        options = surefoot.SupervisorOptions(
            start=Start.STANDING,
            power_level=power_level(robot),
            operator_timeout=OPERATOR_TIMEOUT,
            payload_limit=payload_limit_kg,
        )
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        self.report = self.plant.reset()
        self.operator, self.battery = True, 50  # sends heartbeats; charge [%]
        self.max_sinking_speed = 0.0  # [m/s] largest

    def run(self, seconds: float, until: Mode | None = None) -> list[Mode]:
        modes = []
        for _ in range(round(500 * seconds)):
            if self.operator:
                self.supervisor.heartbeat()
            self.report.bms.SOC = self.battery
            self.report = self.plant.step(self.supervisor.update(self.report))
            self.max_sinking_speed = max(self.max_sinking_speed, -self.plant.truth.v[2])
            modes.append(self.supervisor.mode)
            if modes[-1] == until:
                break
        return modes


def sit_requested(scene: Scene) -> None:
    assert scene.supervisor.request(Mode.SIT) == RequestStatus.ACCEPTED


def operator_silent(scene: Scene) -> None:
    scene.operator = False


def battery_low(scene: Scene) -> None:
    scene.battery = 1


@pytest.mark.parametrize(
    ("robot", "trigger"),
    [
        *(("a1", sit_requested), ("go1", sit_requested), ("go2", sit_requested)),
        *(("b1", sit_requested), ("go1", operator_silent), ("b1", battery_low)),
    ],
)
def test_robot_sits_down_slowly(robot: str, trigger: Callable[[Scene], None]) -> None:
    scene = Scene(robot)
    assert set(scene.run(1.0)) == {Mode.STAND}
    assert scene.supervisor.rise_progress == 1.0
    trigger(scene)
    modes = scene.run(10.0, until=Mode.PASSIVE)
    assert modes[-1] == Mode.PASSIVE
    assert modes.count(Mode.SIT) > 500  # 1 s; sitting down takes 2 s
    scene.run(1.0)
    assert scene.max_sinking_speed < 0.4
    if trigger is operator_silent:
        assert FaultId.OPERATOR in scene.supervisor.faults.active
    if trigger is battery_low:
        assert FaultId.BATTERY in scene.supervisor.faults.active


def test_overloaded_robot_stays_down_until_armed_again() -> None:
    scene = Scene(load=5.0, payload_limit_kg=2.0)
    supervisor = scene.supervisor
    assert scene.run(4.0, until=Mode.SIT)[-1] == Mode.SIT
    scene.run(0.5)  # the payload is not estimated now, but it is still there
    assert FaultId.PAYLOAD in supervisor.faults.active
    assert supervisor.request(Mode.STAND) == RequestStatus.NOT_READY
    assert scene.run(10.0, until=Mode.PASSIVE)[-1] == Mode.PASSIVE
    scene.run(2.0)
    assert supervisor.faults.count(FaultId.PAYLOAD) == 1
    assert supervisor.request(Mode.RISE) == RequestStatus.NOT_ARMED
    assert supervisor.arm() == RequestStatus.ACCEPTED  # the operator has checked it
    scene.run(0.1)
    assert supervisor.request(Mode.RISE) == RequestStatus.ACCEPTED


def test_robot_that_sat_down_is_armed_only_after_checks() -> None:
    scene = Scene()
    supervisor = scene.supervisor
    assert scene.run(0.5)[-1] == Mode.STAND
    sit_requested(scene)
    assert scene.run(10.0, until=Mode.PASSIVE)[-1] == Mode.PASSIVE
    scene.run(0.5)
    supervisor.stop()
    assert scene.run(0.1)[-1] == Mode.DAMPING
    # If armed at once, it would run the stand controller on a lying robot.
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
def test_robot_armed_at_low_height_does_not_rise_before_sitting_down(robot: str) -> None:
    scene = Scene(robot)
    scene.run(1.0)
    standing = scene.plant.truth.q[2]
    scene.supervisor.stop()
    scene.run(4.0)
    assert scene.supervisor.arm() == RequestStatus.ACCEPTED
    scene.run(2.0)
    assert scene.supervisor.mode == Mode.STAND
    before = scene.plant.truth.q[2]
    sit_requested(scene)
    highest = before
    for _ in range(20):
        scene.run(0.2)
        highest = max(highest, scene.plant.truth.q[2])
    assert scene.supervisor.mode == Mode.PASSIVE
    assert highest < before + 0.03 * standing
