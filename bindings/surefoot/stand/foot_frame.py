"""Base and foot geometry over a whole run: headings, and base poses relative to the feet."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot._core import Robot
from surefoot.geometry.batch_rotations import matrices_from_xyzw, rpy_from_matrices
from surefoot.stand.simulation_log import Array

_FRONT_REAR_SIGNS = np.array([1.0, 1.0, -1.0, -1.0])  # front feet FR FL minus rear feet RR RL


@dataclass(frozen=True)
class FootFramePose:
    """Poses of the base over a run, in a frame at the mean of the four feet.

    The x axis of this frame points along the heading of the feet. The z axis is world z for
    pose_from_feet(), and the normal of the plane of the feet for pose_in_support().

    Attributes:
        position: (n, 3) position of the base [m].
        rotation: (n, 3, 3) rotation from base axes to the frame.
    """

    position: Array
    rotation: Array

    @property
    def rpy(self) -> Array:
        """(n, 3) roll, pitch, yaw [rad] with rotation = Rz(yaw) Ry(pitch) Rx(roll)."""
        return rpy_from_matrices(self.rotation)

    @property
    def rows_mm_deg(self) -> Array:
        """(n, 6) x, y, z [mm], roll, pitch, yaw [deg]; the angles have no jumps of 360 deg."""
        return np.hstack([1000.0 * self.position, np.degrees(np.unwrap(self.rpy, axis=0))])


def matrices_from_rpy(rpy: Array) -> Array:
    """Return the matrices (n, 3, 3) Rz(yaw) Ry(pitch) Rx(roll) of angles (n, 3) [rad]."""
    half = 0.5 * rpy
    (cr, cp, cy), (sr, sp, sy) = np.cos(half).T, np.sin(half).T
    quaternions = [
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    ]
    return matrices_from_xyzw(np.stack(quaternions, axis=1))


def up_in_base(q: Array) -> Array:
    """Return the world z axis in base axes (n, 3) for Pinocchio configurations q (n, nq)."""
    return matrices_from_xyzw(q[:, 3:7])[:, 2, :]


def feet_heading(feet: Array) -> Array:
    """Return the headings (n,) [rad] of feet (n, 3, 4): the direction from rear to front feet."""
    forward = feet @ _FRONT_REAR_SIGNS
    return np.asarray(np.arctan2(forward[:, 1], forward[:, 0]))


def pose_from_feet(q: Array, feet: Array) -> FootFramePose:
    """Return the poses of the base in a frame at the mean of the feet, with z vertical.

    Args:
        q: (n, nq) Pinocchio configurations.
        feet: (n, 3, 4) foot positions in the same world frame [m].
    """
    heading = feet_heading(feet)
    c, s, o = np.cos(heading), np.sin(heading), np.zeros_like(heading)
    to_frame = np.moveaxis(np.array([[c, s, o], [-s, c, o], [o, o, o + 1.0]]), 2, 0)
    offset = q[:, :3] - feet.mean(axis=2)
    return FootFramePose(
        np.einsum("nij,nj->ni", to_frame, offset),
        to_frame @ matrices_from_xyzw(q[:, 3:7]),
    )


def pose_in_support(q: Array, feet: Array) -> FootFramePose:
    """Return the poses of the base in the support frame, the frame of BodyReference.

    The z axis is normal to both diagonals of the feet. The x axis points along the heading of the
    feet, in the plane of the feet.

    Args:
        q: (n, nq) Pinocchio configurations.
        feet: (n, 3, 4) foot positions in the same world frame [m].
    """
    diagonals = feet[:, :, 1] - feet[:, :, 2], feet[:, :, 3] - feet[:, :, 0]
    z = np.cross(*diagonals)
    z /= np.linalg.norm(z, axis=1, keepdims=True)
    forward = feet @ _FRONT_REAR_SIGNS
    y = np.cross(z, forward)
    y /= np.linalg.norm(y, axis=1, keepdims=True)
    to_frame = np.stack([np.cross(y, z), y, z], axis=1)
    offset = q[:, :3] - feet.mean(axis=2)
    return FootFramePose(
        np.einsum("nij,nj->ni", to_frame, offset),
        to_frame @ matrices_from_xyzw(q[:, 3:7]),
    )


def foot_positions(robot: Robot, q: Array) -> Array:
    """Compute the foot positions (n, 3, 4) [m] in the world frame of configurations q (n, nq)."""
    import pinocchio  # imported here because only reports need it

    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    data = model.createData()
    feet = np.zeros((len(q), 3, 4))
    for k, row in enumerate(q):
        pinocchio.forwardKinematics(model, data, row)
        for leg, frame in enumerate(robot.foot_frame_ids):
            feet[k, :, leg] = pinocchio.updateFramePlacement(model, data, frame).translation
    return feet


def angle_between(a: Array, b: Array) -> Array:
    """Return the angles (n,) [rad] between vectors a and b (n, 3); accurate for small angles."""
    cross = np.linalg.norm(np.cross(a, b), axis=-1)
    return np.asarray(np.arctan2(cross, np.sum(a * b, axis=-1)))


def rotation_angle(rotation: Array) -> Array:
    """Return the angles (n,) [rad] of rotation matrices (n, 3, 3)."""
    R = rotation
    axis = np.stack(
        [R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], axis=1
    )
    # The norm of `axis` is 2 sin(angle). The trace minus 1 is 2 cos(angle).
    doubled_cosine = np.trace(R, axis1=1, axis2=2) - 1.0
    return np.asarray(np.arctan2(np.linalg.norm(axis, axis=1), doubled_cosine))


def wrap_angle(angle: Array) -> Array:
    """Return angles [rad], wrapped to -pi .. pi."""
    return (angle + np.pi) % (2.0 * np.pi) - np.pi
