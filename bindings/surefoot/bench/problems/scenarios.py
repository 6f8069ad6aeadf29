"""What a robot goes through while its programs are recorded."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from surefoot._core import (
    BodyReference,
    Robot,
    RobotState,
    StandController,
    WholeBodyController,
)
from surefoot.robot.description import RobotDescription
from surefoot.sim import Plant, PlantSettings, Push

PUSH_DURATION = 0.1  # [s]
PUSH_TIMES = (1.0, 4.0)  # [s] lateral, forward
WEAK_TORQUE_FACTOR = 1.3  # times the greatest torque of standing are left to motors that saturate
SLIPPERY_FRICTION = 0.2  # friction that the controller counts on; the ground's is half more

BodyTrajectory = Callable[[float], BodyReference]


def _sway(time: float) -> BodyReference:
    """Return a body that sways in all six directions, each at its own pace."""

    def wave(amplitude: float, hertz: float) -> float:
        return amplitude * math.sin(2.0 * math.pi * hertz * time)

    return BodyReference(
        x=wave(0.02, 0.3),
        y=wave(0.02, 0.4),
        height=wave(0.03, 0.25),
        roll=wave(0.1, 0.35),
        pitch=wave(0.1, 0.45),
        yaw=wave(0.15, 0.2),
    )


@dataclass(frozen=True)
class Scenario:
    """One recorded run of the stand controller.

    Attributes:
        description: In words.
        duration: [s].
        push: Share of what the linear inverted pendulum survives; 0 is none.
        friction: Between foot and ground, and 2/3 of that is counted on; None is the usual.
        torque_factor: What the controller is told of the motors: so many times the greatest torque that
            standing takes; None is all they have.
        body_reference: Where the body is asked to be at a time [s], told before every tick; None is to stay.
    """

    description: str
    duration: float = 7.0
    push: float = 0.0
    friction: float | None = None
    torque_factor: float | None = None
    body_reference: BodyTrajectory | None = None

    def apply_reference(self, controller: StandController, time: float) -> None:
        """Tell the controller what comes before the tick at a time [s]."""
        if self.body_reference is not None:
            controller.set_body_reference(self.body_reference(time))

    def controller_robot(self, robot: Robot) -> Robot:
        """Return the robot as the controller is told of it."""
        config = robot.config  # a copy
        if self.friction is not None:
            config.friction = self.friction / 1.5
        if self.torque_factor is not None:
            config.tau_max = np.minimum(
                config.tau_max, self.torque_factor * _standing_torque(robot)
            )
        return Robot.from_serialized_model(robot.serialized_model(), config)

    def make_plant(self, robot: str | RobotDescription, rate: float, seed: int) -> Plant:
        """Return the robot and its ground."""
        friction = 0.8 if self.friction is None else self.friction
        plant = Plant(robot, PlantSettings(control_rate=rate, seed=seed, friction=friction))
        for direction, time in zip(("lateral", "forward"), PUSH_TIMES, strict=True):
            if self.push > 0.0:
                impulse = self.push * plant.lip_push_limit(direction, PUSH_DURATION)
                plant.add_push(Push(direction, impulse, PUSH_DURATION, time))
        return plant


def _standing_torque(robot: Robot) -> float:
    """Return the greatest motor torque of standing level and at rest [N.m]."""
    controller = WholeBodyController(robot)
    state = RobotState(robot.nq, robot.nv)
    state.q = robot.q_standing()
    return float(np.abs(controller.update(state, controller.hold(state)).torques).max())


SCENARIOS: dict[str, Scenario] = {
    "quiet": Scenario("quiet standing", 4.0),
    "motion": Scenario("the body sways in six directions", 10.0, body_reference=_sway),
    "push50": Scenario("pushes of 50 % of the LIP limit, lateral and forward", push=0.5),
    "push80": Scenario("pushes of 80 %", push=0.8),
    "push100": Scenario("pushes of 100 %", push=1.0),
    "slippery": Scenario(
        "pushes of 30 % at friction 0.3", push=0.3, friction=1.5 * SLIPPERY_FRICTION
    ),
    "weak": Scenario(
        "pushes of 50 % with motors hardly stronger than standing",
        push=0.5,
        torque_factor=WEAK_TORQUE_FACTOR,
    ),
}
