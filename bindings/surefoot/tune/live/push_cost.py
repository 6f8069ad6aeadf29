"""Cost of a push for a set of gains, in a separate simulation."""

from __future__ import annotations

from surefoot._core import Gains
from surefoot.robot.description import RobotDescription
from surefoot.tune.cost import Cost
from surefoot.tune.live.push_score import SCORE_TIME
from surefoot.tune.live.simulation import Simulation
from surefoot.tune.live.world import World

# Chosen: longer than STILL_TIME of the cost (0.4 s) and than the start of the estimator (0.15 s).
_STAND_TIME = 1.0  # [s] duration of standing before the push


def push_cost(
    description: RobotDescription, world: World, gains: Gains, degrees: float, percent: float
) -> Cost:
    """Simulate a push on a standing robot; return the cost of the run.

    Args:
        description: The robot's files.
        world: World of the simulation.
        gains: Gains of the controller.
        degrees: Direction of the push [deg]; 0: forward, 90: to the left.
        percent: Impulse in percent of the LIP push limit.

    Raises:
        Error: The robot cannot stand in this world.
    """
    simulation = Simulation(description, gains, world)
    for _ in range(round(_STAND_TIME / simulation.period)):
        simulation.tick()
    simulation.push(degrees, percent)
    for _ in range(round(SCORE_TIME / simulation.period)):
        simulation.tick()
    assert simulation.score.last_cost is not None  # SCORE_TIME has passed
    return simulation.score.last_cost
