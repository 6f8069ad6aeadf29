"""Leg odometry: the velocity of the base is minus the mean velocity of the stance feet."""

from __future__ import annotations

import numpy as np

from surefoot.estimate.base_motion import BaseMotion
from surefoot.estimate.baselines.inputs import BaselineInputs
from surefoot.estimate.baselines.odometry_velocity import contact_velocity
from surefoot.estimate.foot_motion import FootMotion
from surefoot.geometry.batch_rotations import Array


def leg_odometry(
    inputs: BaselineInputs, rotation: Array, feet: FootMotion, trust: Array
) -> BaseMotion:
    """Integrate the mean of minus the velocities of the contact points, weighted by trust (n, 4).

    While no foot is trusted, the velocity keeps its last value.
    """
    weight = trust.sum(axis=1)
    total = np.einsum("nf,nfi->ni", trust, -contact_velocity(inputs, rotation, feet))
    velocity = total / np.maximum(weight, 1e-9)[:, None]
    last = np.maximum.accumulate(np.where(weight > 0.0, np.arange(len(weight)), -1))
    velocity = np.where(last[:, None] >= 0, velocity[np.maximum(last, 0)], 0.0)
    dt = np.diff(inputs.time, prepend=inputs.time[0])[:, None]
    return BaseMotion(rotation, np.cumsum(velocity * dt, axis=0), velocity)
