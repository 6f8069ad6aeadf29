"""Episodes: simulated runs with random disturbances that a seed determines."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any, Protocol

import numpy as np

from surefoot._core import Gains
from surefoot.robot.loading import RobotDescription, describe_robot
from surefoot.sim import Plant
from surefoot.sim.settings import COARSE_DT
from surefoot.tune.cost import Cost

# The following ranges of robots and grounds are chosen, not measured on real ones.
MAX_PAYLOAD_SHARE = 0.2  # greatest payload as a share of the robot's mass
FRICTION_RANGE = 0.5, 1.0  # range of the friction coefficient of the ground
JOINT_FRICTION_RANGE = 0.5, 2.0  # range of the factor on the joint friction of the model
# Derived: the seeds of a search stay below both values, so that no episode is used twice.
FINAL_SEED = 5_000  # first seed of the episodes that choose between the best trials
HELD_OUT_SEED = 10_000  # first seed of the episodes that only evaluate the result

RobotSource = str | tuple[str, str]
"""A name of surefoot.available_robots(), or the paths of a URDF and a TOML."""


class Episode(Hashable, Protocol):
    """One simulated run on which trials are evaluated. Episodes can be pickled and compared."""

    def plant(self) -> Plant:
        """Return the plant with its pushes; raise Error if the robot or a setting is invalid."""
        ...

    def simulate(
        self, plant: Plant, gains: Gains, on_tick: Callable[[int], None] | None = None
    ) -> Any:
        """Run the episode and return its record, whose len() is the number of ticks.

        Without `on_tick`, a fall ends the episode.

        Args:
            plant: Result of plant(). The method resets the plant first.
            gains: Gains of the controller.
            on_tick: Called after each tick with its number.
        """
        ...

    def cost(self, record: Any, objective: str) -> Cost:
        """Return the cost of a result of simulate()."""
        ...


def random_settings(rng: np.random.Generator, mass: float, max_delay_steps: int) -> dict[str, Any]:
    """Return random plant settings by name: payload, friction, delay, joint friction.

    Args:
        rng: Source of random numbers.
        mass: Mass of the robot [kg].
        max_delay_steps: Greatest additional delay of commands, in steps of COARSE_DT.
    """
    x, y = (0.03 * rng.uniform(-1.0, 1.0, 2)).tolist()
    return {
        "physics_dt": COARSE_DT,
        "payload_kg": float(MAX_PAYLOAD_SHARE * mass * rng.uniform()),
        "payload_position": (x, y, 0.05),
        "friction": float(rng.uniform(*FRICTION_RANGE)),
        "extra_delay": COARSE_DT * int(rng.integers(max_delay_steps + 1)),
    }


def find_robot(robot: RobotSource) -> RobotDescription:
    """Find the files of a robot by its name, or by its URDF and TOML.

    Raises:
        Error: The name is unknown, or a file is missing or invalid.
    """
    if isinstance(robot, str):
        return describe_robot(robot)
    return describe_robot(urdf=robot[0], config=robot[1])
