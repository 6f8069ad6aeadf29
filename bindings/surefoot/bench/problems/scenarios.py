"""Scenarios in which LowStates and QPs are recorded."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from surefoot._core import (
    BodyReference,
    ControllerOptions,
    Gait,
    QpForm,
    Robot,
    RobotState,
    StandController,
    WalkController,
    WalkOptions,
    WalkVelocity,
    WholeBodyController,
)
from surefoot.robot.description import RobotDescription
from surefoot.sim import Plant, PlantSettings, Push

PUSH_DURATION = 0.1  # [s] duration of a push, as in `surefoot assess`
# [s] Start of the lateral push, and of the forward push. Chosen: the robot settles in between.
PUSH_TIMES = (1.0, 4.0)
# Ratio of the torque limit to the largest standing torque in the scenario "weak". Chosen: with a
# ratio below 1 the robot cannot stand; with a ratio far above 1.3 no torque limit becomes active.
WEAK_TORQUE_FACTOR = 1.3
# Friction coefficient that the controller assumes in the scenario "slippery". Chosen so that
# friction cones are active. The ground has 1.5 times this value, so that the robot stands.
SLIPPERY_FRICTION = 0.2

BodyTrajectory = Callable[[float], BodyReference]
# Commanded velocities, each from a time [s] on, in order of time.
VelocityCourse = tuple[tuple[float, WalkVelocity], ...]
# Chosen: forward, to the side, on a curve, backwards and in place, at speeds of which all four
# robots are capable. The first command comes when the pose is latched.
TROT_COURSE: VelocityCourse = (
    (0.2, WalkVelocity(0.5, 0.0, 0.0)),
    (3.0, WalkVelocity(0.8, 0.0, 0.0)),
    (6.0, WalkVelocity(0.0, 0.3, 0.0)),
    (8.0, WalkVelocity(0.3, 0.0, 0.8)),
    (10.0, WalkVelocity(-0.3, 0.0, 0.0)),
    (12.0, WalkVelocity(0.0, 0.0, 0.0)),
)
WALK_COURSE: VelocityCourse = (
    (0.2, WalkVelocity(0.15, 0.0, 0.0)),
    (6.0, WalkVelocity(0.1, 0.0, 0.2)),
)


def _sway(time: float) -> BodyReference:
    """Return a body reference that sways in all six directions, each at its own frequency."""

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
    """One recorded run of a robot that stands or walks.

    Attributes:
        description: One line of text.
        duration: Duration of the run [s].
        push: Impulse of the pushes as a share of the LIP push limit; 0 for no push.
        friction: Friction coefficient of the ground; the controller assumes 2/3 of this value.
            None: the ground has 0.8, and the controller assumes its configured value.
        torque_factor: Torque limit of the controller, divided by the largest standing torque; no
            limit exceeds that of its motor. None: the limits of the motors.
        body_reference: Function of time [s] that returns the body reference, which is set before
            every tick. None: the pose is held.
    """

    description: str
    duration: float = 7.0
    push: float = 0.0
    friction: float | None = None
    torque_factor: float | None = None
    body_reference: BodyTrajectory | None = None
    velocities: VelocityCourse = ()
    gait: Gait = Gait.AUTO

    def make_controller(self, robot: Robot, form: QpForm = QpForm.AUTO) -> StandController:
        """Return a new controller: a WalkController if the scenario has velocities."""
        gains, options = robot.config.gains, ControllerOptions(form=form)
        if not self.velocities:
            return StandController(robot, gains, options)
        controller = WalkController(robot, gains, WalkOptions(options))
        controller.gait = self.gait
        return controller

    def velocity(self, time: float) -> WalkVelocity:
        """Return the velocity that is commanded at a time [s]."""
        started = [velocity for start, velocity in self.velocities if start <= time]
        return started[-1] if started else WalkVelocity()

    def apply_requests(self, controller: StandController, time: float) -> None:
        """Set the body reference and the velocity of the tick at a time [s], if there are any."""
        if self.body_reference is not None:
            controller.set_body_reference(self.body_reference(time))
        if isinstance(controller, WalkController):
            controller.set_velocity(self.velocity(time))

    def controller_robot(self, robot: Robot) -> Robot:
        """Return the controller's robot model, with the scenario's friction and torque limits."""
        config = robot.config  # a copy
        if self.friction is not None:
            config.friction = self.friction / 1.5
        if self.torque_factor is not None:
            config.tau_max = np.minimum(
                config.tau_max, self.torque_factor * _standing_torque(robot)
            )
        return Robot.from_serialized_model(robot.serialized_model(), config)

    def make_plant(self, robot: str | RobotDescription, rate: float, seed: int) -> Plant:
        """Return the plant, with the ground and the pushes of the scenario."""
        walks = bool(self.velocities)
        settings = PlantSettings(
            control_rate=rate,
            seed=seed,
            friction=0.8 if self.friction is None else self.friction,
            walking_sensors=walks,
            soft_soles=walks,
            leg_collisions=walks,
        )
        plant = Plant(robot, settings)
        for direction, time in zip(("lateral", "forward"), PUSH_TIMES, strict=True):
            if self.push > 0.0:
                impulse = self.push * plant.lip_push_limit(direction, PUSH_DURATION)
                plant.add_push(Push(direction, impulse, PUSH_DURATION, time))
        return plant


def _standing_torque(robot: Robot) -> float:
    """Return the largest motor torque [N.m] of the robot standing level and at rest."""
    controller = WholeBodyController(robot)
    state = RobotState(robot.nq, robot.nv)
    state.q = robot.q_standing()
    return float(np.abs(controller.update(state, controller.hold(state)).torques).max())


SCENARIOS: dict[str, Scenario] = {
    "quiet": Scenario("quiet standing", 4.0),
    "motion": Scenario("the body sways in six directions", 10.0, body_reference=_sway),
    "push50": Scenario("pushes of 50 % of the LIP limit, lateral and forward", push=0.5),
    "push80": Scenario("pushes of 80 % of the LIP limit", push=0.8),
    "push100": Scenario("pushes of 100 % of the LIP limit", push=1.0),
    "slippery": Scenario(
        "pushes of 30 % of the LIP limit at friction 0.3",
        push=0.3,
        friction=1.5 * SLIPPERY_FRICTION,
    ),
    "weak": Scenario(
        "pushes of 50 % of the LIP limit, torques limited to 1.3 times those of standing",
        push=0.5,
        torque_factor=WEAK_TORQUE_FACTOR,
    ),
    "trot": Scenario(
        "trot in all directions and in place, pushes of 50 % of the LIP limit",
        14.0,
        push=0.5,
        velocities=TROT_COURSE,
        gait=Gait.TROT,
    ),
    "walk": Scenario(
        "walk forward and on a curve, three feet down",
        10.0,
        velocities=WALK_COURSE,
        gait=Gait.WALK,
    ),
}
