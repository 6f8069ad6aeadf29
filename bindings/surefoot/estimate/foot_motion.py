"""Kinematics of the feet relative to the base, for every row."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot._core import Robot
from surefoot.geometry.batch_rotations import Array


@dataclass(frozen=True)
class FootMotion:
    """Motion of the four feet relative to the base, base axes.

    Attributes:
        centre: (n, 4, 3) centre of the spherical foot [m].
        velocity: (n, 4, 3) velocity of the centre relative to the base [m/s].
        angular_velocity: (n, 4, 3) angular velocity of the foot relative to the base [rad/s].
    """

    centre: Array
    velocity: Array
    angular_velocity: Array


def foot_motion(robot: Robot, q: Array, dq: Array) -> FootMotion:
    """Compute the motion of the feet with Pinocchio.

    Args:
        robot: Robot model.
        q: (n, 12) joint angles in motor order [rad].
        dq: (n, 12) joint velocities in motor order [rad/s].
    """
    import pinocchio  # not at the top of the file, because the import takes a second

    n = len(q)
    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    data, feet = model.createData(), list(robot.foot_frame_ids)
    # The base is at the origin and at rest, so velocities are relative to the base.
    configuration, v = np.tile(pinocchio.neutral(model), (n, 1)), np.zeros((n, model.nv))
    configuration[:, list(robot.motor_to_q)], v[:, list(robot.motor_to_v)] = q, dq
    centre, twist = np.zeros((n, 4, 3)), np.zeros((n, 4, 6))
    axes = pinocchio.LOCAL_WORLD_ALIGNED
    for k in range(n):
        pinocchio.forwardKinematics(model, data, configuration[k], v[k])
        for leg, frame in enumerate(feet):
            centre[k, leg] = pinocchio.updateFramePlacement(model, data, frame).translation
            twist[k, leg] = pinocchio.getFrameVelocity(model, data, frame, axes).vector
    return FootMotion(centre, twist[:, :, :3], twist[:, :, 3:])
