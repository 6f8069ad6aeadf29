"""Episode of a stand: three pushes of random direction and strength."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from surefoot._core import Gains, StandController
from surefoot.robot.loading import build_robot
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.tune.cost import Cost, cost
from surefoot.tune.search.episodes import (
    JOINT_FRICTION_RANGE,
    RobotSource,
    find_robot,
    random_settings,
)
from surefoot.tune.trace import Trace

# Derived: FIRST_PUSH_TIME + PUSH_COUNT PUSH_INTERVAL, so that the last push is settled.
EPISODE_TIME = 6.6  # [s] duration of an episode
# Chosen: the robot settles before the first push, and the interval is longer than the time to
# settle, about 1 s.
FIRST_PUSH_TIME, PUSH_INTERVAL, PUSH_COUNT = 0.6, 2.0, 3  # [s], [s], [pushes]
# Range of the impulse as a share of the LIP push limit. Chosen: pushes outside this range hardly
# distinguish gains, because with almost all gains the robot survives weaker pushes and falls after
# stronger ones.
PUSH_LIMIT_SHARE = 0.35, 0.8
# [physics steps] Greatest additional delay of commands. Chosen: 8 ms (8 times COARSE_DT), so that
# the gains found keep a delay margin.
MAX_DELAY_STEPS = 8
MOTOR_LAG_RANGE = 0.001, 0.004  # [s] range of the time constant of the motor torque; chosen


@dataclass(frozen=True)
class StandEpisode:
    """One simulated stand.

    Attributes:
        robot: A name of surefoot.available_robots(), or the paths of a URDF and a TOML.
        seed: Seed of sensors, motors, ground, payload and pushes.
        settings: All other settings of the plant; settings.seed is not used.
    """

    robot: RobotSource
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

    def simulate(
        self, plant: Plant, gains: Gains, on_tick: Callable[[int], None] | None = None
    ) -> Trace:
        """Run the episode and return its trace; see Episode."""
        trace = Trace(plant, episode_ticks(plant))
        controller = StandController(plant.robot, gains)
        state = plant.reset()
        for k in range(episode_ticks(plant)):
            state = plant.step(controller.update(state))
            trace.record()
            if on_tick is not None:
                on_tick(k)
            elif trace.fell:
                break
        return trace

    def cost(self, record: Trace, objective: str) -> Cost:
        """Return the cost of a trace; `objective` is one of cost.OBJECTIVES."""
        return cost(record, objective, round(EPISODE_TIME * self.settings.control_rate))

    def _random_settings(self, rng: np.random.Generator, mass: float) -> PlantSettings:
        return replace(
            self.settings,
            seed=self.seed,
            **random_settings(rng, mass, MAX_DELAY_STEPS),
            motor_lag=float(rng.uniform(*MOTOR_LAG_RANGE)),
            joint_friction_scale=float(rng.uniform(*JOINT_FRICTION_RANGE)),
        )


def episode_ticks(plant: Plant) -> int:
    """Return the number of ticks of an episode on its plant."""
    return round(EPISODE_TIME * plant.settings.control_rate)
