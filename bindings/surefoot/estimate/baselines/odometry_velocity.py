"""Velocity of the base that each foot would give if it stood."""

from __future__ import annotations

import numpy as np

from surefoot.estimate.baselines.inputs import BaselineInputs
from surefoot.estimate.foot_motion import FootMotion
from surefoot.geometry.batch_rotations import Array


def contact_velocity(inputs: BaselineInputs, rotation: Array, feet: FootMotion) -> Array:
    """Return the velocity (n, 4, 3) [m/s] of each contact point relative to the base origin.

    The velocity is in world axes and includes the rotation of the base. The contact point is the
    lowest point of the spherical foot on level ground. Where a foot rolls without slip, this
    velocity is minus the velocity of the base.
    """
    radius = inputs.robot.config.foot_radius
    down = -radius * rotation[:, None, 2, :]  # (n, 1, 3) centre to contact point, base axes
    omega = inputs.gyroscope[:, None, :]
    arm = np.cross(omega + feet.angular_velocity, down)
    velocity = feet.velocity + np.cross(omega, feet.centre) + arm
    return np.asarray(np.einsum("nij,nfj->nfi", rotation, velocity))


def roll_velocity(inputs: BaselineInputs, rotation: Array, feet: FootMotion) -> Array:
    """Return the velocity (n, 4, 3) [m/s], world axes, of the centre of a foot that rolls."""
    up = inputs.robot.config.foot_radius * rotation[:, None, 2, :]
    omega = inputs.gyroscope[:, None, :] + feet.angular_velocity
    return np.asarray(np.einsum("nij,nfj->nfi", rotation, np.cross(omega, up)))
