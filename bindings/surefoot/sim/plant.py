"""A quadruped in MuJoCo behind the low-level interface: LowCmd in, LowState out."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import mujoco
import numpy as np

from surefoot._core import Error, LowCmd, LowState
from surefoot.robots import RobotDescription, build_robot, describe_robot, load_pinocchio_model
from surefoot.sim.adapter import Adapter
from surefoot.sim.handles import find_handles
from surefoot.sim.hands import Lift
from surefoot.sim.hanging import hang
from surefoot.sim.lying import DROPS, LOOK_TIME, REST_TIME, drop, hopeful, rests
from surefoot.sim.model import build_model
from surefoot.sim.motors import Law, Motors, command_law, damping_law
from surefoot.sim.physics import make_physics
from surefoot.sim.rotations import Array
from surefoot.sim.sensors import Sensors
from surefoot.sim.settings import PlantSettings, Push, direction_degrees
from surefoot.sim.stance import SETTLE_TIME, place, standing_law
from surefoot.sim.support import lip_limit
from surefoot.sim.timeline import Timeline
from surefoot.sim.truth import Truth, measure_truth
from surefoot.sim.wire import Command, Wire

_MOTOR_STREAM = 3  # of random numbers; the sensors have 0 .. 2


class Plant:
    """One robot on its ground, standing as reset() leaves it.

    Args:
        robot: A name of surefoot.available_robots(), or a RobotDescription.
        settings: Sensors, ground, payload, flaws, rates, seed.
        pushes: Pushes to come; add_push() adds more.
        tick0: LowState.tick of the first reading [ms], modulo 2^32.

    Raises:
        Error: An unknown robot, a missing file, joint or foot.

    Attributes:
        robot: The surefoot.Robot that a controller of this plant should be given.
        description: Its files.
        settings: The settings, with foot_force resolved.
        model: The MuJoCo model.
        data: The MuJoCo state; read it, do not write it.
        handles: Where things are in model and data.
    """

    def __init__(
        self,
        robot: str | RobotDescription,
        settings: PlantSettings | None = None,
        pushes: Iterable[Push] = (),
        tick0: int = 0,
    ) -> None:
        self.description = describe_robot(robot) if isinstance(robot, str) else robot
        self.robot = build_robot(self.description)
        self.settings = _resolve(settings or PlantSettings(), self.description)
        self.model = build_model(self.robot, self.description, self.settings)
        self.data = mujoco.MjData(self.model)
        self.handles = find_handles(self.model, self.robot)
        if self.settings.hung:
            hang(self.model, self.handles)
        self._adapter = Adapter(self.model, load_pinocchio_model(self.description))
        physics = make_physics(self.model, self.data, self.handles)
        dt = self.settings.physics_dt
        self._timeline = Timeline(self.model, self.data, self.handles, self.robot, physics, dt)
        self._wire = Wire(self.robot.name, self.settings.real)
        self._tick0 = tick0
        self._pushes = list(pushes)
        self._lifts: list[Lift] = []
        self.reset()

    @property
    def time(self) -> float:
        """Time since reset [s]."""
        return self._timeline.time

    @property
    def truth(self) -> Truth:
        """The true state of this instant."""
        torque = self.motors.torque
        return measure_truth(self.model, self.data, self.handles, self._adapter, self.time, torque)

    @property
    def first_truth(self) -> Truth:
        """The true state of the instant that reset()'s LowState tells of.

        With real sensors that is one period before the robot is handed over. Its time counts from
        before reset() and means nothing.
        """
        return self._first_truth

    @property
    def motors(self) -> Motors:
        """The motors: law in force, torques; read them, do not write them."""
        return self._timeline.motors

    @property
    def imu_bias(self) -> Array:
        """True bias (6,) of gyroscope [rad/s] and accelerometer [m/s^2], IMU axes."""
        return self._timeline.sensors.imu_bias

    @property
    def push_force(self) -> tuple[Array, Array]:
        """Force of the pushes (3,) [N] in the last physics step, and its point (3,), world."""
        return self._timeline.push_force

    def add_push(self, push: Push) -> None:
        """Add a push; after reset() it comes again at its time."""
        self._pushes.append(push)
        self._timeline.add_push(push)

    def renew(self, seed: int, pushes: Iterable[Push] = ()) -> None:
        """Be another run on the same ground from the next reset() on; lifts are gone.

        Building a plant takes as long as a run of seconds; this takes nothing.

        Args:
            seed: Of every random number.
            pushes: Instead of those that were there.
        """
        self.settings = replace(self.settings, seed=seed)
        self._pushes, self._lifts = list(pushes), []

    def add_lift(self, lift: Lift) -> None:
        """Add a lift by a hand; after reset() it comes again at its time."""
        self._lifts.append(lift)
        self._timeline.add_lift(lift)

    def reset(self) -> LowState:
        """Stand the robot up, let it settle in position mode and return the first LowState.

        The position command stays in force until the first LowCmd takes effect. The same seed
        gives the same run again.
        """
        settings = self.settings
        rng = np.random.default_rng([settings.seed, _MOTOR_STREAM]) if settings.real else None
        config, flaws = self.robot.config, settings.flaws
        motors = Motors(config, settings.physics_dt, settings.lag, rng, flaws)
        motors.law = standing_law(self.robot)
        sensors = Sensors(self.robot, self.data, self.handles, settings, self._tick0)
        self._timeline.start(motors, sensors)
        place(self.model, self.data, self.handles, self.robot, settings)
        mujoco.mj_step1(self.model, self.data)
        self._timeline.advance(round(SETTLE_TIME / settings.physics_dt))
        if self.truth.fell:
            raise Error(
                f"robot '{self.robot.name}' fell while its motors held the standing pose, before "
                f"anything was controlled: slope {settings.slope_deg:g} deg, friction "
                f"{settings.friction:g}, payload {settings.payload_kg:g} kg; ask for less"
            )
        return self._begin()

    def reset_lying(self, rng: np.random.Generator) -> LowState:
        """Drop the robot with its legs anyhow, motors braking, and return the first LowState.

        It is dropped again until it rests within 20 degrees of level, legs clear of each other (see
        sim/lying.py). The motors brake until the first LowCmd takes effect.

        Raises:
            Error: It never came to rest so in DROPS times.
        """
        self.reset()
        self._timeline.rewind()  # pushes are for who lies
        self.motors.law = damping_law()
        for _ in range(DROPS):
            drop(self.model, self.data, self.handles, self.robot, rng)
            self._timeline.advance(round(LOOK_TIME / self.settings.physics_dt))
            if not hopeful(self.model, self.data, self.handles):
                continue
            self._timeline.advance(round((REST_TIME - LOOK_TIME) / self.settings.physics_dt))
            if rests(self.model, self.data, self.handles):
                return self._begin()
        raise Error(
            f"robot '{self.robot.name}': dropped {DROPS} times, it never came to rest level"
        )

    def reset_resting(self, qpos: Array) -> LowState:
        """Lay the robot where it came to rest before, motors braking, and return a LowState.

        Args:
            qpos: MuJoCo's, as data.qpos was after reset_lying().
        """
        self.reset()
        self.motors.law = damping_law()
        self.data.qpos[:] = qpos
        self.data.qvel[:] = 0.0
        mujoco.mj_forward(self.model, self.data)  # accelerations, too: the IMU begins with them
        return self._begin()

    def _begin(self) -> LowState:
        """Start sensors and schedules from where the robot is."""
        settings = self.settings
        self._timeline.sensors.start()
        first = self._next = self.read()
        self._first_truth = self.truth
        if settings.real:
            self.advance()
            self._next = self.read()
        self._timeline.rewind()
        for push in self._pushes:
            self._timeline.add_push(push)
        for lift in self._lifts:
            self._timeline.add_lift(lift)
        return first

    def step(self, cmd: LowCmd) -> LowState:
        """Advance one control period.

        Args:
            cmd: In force from now on; with real sensors, from one period later.

        Returns:
            The state after this period; with real sensors, the state before it.
        """
        settings = self.settings
        delay = round(settings.extra_delay / settings.physics_dt)
        if settings.real:
            delay += settings.steps_per_tick
        self._timeline.send(command_law(self._wire.read(cmd)), delay)
        self.advance()
        previous, self._next = self._next, self.read()
        return previous if settings.real else self._next

    def read_command(self, cmd: LowCmd) -> Command:
        """Return the twelve motors of a LowCmd as this robot's drivers get them."""
        return self._wire.read(cmd)

    def obey(self, law: Law) -> None:
        """Put a law in force from the next physics step on, with no delay.

        obey(), advance() and read() are step() in three, for a wire with delays of its own.
        """
        self.motors.law = law

    def advance(self) -> None:
        """Advance one control period."""
        self._timeline.advance(self.settings.steps_per_tick)

    def read(self) -> LowState:
        """Return the LowState of this instant; every reading moves its tick on by one period."""
        state: LowState = self._timeline.sensors.read(self.motors)
        return state

    def pull(self, torque: Array | None) -> None:
        """Let hands turn the joints with torques (12,) [N.m] from now on; None lets go."""
        self._timeline.pull(np.zeros(12) if torque is None else torque)

    def lip_limit(self, direction: str | float, duration: float = 0.1) -> float:
        """Return the push that the linear inverted pendulum survives from here [N.s].

        J = m w d (w T) / (1 - exp(-w T)), w = sqrt(g / h): true mass m, height h of the centre
        of mass above the ground below it, distance d from there to the edge of the four feet.

        Args:
            direction: "forward", "lateral" or degrees from forward towards left.
            duration: Of the push, T [s].
        """
        degrees = direction_degrees(direction)
        return lip_limit(self.model, self.data, self.handles, self.robot, degrees, duration)


def _resolve(settings: PlantSettings, description: RobotDescription) -> PlantSettings:
    if not isinstance(settings, PlantSettings):
        raise Error(f"settings: got {type(settings).__name__}, expected PlantSettings")
    if settings.foot_force is not None:
        return settings
    alive = description.table.get("simulation", {}).get("foot_force_est", False)
    return replace(settings, foot_force="est" if alive else "dead")
