"""The same push on two sets of gains, one after the other, aside from what the page shows."""

from __future__ import annotations

from surefoot._core import Gains
from surefoot.robot.description import RobotDescription
from surefoot.tune.cost import Cost
from surefoot.tune.live.push_score import SCORE_TIME
from surefoot.tune.live.simulation import Simulation
from surefoot.tune.live.world import World

_STAND_TIME = 1.0  # [s] of standing before the push


def push_cost(
    description: RobotDescription, world: World, gains: Gains, degrees: float, percent: float
) -> Cost:
    """Return what a push costs a robot that stands on these gains.

    Args:
        description: The robot's files.
        world: Where it stands.
        gains: What it stands on.
        degrees: Of the push, from forward towards left [deg].
        percent: Of what the linear inverted pendulum survives.

    Raises:
        Error: The robot cannot stand there.
    """
    simulation = Simulation(description, gains, world)
    for _ in range(round(_STAND_TIME / simulation.period)):
        simulation.tick()
    simulation.push(degrees, percent)
    for _ in range(round(SCORE_TIME / simulation.period)):
        simulation.tick()
    assert simulation.score.last_cost is not None  # its time is over
    return simulation.score.last_cost
