"""Accelerations that the QP achieves for given desired accelerations, from its solutions."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot._core import Gains, Robot, RobotState, WholeBodyController

Array = npt.NDArray[np.float64]

GRAVITY = 9.81  # [m/s^2]
# Desired accelerations for which the QP is solved, [g] and [g / height].
# Chosen: denser near 1 g, where a falling body loses its contact forces.
_LINEAR_LEVELS = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 4.0)
_ANGULAR_LEVELS = (0.5, 1.0, 1.5, 2.0, 4.0, 8.0, 16.0)


def qp_limits(robot: Robot, height: float, gains: Gains) -> list[Array]:
    """Solve the QP of a standing robot for a range of desired accelerations.

    Args:
        robot: The robot, in its standing pose.
        height: Height of the centre of mass above the ground [m].
        gains: Gains of the controller.

    Returns:
        A table (n, 2) for each of DIRECTION_NAMES, with increasing rows: desired acceleration and
        achieved acceleration [m/s^2 or rad/s^2].
    """
    controller = WholeBodyController(robot, gains)
    state = RobotState(robot.nq, robot.nv)
    state.q = robot.q_standing()
    reference = controller.hold(state)
    out = []
    for k in range(6):
        levels = (
            GRAVITY * np.array(_LINEAR_LEVELS)
            if k < 3
            else GRAVITY / height * np.array(_ANGULAR_LEVELS)
        )
        sides = []
        for sign in (-1.0, 1.0):
            achieved = []
            for level in levels:
                desired = np.zeros(6)
                desired[k] = sign * level
                reference.a_com, reference.alpha_world_base = desired[:3], desired[3:]
                controller.reset()
                solution = controller.update(state, reference)
                forces = np.asarray(solution.forces)
                pull = forces[k].sum() / robot.mass - GRAVITY * (k == 2) if k < 3 else 0.0
                achieved.append(sign * (pull if k < 3 else solution.accelerations[k]))
            # Beyond a limit, the achieved acceleration may decrease slightly; the table must not.
            sides.append(np.column_stack([levels, np.maximum.accumulate(achieved)]))
        out.append(np.vstack([-sides[0][::-1], np.zeros((1, 2)), sides[1]]))
    return out
