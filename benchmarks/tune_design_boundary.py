# SPDX-License-Identifier: BSD-3-Clause
"""Where gains start to oscillate: predicted by surefoot tune design, and found in simulation.

    python benchmarks/tune_design_boundary.py [ROBOT ...]

For each robot, axis and further delay: the factor on kp and kd (of 2 Hz, damping 0.8) from which
a kick along any of the axis's directions leaves an oscillation, by bisection to 3 %.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "tests" / "closed_loop"))

from design_helpers import GOAL, body_of, gains_of, rests
from surefoot.tune.design import AXES, ClosedLoop, Observers, Timing, oscillation_boundary

DELAYS = (0.004, 0.012)  # [s]
MOST = 200.0 / GOAL.kd  # times: kd may be 200 1/s


def predicted(robot: str, axis: str, delay: float) -> float:
    """Return the model's factor, in the direction that bears least."""
    body = body_of(robot)
    observers = Observers.of(body.robot.config.gains)
    return min(
        oscillation_boundary(
            ClosedLoop(direction, Timing(delay=delay), observers), GOAL.kp, GOAL.kd
        )
        for direction in body.of_axis(axis)
    )


def measured(robot: str, axis: str, delay: float, guess: float) -> float:
    """Return the simulated robot's factor, looked for between half a guess and twice."""
    directions = body_of(robot).of_axis(axis)

    def stable(factor: float) -> bool:
        gains = gains_of(robot, axis, factor)
        return all(rests(robot, delay, gains, direction) for direction in directions)

    low, high = 0.5 * guess, min(2.0 * guess, MOST)
    while high > 1.03 * low:
        middle = math.sqrt(low * high)
        low, high = (middle, high) if stable(middle) else (low, middle)
    return math.sqrt(low * high)


def main() -> None:
    """Print the table."""
    robots = sys.argv[1:] or ["a1", "go1", "go2", "b1"]
    print("| robot | axis | further delay [ms] | predicted | measured | ratio |")
    print("|---|---|---|---|---|---|")
    for robot in robots:
        for delay in DELAYS:
            for axis in AXES:
                p = predicted(robot, axis, delay)
                m = measured(robot, axis, delay, p)
                print(
                    f"| {robot} | {axis} | {1000.0 * delay:g} | {p:.2f} | {m:.2f} | {m / p:.2f} |",
                    flush=True,
                )


if __name__ == "__main__":
    main()
