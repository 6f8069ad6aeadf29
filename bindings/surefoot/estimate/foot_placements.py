"""Positions, orientations and Jacobians of the feet relative to the base, for many rows."""

from __future__ import annotations

from typing import Any

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
    pinocchio, model, data, configuration = _model(robot, q)
    feet = list(robot.foot_frame_ids)
    centre, rotation = np.zeros((len(q), 4, 3)), np.zeros((len(q), 4, 3, 3))
    for k in range(len(q)):
        pinocchio.forwardKinematics(model, data, configuration[k])
        for leg, frame in enumerate(feet):
            placement = pinocchio.updateFramePlacement(model, data, frame)
            centre[k, leg], rotation[k, leg] = placement.translation, placement.rotation
    return centre, rotation


def foot_jacobians(robot: Robot, q: Array) -> Array:
    """Compute the Jacobians (n, 4, 3, 3) [m/rad] of the foot centres in base axes.

    The last index is the joint of the leg: hip, thigh, calf.

    Args:
        robot: Robot model.
        q: (n, 12) joint angles in motor order [rad].
    """
    pinocchio, model, data, configuration = _model(robot, q)
    axes, feet = pinocchio.LOCAL_WORLD_ALIGNED, list(robot.foot_frame_ids)
    joints = np.array(robot.motor_to_v).reshape(4, 3)
    J = np.zeros((len(q), 4, 3, 3))
    for k in range(len(q)):
        pinocchio.computeJointJacobians(model, data, configuration[k])
        for leg, frame in enumerate(feet):
            full = pinocchio.getFrameJacobian(model, data, frame, axes)
            J[k, leg] = full[:3, joints[leg]]
    return J


def _model(robot: Robot, q: Array) -> tuple[Any, Any, Any, Array]:
    """Return Pinocchio, model, data and the configurations with the base at the origin."""
    import pinocchio  # not at the top of the file, because the import takes a second

    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    configuration = np.tile(pinocchio.neutral(model), (len(q), 1))
    configuration[:, list(robot.motor_to_q)] = q
    return pinocchio, model, model.createData(), configuration
