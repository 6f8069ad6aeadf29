"""Episode of a walk: a turn, sideways, forward, pushes while it walks, and a stop."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from surefoot._core import Gains, Robot, WalkController, WalkVelocity
from surefoot.robot.loading import build_robot
from surefoot.sim import Flaws, Plant, PlantSettings
from surefoot.stand.push_request import PushRequest
from surefoot.stand.simulation_loop import make_plant
from surefoot.tune.cost import Cost
from surefoot.tune.search.episodes import (
    JOINT_FRICTION_RANGE,
    RobotSource,
    find_robot,
    random_settings,
)
from surefoot.tune.walk_cost import walk_cost
from surefoot.walk import VelocityRequest, WalkLog, WalkSettings, simulate_walk

# All values are chosen. A command lasts longer than the 1 s that the figures of a walk leave out,
# and a pushed robot recovers or falls within PUSH_INTERVAL.
FIRST_COMMAND, COMMAND_TIME, STOP_TIME = 0.4, 2.0, 2.0  # [s]
PUSH_TIME, PUSH_INTERVAL, PUSH_COUNT = 0.6, 1.6, 2  # [s] after the command, [s], [pushes]
# Ranges of the commands, as shares of the robot's speed limits (gains walk_speed_...,
# walk_turn_speed). On small robots: 0.4 to 1.3 m/s forward, 0.25 to 0.6 m/s sideways, 0.9 to 2.2
# rad/s.
FORWARD_SHARE, SIDEWAYS_SHARE, TURN_SHARE = (0.2, 0.65), (0.3, 0.75), (0.3, 0.75)
SLOW_SHARE = 0.3  # largest share of forward and sideways speed while the robot is pushed or turns
# Range of the impulse as a share of the LIP push limit. Chosen: almost all gains survive weaker
# pushes, and a fall hides all other terms.
PUSH_LIMIT_SHARE = 0.5, 1.1
# The following ranges of robots and grounds are chosen, not measured on real ones.
MAX_DELAY_STEPS = 4  # [physics steps] greatest additional delay of commands: 4 ms
MOTOR_LAG_RANGE = 0.002, 0.005  # [s] range of the time constant of the motor torque
ARMATURE_RANGE = 0.7, 1.4  # range of the factor on the rotor inertia of the model
TRUNK_RANGE = 0.9, 1.1  # range of the factor on mass and inertia of the trunk
SINK_RANGE = 0.0005, 0.005  # [m] range of the ground's sink under a quarter of the weight
RIGID_SHARE = 0.5  # share of episodes on rigid ground


@dataclass(frozen=True)
class WalkEpisode:
    """One simulated walk.

    Attributes:
        robot: A name of surefoot.available_robots(), or the paths of a URDF and a TOML.
        seed: Seed of sensors, motors, soles, ground, masses, commands and pushes.
        settings: All other settings of the plant; settings.seed is not used.
    """

    robot: RobotSource
    seed: int
    settings: PlantSettings

    def plant(self) -> Plant:
        """Return the plant with its pushes; raise Error if the robot or a setting is invalid."""
        return make_plant(self.walk_settings())

    def simulate(
        self, plant: Plant, gains: Gains, on_tick: Callable[[int], None] | None = None
    ) -> WalkLog:
        """Run the episode and return its log; see Episode. A fall always ends the episode."""

        def progress(_: str, done: int, __: int) -> None:
            if on_tick is not None:
                on_tick(done - 1)

        return simulate_walk(plant, replace(self.walk_settings(), gains=gains), progress)

    def cost(self, record: WalkLog, objective: str) -> Cost:
        """Return the cost of a log; `objective` is one of walk_cost.WALK_OBJECTIVES."""
        return walk_cost(record, objective)

    def walk_settings(self) -> WalkSettings:
        """Return the settings of the walk, with the robot's own gains.

        Raises:
            Error: The robot is unknown, or its files are invalid.
        """
        rng = np.random.default_rng([self.seed, 11])
        description = find_robot(self.robot)
        robot = build_robot(description)
        plant = self._random_plant(rng, robot.mass)
        velocities = _random_commands(rng, speed_limits(robot))
        begin = velocities[-2].time
        pushes = tuple(
            PushRequest(
                float(rng.uniform(-180.0, 180.0)),
                100.0 * float(rng.uniform(*PUSH_LIMIT_SHARE)),
                True,
                0.1,
                # Whole ticks, and any phase of the gait.
                round(begin + PUSH_TIME + k * PUSH_INTERVAL + float(rng.uniform(0.0, 0.4)), 2),
            )
            for k in range(PUSH_COUNT)
        )
        duration = velocities[-1].time + STOP_TIME
        return WalkSettings(description, duration, plant, pushes, velocities=velocities)

    def _random_plant(self, rng: np.random.Generator, mass: float) -> PlantSettings:
        rigid = bool(rng.uniform() < RIGID_SHARE)
        sink = float(rng.uniform(*SINK_RANGE))
        return replace(
            self.settings,
            seed=self.seed,
            **random_settings(rng, mass, MAX_DELAY_STEPS),
            motor_lag=float(rng.uniform(*MOTOR_LAG_RANGE)),
            joint_friction_scale=float(rng.uniform(*JOINT_FRICTION_RANGE)),
            armature_scale=float(rng.uniform(*ARMATURE_RANGE)),
            flaws=Flaws(trunk_mass_scale=float(rng.uniform(*TRUNK_RANGE))),
            walking_sensors=True,
            soft_soles=bool(rng.uniform() < 0.5),
            soft_ground_sink=0.0 if rigid else sink,
            leg_collisions=True,
        )


def speed_limits(robot: Robot) -> WalkVelocity:
    """Return the largest velocity that a WalkController with the robot's own gains accepts."""
    controller = WalkController(robot)
    controller.set_velocity(WalkVelocity(1e3, 1e3, 1e3))
    return controller.commanded_velocity


def _random_commands(rng: np.random.Generator, limits: WalkVelocity) -> tuple[VelocityRequest, ...]:
    """Return turn, sideways, forward, slow walk and stop, each with its random velocity.

    The fastest command comes late, because a fall ends the episode.
    """

    def share(low: float, high: float) -> float:
        return float(rng.uniform(low, high))

    def sign() -> float:
        return float(rng.choice([-1.0, 1.0]))

    forward = share(*FORWARD_SHARE) * limits.vx
    sideways = sign() * share(*SIDEWAYS_SHARE) * limits.vy
    turn = sign() * share(*TURN_SHARE) * limits.yaw_rate
    slow = share(0.0, SLOW_SHARE) * limits.vx, sign() * share(0.0, SLOW_SHARE) * limits.vy
    velocities = [
        *((slow[0], 0.0, turn), (0.0, sideways, 0.0), (forward, 0.0, 0.0)),
        *((slow[0], slow[1], 0.0), (0.0, 0.0, 0.0)),
    ]
    times = [FIRST_COMMAND + k * COMMAND_TIME for k in range(4)]
    times.append(times[-1] + PUSH_TIME + PUSH_COUNT * PUSH_INTERVAL)
    return tuple(
        VelocityRequest(*velocity, round(time, 2))
        for velocity, time in zip(velocities, times, strict=True)
    )
