# SPDX-License-Identifier: BSD-3-Clause
"""Where gains start to oscillate: predicted by surefoot tune design, and found in simulation.

    python benchmarks/tune_design_boundary.py [ROBOT ...]

For each robot, axis and further delay: the factor on kp and kd (of 2 Hz, damping 0.8) from which
a kick along any of the axis's directions leaves an oscillation, by bisection to 3 %. Then what the
joints' friction does for sideways motion: the same with a quarter of it and with all.
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

DELAYS = (0.004, 0.012)  # [s]
MAX_FACTOR = 200.0 / GOAL.kd  # times: kd may be 200 1/s


def predicted_factor(robot: str, axis: str, delay: float) -> float:
    """Return the model's factor, in the direction that bears least."""
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
    """Return the simulated robot's factor, looked for between half a guess and twice."""

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
    """Print the boundaries of y alone, with a quarter of the joints' friction and with all."""
    print("\n| robot | further delay [ms] | y, a quarter of the friction | all of it |")
    print("|---|---|---|---|")
    for robot in robots:
        sideways = [body_of(robot).directions["y"]]
        for delay in DELAYS:
            guess = predicted_factor(robot, "sway", delay)
            found = [measured_factor(robot, "sway", delay, guess, sideways, f) for f in (0.25, 1.0)]
            print(f"| {robot} | {1000.0 * delay:g} | {found[0]:.2f} | {found[1]:.2f} |", flush=True)


def main() -> None:
    """Print the table."""
    robots = sys.argv[1:] or ["a1", "go1", "go2", "b1"]
    print("| robot | axis | further delay [ms] | predicted | measured | ratio |")
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
