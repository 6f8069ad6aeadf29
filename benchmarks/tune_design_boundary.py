# SPDX-License-Identifier: BSD-3-Clause
"""Gains at which the closed loop starts to oscillate: compare surefoot tune design and simulation.

    python benchmarks/tune_design_boundary.py [ROBOT ...]

The first table has a row for each robot, axis and additional delay. It shows the factor on kp and
kd (of 2 Hz and damping 0.8) above which a push along the axis causes a lasting oscillation. The
simulated factor is found by bisection to 3 %. The second table shows the factors of lateral motion,
with a quarter of the joint friction and with all of it.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "tests" / "closed_loop"))

from design_helpers import GOAL, body_of, comes_to_rest, gains_with_factor
from surefoot.tune.design import (
    AXES,
    ClosedLoop,
    Direction,
    Observers,
    Timing,
    oscillation_boundary,
)

DELAYS = (0.004, 0.012)  # [s] additional delays of commands
MAX_FACTOR = 200.0 / GOAL.kd  # largest factor: kd may be at most 200 1/s


def predicted_factor(robot: str, axis: str, delay: float) -> float:
    """Return the factor that the model predicts, for the least robust direction of the axis."""
    body = body_of(robot)
    observers = Observers.of(body.robot.config.gains)
    return min(
        oscillation_boundary(
            ClosedLoop(direction, Timing(delay=delay), observers), GOAL.kp, GOAL.kd
        )
        for direction in body.axis_directions(axis)
    )


def measured_factor(
    robot: str,
    axis: str,
    delay: float,
    guess: float,
    directions: list[Direction],
    friction: float = 1.0,
) -> float:
    """Return the factor in simulation, found by bisection between half and twice the guess."""

    def stable(factor: float) -> bool:
        gains = gains_with_factor(robot, axis, factor)
        return all(
            comes_to_rest(robot, delay, gains, direction, friction) for direction in directions
        )

    low, high = 0.5 * guess, min(2.0 * guess, MAX_FACTOR)
    while high > 1.03 * low:
        middle = math.sqrt(low * high)
        low, high = (middle, high) if stable(middle) else (low, middle)
    return math.sqrt(low * high)


def print_sideways(robots: list[str]) -> None:
    """Print the factors for y only, with a quarter of the joint friction and with all of it."""
    print("\n| robot | additional delay [ms] | y, a quarter of the friction | all of it |")
    print("|---|---|---|---|")
    for robot in robots:
        sideways = [body_of(robot).directions["y"]]
        for delay in DELAYS:
            guess = predicted_factor(robot, "sway", delay)
            found = [measured_factor(robot, "sway", delay, guess, sideways, f) for f in (0.25, 1.0)]
            print(f"| {robot} | {1000.0 * delay:g} | {found[0]:.2f} | {found[1]:.2f} |", flush=True)


def main() -> None:
    """Print both tables."""
    robots = sys.argv[1:] or ["a1", "go1", "go2", "b1"]
    print("| robot | axis | additional delay [ms] | predicted | measured | ratio |")
    print("|---|---|---|---|---|---|")
    for robot in robots:
        for delay in DELAYS:
            for axis in AXES:
                p = predicted_factor(robot, axis, delay)
                m = measured_factor(robot, axis, delay, p, body_of(robot).axis_directions(axis))
                print(
                    f"| {robot} | {axis} | {1000.0 * delay:g} | {p:.2f} | {m:.2f} | {m / p:.2f} |",
                    flush=True,
                )
    print_sideways(robots)


if __name__ == "__main__":
    main()
