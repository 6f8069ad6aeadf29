"""Episodes: simulated runs with random disturbances that a seed determines."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from surefoot.robot.loading import RobotDescription, build_robot, describe_robot
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.sim.settings import COARSE_DT

# Derived: FIRST_PUSH_TIME + PUSH_COUNT PUSH_INTERVAL, so that the last push is settled.
EPISODE_TIME = 6.6  # [s] duration of an episode
# Chosen: the robot settles before the first push, and the interval is longer than the time to
# settle, about 1 s.
FIRST_PUSH_TIME, PUSH_INTERVAL, PUSH_COUNT = 0.6, 2.0, 3  # [s], [s], [pushes]
# Range of the impulse as a share of the LIP push limit. Chosen: pushes outside this range hardly
# distinguish gains, because with almost all gains the robot survives weaker pushes and falls after
# stronger ones.
PUSH_LIMIT_SHARE = 0.35, 0.8
# The following ranges of robots and grounds are chosen, not measured on real ones.
MAX_PAYLOAD_SHARE = 0.2  # greatest payload as a share of the robot's mass
FRICTION_RANGE = 0.5, 1.0  # range of the friction coefficient of the ground
# [physics steps] Greatest additional delay of commands. Chosen: 8 ms (8 times COARSE_DT), so that
# the gains found keep a delay margin.
MAX_DELAY_STEPS = 8
MOTOR_LAG_RANGE = 0.001, 0.004  # [s] range of the time constant of the motor torque
JOINT_FRICTION_RANGE = 0.5, 2.0  # range of the factor on the joint friction of the model
# Derived: the seeds of a search stay below both values, so that no episode is used twice.
FINAL_SEED = 5_000  # first seed of the episodes that choose between the best trials
HELD_OUT_SEED = 10_000  # first seed of the episodes that only evaluate the result


@dataclass(frozen=True)
class Episode:
    """One simulated run on which trials are evaluated.

    Attributes:
        robot: A name of surefoot.available_robots(), or the paths of a URDF and a TOML.
        seed: Seed of sensors, motors, ground, payload and pushes.
        settings: All other settings of the plant; settings.seed is not used.
    """

    robot: str | tuple[str, str]
    seed: int
    settings: PlantSettings

    def plant(self) -> Plant:
        """Return the plant with its pushes; raise Error if the robot or a setting is invalid."""
        rng = np.random.default_rng([self.seed, 7])
        description = find_robot(self.robot)
        settings = self._random_settings(rng, build_robot(description).mass)
        plant = Plant(description, settings)
        degrees, shares = (
            rng.uniform(-180.0, 180.0, PUSH_COUNT),
            rng.uniform(*PUSH_LIMIT_SHARE, PUSH_COUNT),
        )
        for k, (direction, share) in enumerate(zip(degrees.tolist(), shares, strict=True)):
            impulse = float(share) * plant.lip_push_limit(direction)
            plant.add_push(Push(direction, impulse, time=FIRST_PUSH_TIME + k * PUSH_INTERVAL))
        return plant

    def _random_settings(self, rng: np.random.Generator, mass: float) -> PlantSettings:
        x, y = (0.03 * rng.uniform(-1.0, 1.0, 2)).tolist()
        return replace(
            self.settings,
            seed=self.seed,
            physics_dt=COARSE_DT,
            payload_kg=float(MAX_PAYLOAD_SHARE * mass * rng.uniform()),
            payload_position=(x, y, 0.05),
            friction=float(rng.uniform(*FRICTION_RANGE)),
            extra_delay=COARSE_DT * int(rng.integers(MAX_DELAY_STEPS + 1)),
            motor_lag=float(rng.uniform(*MOTOR_LAG_RANGE)),
            joint_friction_scale=float(rng.uniform(*JOINT_FRICTION_RANGE)),
        )


def find_robot(robot: str | tuple[str, str]) -> RobotDescription:
    """Find the files of a robot by its name, or by its URDF and TOML.

    Raises:
        Error: The name is unknown, or a file is missing or invalid.
    """
    if isinstance(robot, str):
        return describe_robot(robot)
    return describe_robot(urdf=robot[0], config=robot[1])
