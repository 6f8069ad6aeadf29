"""Positions and orientations of the feet relative to the base, for many rows of joint angles."""

from __future__ import annotations

import numpy as np

from surefoot._core import Robot
from surefoot.geometry.batch_rotations import Array


def foot_placements(robot: Robot, q: Array) -> tuple[Array, Array]:
    """Compute the placements of the feet with Pinocchio.

    Args:
        robot: Robot model.
        q: (n, 12) joint angles in motor order [rad].

    Returns:
        Centres (n, 4, 3) of the spherical feet in base axes [m], and rotation matrices
        (n, 4, 3, 3) from foot axes to base axes.
    """
    import pinocchio  # not at the top of the file, because the import takes a second

    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    data, feet = model.createData(), list(robot.foot_frame_ids)
    configuration = np.tile(pinocchio.neutral(model), (len(q), 1))  # the base is at the origin
    configuration[:, list(robot.motor_to_q)] = q
    centre, rotation = np.zeros((len(q), 4, 3)), np.zeros((len(q), 4, 3, 3))
    for k in range(len(q)):
        pinocchio.forwardKinematics(model, data, configuration[k])
        for leg, frame in enumerate(feet):
            placement = pinocchio.updateFramePlacement(model, data, frame)
            centre[k, leg], rotation[k, leg] = placement.translation, placement.rotation
    return centre, rotation
