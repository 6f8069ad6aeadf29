"""The plant: a quadruped simulated in MuJoCo. Input: LowCmd; output: LowState."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import cached_property
from pathlib import Path

import mujoco
import numpy as np

from surefoot._core import Error, LowCmd, LowState
from surefoot.geometry.rotations import Array
from surefoot.robot.loading import (
    RobotDescription,
    build_robot,
    describe_robot,
    load_pinocchio_model,
)
from surefoot.sim.foot_friction import foot_friction
from surefoot.sim.hardware.motors import MotorLaw, Motors, command_law, damping_law
from surefoot.sim.hardware.sensors import Sensors
from surefoot.sim.hardware.wire_format import MotorCommands, WireFormat
from surefoot.sim.lip_push_limit import lip_push_limit
from surefoot.sim.mjcf.describe import describe_mjcf
from surefoot.sim.mjcf.mapping import ModelMapping
from surefoot.sim.model.leg_collisions import leg_contacts, part_of_geoms
from surefoot.sim.model.mujoco_handles import find_handles
from surefoot.sim.model.mujoco_model import build_model
from surefoot.sim.physics.external_lift import Lift
from surefoot.sim.physics.hanging import fix_base
from surefoot.sim.physics.lying_pose import (
    FIRST_CHECK_TIME,
    LYING_SETTLE_TIME,
    MAX_DROPS,
    drop_robot,
    is_settled,
    may_settle,
)
from surefoot.sim.physics.mujoco_steps import make_physics
from surefoot.sim.physics.physics_loop import PhysicsLoop
from surefoot.sim.physics.standing_pose import SETTLE_TIME, place_standing, standing_law
from surefoot.sim.pinocchio_adapter import PinocchioAdapter
from surefoot.sim.settings import PlantSettings, Push, direction_degrees
from surefoot.sim.truth import Truth, measure_truth

_MOTOR_STREAM = 3  # stream of random numbers; the sensors use streams 0 .. 2


class Plant:
    """A simulated robot on its ground, with sensors, motors and delays of a real one.

    The constructor calls reset(): the robot stands in its standing pose. step() then advances one
    control period.

    Args:
        robot: A name of surefoot.available_robots(), or a RobotDescription.
        settings: Sensors, ground, payload, flaws, rates, seed; None: the defaults.
        pushes: Scheduled pushes; add_push() adds more.
        tick0: LowState.tick of the first sample [ms], modulo 2^32.
        mjcf: MJCF file from which the simulated robot and its ground are built, such as scene.xml.
            The controller's robot stays that of `robot`. None: as the description says.

    Raises:
        Error: The robot is unknown; a file, joint or foot is missing; the MJCF has an element that
            is not supported; or a setting is not the default although the MJCF replaces it.

    Attributes:
        robot: The surefoot.Robot for a controller of this plant.
        description: The files of the robot.
        settings: The settings, with foot_force resolved, and without soft soles if there is an
            MJCF.
        model: The MuJoCo model.
        data: The MuJoCo state; read it, do not write it.
        handles: Indices of the robot's parts in model and data.
        friction: Smallest sliding friction coefficient of the feet on the ground. NaN for the
            hung robot of an MJCF, because its feet touch no ground.
    """

    def __init__(
        self,
        robot: str | RobotDescription,
        settings: PlantSettings | None = None,
        pushes: Iterable[Push] = (),
        tick0: int = 0,
        mjcf: str | Path | None = None,
    ) -> None:
        description = describe_robot(robot) if isinstance(robot, str) else robot
        self.description = description if mjcf is None else description.with_mjcf(mjcf)
        self.robot = build_robot(self.description)
        self.settings = _resolve_settings(settings or PlantSettings(), self.description)
        self.model = build_model(self.robot, self.description, self.settings)
        self.data = mujoco.MjData(self.model)
        self.handles = find_handles(
            self.model, self.robot, calves_may_touch_ground=self.description.mjcf is not None
        )
        if self.settings.hung:
            fix_base(self.model, self.handles)
        self._adapter = PinocchioAdapter(self.model, load_pinocchio_model(self.description))
        physics = make_physics(self.model, self.data, self.handles)
        dt = self.settings.physics_dt
        self._parts = part_of_geoms(self.model, self.robot)
        self._physics_loop = PhysicsLoop(
            self.model, self.data, self.handles, self.robot, physics, dt
        )
        self._wire_format = WireFormat(self.robot.name, self.settings.real)
        self._tick0 = tick0
        self._pushes = list(pushes)
        self._lifts: list[Lift] = []
        self.reset()
        self.friction = self.settings.friction
        if self.description.mjcf is not None:
            self.friction = foot_friction(self.data, self.handles)

    @cached_property
    def mapping(self) -> ModelMapping | None:
        """What was found in the MJCF; None if the plant is built from the URDF."""
        return None if self.description.mjcf is None else describe_mjcf(self.description)

    @property
    def time(self) -> float:
        """Time since reset [s]."""
        return self._physics_loop.time

    @property
    def truth(self) -> Truth:
        """The true state at this instant."""
        torque = self.motors.torque
        return measure_truth(self.model, self.data, self.handles, self._adapter, self.time, torque)

    @property
    def first_truth(self) -> Truth:
        """The true state at the instant of the LowState that reset() returned.

        With real sensors that instant is one control period before the run starts. Field `time` has
        no meaning, because the clock restarts after that instant.
        """
        return self._first_truth

    @property
    def motors(self) -> Motors:
        """The motors with their present law and torques, for reading only."""
        return self._physics_loop.motors

    @property
    def imu_bias(self) -> Array:
        """True bias (6,) of gyroscope [rad/s] and accelerometer [m/s^2], IMU axes."""
        return self._physics_loop.sensors.imu_bias

    @property
    def push_force(self) -> tuple[Array, Array]:
        """Push force (3,) [N] in the last physics step, and its point (3,) [m], world axes."""
        return self._physics_loop.push_force

    @property
    def leg_contacts(self) -> frozenset[tuple[str, str]]:
        """Pairs of a leg with another leg or "trunk" that touch now, such as ("FR", "FL").

        Unless PlantSettings.leg_collisions is set, pairs that the SRDF disables are missing.
        """
        return leg_contacts(self.data, self._parts)

    def add_push(self, push: Push) -> None:
        """Schedule a push, in this run and in every run after a reset()."""
        self._pushes.append(push)
        self._physics_loop.add_push(push)

    def reseed(self, seed: int, pushes: Iterable[Push] = ()) -> None:
        """Set seed and pushes for all runs from the next reset() on, and remove all lifts.

        Use this for further runs on the same ground. Building a new plant instead would take as
        long as simulating several seconds.

        Args:
            seed: Seed of all random numbers.
            pushes: Pushes that replace the present ones.
        """
        self.settings = replace(self.settings, seed=seed)
        self._pushes, self._lifts = list(pushes), []

    def add_lift(self, lift: Lift) -> None:
        """Schedule an external lift, in this run and in every run after a reset()."""
        self._lifts.append(lift)
        self._physics_loop.add_lift(lift)

    def reset(self) -> LowState:
        """Place the robot in its standing pose, let it settle, and return the first LowState.

        The motors hold the pose in position mode until the first LowCmd takes effect. The same seed
        gives the same run.

        Raises:
            Error: The robot fell while it settled.
        """
        settings = self.settings
        rng = np.random.default_rng([settings.seed, _MOTOR_STREAM]) if settings.real else None
        config, flaws = self.robot.config, settings.flaws
        motors = Motors(config, settings.physics_dt, settings.lag, rng, flaws)
        motors.law = standing_law(self.robot)
        sensors = Sensors(self.robot, self.data, self.handles, settings, self._tick0)
        self._physics_loop.start(motors, sensors)
        place_standing(self.model, self.data, self.handles, self.robot, settings)
        mujoco.mj_step1(self.model, self.data)
        self._physics_loop.advance(round(SETTLE_TIME / settings.physics_dt))
        if self.truth.fell:
            ground, advice = self._ground_and_advice()
            raise Error(
                f"robot '{self.robot.name}' fell while its motors held the standing pose, before "
                f"the first LowCmd: {ground}, payload {settings.payload_kg:g} kg; try {advice}"
            )
        return self._start_run()

    def _ground_and_advice(self) -> tuple[str, str]:
        """Return the ground in words, and what to try if the robot falls on it at once."""
        mjcf, settings = self.description.mjcf, self.settings
        if mjcf is None:
            ground = f"slope {settings.slope_deg:g} deg, friction {settings.friction:g}"
            return ground, "easier settings"
        advice = f"level ground at the origin (surefoot robots --mjcf {mjcf} shows what was found)"
        return f"MJCF '{mjcf}'", advice

    def reset_lying(self, rng: np.random.Generator) -> LowState:
        """Drop the robot with random joint angles and return the first LowState of the lying robot.

        The drop is repeated until the robot rests within 20 degrees of level, with its legs clear
        of each other (see sim/physics/lying_pose.py). The motors brake until the first LowCmd takes
        effect.

        Args:
            rng: Source of the joint angles and attitudes.

        Raises:
            Error: None of MAX_DROPS drops ended in such a pose.
        """
        self.reset()
        self._physics_loop.restart_time()  # remove pushes: none may act before the robot lies
        self.motors.law = damping_law()
        for _ in range(MAX_DROPS):
            drop_robot(self.model, self.data, self.handles, self.robot, rng)
            self._physics_loop.advance(round(FIRST_CHECK_TIME / self.settings.physics_dt))
            if not may_settle(self.model, self.data, self.handles):
                continue
            self._physics_loop.advance(
                round((LYING_SETTLE_TIME - FIRST_CHECK_TIME) / self.settings.physics_dt)
            )
            if is_settled(self.model, self.data, self.handles):
                return self._start_run()
        raise Error(
            f"robot '{self.robot.name}': dropped {MAX_DROPS} times, it never came to rest level "
            "with its legs clear of each other; try another seed"
        )

    def reset_lying_at(self, qpos: Array) -> LowState:
        """Place the robot in a known lying pose, at rest, and return the first LowState.

        The motors brake until the first LowCmd takes effect.

        Args:
            qpos: MuJoCo's qpos (nq,), for example data.qpos after reset_lying().
        """
        self.reset()
        self.motors.law = damping_law()
        self.data.qpos[:] = qpos
        self.data.qvel[:] = 0.0
        mujoco.mj_forward(self.model, self.data)  # the first IMU sample needs accelerations too
        return self._start_run()

    def _start_run(self) -> LowState:
        """Start sensors, clock and schedules in the present pose."""
        settings = self.settings
        self._physics_loop.sensors.start()
        first = self._next_state = self.read()
        self._first_truth = self.truth
        if settings.real:
            self.advance()
            self._next_state = self.read()
        self._physics_loop.restart_time()
        for push in self._pushes:
            self._physics_loop.add_push(push)
        for lift in self._lifts:
            self._physics_loop.add_lift(lift)
        return first

    def step(self, cmd: LowCmd) -> LowState:
        """Advance one control period.

        Args:
            cmd: The command. It takes effect at once, or with real sensors one period later.

        Returns:
            The LowState at the end of this period; with real sensors, at its beginning.
        """
        settings = self.settings
        delay = round(settings.extra_delay / settings.physics_dt)
        if settings.real:
            delay += settings.steps_per_tick
        self._physics_loop.schedule_law(command_law(self._wire_format.read(cmd)), delay)
        self.advance()
        previous, self._next_state = self._next_state, self.read()
        return previous if settings.real else self._next_state

    def read_command(self, cmd: LowCmd) -> MotorCommands:
        """Return the twelve motor commands of a LowCmd as this robot's drivers receive them."""
        return self._wire_format.read(cmd)

    def apply_law(self, law: MotorLaw) -> None:
        """Set the motor law from the next physics step on, without delay.

        apply_law(), advance() and read() are the three parts of step(). Call them separately for a
        link that has delays of its own.
        """
        self.motors.law = law

    def advance(self) -> None:
        """Advance one control period."""
        self._physics_loop.advance(self.settings.steps_per_tick)

    def read(self) -> LowState:
        """Return the LowState at this instant. Each call advances its tick by one period."""
        state: LowState = self._physics_loop.sensors.read(self.motors)
        return state

    def apply_joint_torque(self, torque: Array | None) -> None:
        """Apply external torques (12,) [N.m] to the joints from now on; None removes them."""
        self._physics_loop.apply_joint_torque(np.zeros(12) if torque is None else torque)

    def lip_push_limit(self, direction: str | float, duration: float = 0.1) -> float:
        """Return the LIP push limit in the present pose [N.s].

        J = m w d (w T) / (1 - exp(-w T)), w = sqrt(g / h). m is the true mass, and h is the height
        of the centre of mass above the ground. d is the horizontal distance from the centre of mass
        to the support edge of all four feet.

        Args:
            direction: "forward", "lateral", or degrees from forward towards left.
            duration: Duration T of the push [s].
        """
        degrees = direction_degrees(direction)
        return lip_push_limit(self.model, self.data, self.handles, degrees, duration)


def _resolve_settings(settings: PlantSettings, description: RobotDescription) -> PlantSettings:
    """Replace the settings whose values depend on the robot's files."""
    if not isinstance(settings, PlantSettings):
        raise Error(f"settings: got {type(settings).__name__}, expected PlantSettings")
    if description.mjcf is not None:
        settings = replace(settings, soft_soles=False)
    if settings.foot_force is not None:
        return settings
    has_force_estimate = description.table.get("simulation", {}).get("foot_force_est", False)
    return replace(settings, foot_force="est" if has_force_estimate else "dead")
