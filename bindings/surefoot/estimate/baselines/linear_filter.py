"""Linear Kalman filter of position, velocity and four feet, as in MIT's Cheetah-Software."""

from __future__ import annotations

import numpy as np

from surefoot.estimate.base_motion import BaseMotion
from surefoot.estimate.baselines.inputs import BaselineInputs
from surefoot.estimate.baselines.odometry_velocity import contact_velocity, roll_velocity
from surefoot.estimate.foot_motion import FootMotion
from surefoot.geometry.batch_rotations import Array

# Noise of config/mini-cheetah-defaults.yaml, and the factors of PositionVelocityEstimator.cpp.
IMU_POSITION_NOISE, IMU_VELOCITY_NOISE, FOOT_NOISE = 0.02 / 20.0, 0.02 * 9.8 / 20.0, 0.002
RELATIVE_POSITION_NOISE, RELATIVE_VELOCITY_NOISE, FOOT_HEIGHT_NOISE = 0.001, 0.1, 0.001
SUSPICION = 100.0  # factor of the noise of a foot without trust (high_suspect_number)
START_VARIANCE = 100.0
# [m^2] Variance of the horizontal position above which it is cut to a tenth and decoupled.
HORIZONTAL_VARIANCE_LIMIT = 1e-3
GRAVITY = 9.81  # [m/s^2]


class AxisFilter:
    """Filter of one axis; the three axes of the filter are independent of each other.

    State: position, velocity, position of four feet. Measurements: position and velocity relative
    to each foot; on the vertical axis also the height of each foot.

    Args:
        vertical: True for the vertical axis.
    """

    def __init__(self, vertical: bool) -> None:
        self.vertical = vertical
        one, feet = np.ones((4, 1)), np.eye(4)
        rows = [[one, 0 * one, -feet], [0 * one, one, 0 * feet]]
        self._C = np.block(rows + [[0 * one, 0 * one, feet]] * vertical)
        noise = [RELATIVE_POSITION_NOISE, RELATIVE_VELOCITY_NOISE, FOOT_HEIGHT_NOISE]
        self._R = np.repeat(noise, 4)[: len(self._C)]
        self._P = START_VARIANCE * np.eye(6)

    def gain(self, dt: float, trust: Array) -> Array:
        """Predict and correct the covariance; return the Kalman gain (6, m) of this row."""
        A = np.eye(6)
        A[0, 1] = dt
        suspicion = 1.0 + (1.0 - trust) * SUSPICION
        Q = np.concatenate([[IMU_POSITION_NOISE, IMU_VELOCITY_NOISE], FOOT_NOISE * suspicion])
        R = self._R.copy()
        R[4:] *= np.tile(suspicion, len(R) // 4 - 1)
        P = A @ self._P @ A.T + np.diag(dt * Q)
        PCt = P @ self._C.T
        K = np.linalg.solve(self._C @ PCt + np.diag(R), PCt.T).T
        P = P - K @ PCt.T
        self._P = 0.5 * (P + P.T)
        if not self.vertical and self._P[0, 0] > HORIZONTAL_VARIANCE_LIMIT:
            self._P[0, 1:] = self._P[1:, 0] = 0.0
            self._P[0, 0] /= 10.0
        return np.asarray(K)


def linear_filter(
    inputs: BaselineInputs, rotation: Array, feet: FootMotion, trust: Array
) -> BaseMotion:
    """Run the filter over all rows; trust (n, 4) of each foot.

    It is LinearKFPositionVelocityEstimator of Cheetah-Software with its constants, but for two
    changes that favour it: spherical feet roll, and the end of each stance is known
    (stance_trust()).
    """
    n = len(inputs.time)
    dt = np.diff(inputs.time, prepend=inputs.time[0] - inputs.period)
    a = np.einsum("nij,nj->ni", rotation, inputs.accelerometer) - [0.0, 0.0, GRAVITY]
    relative = np.einsum("nij,nfj->nfi", rotation, feet.centre)
    leg_velocity = contact_velocity(inputs, rotation, feet)
    roll = roll_velocity(inputs, rotation, feet) * trust[:, :, None] * dt[:, None, None]
    radius = inputs.robot.config.foot_radius
    horizontal, vertical = AxisFilter(False), AxisFilter(True)
    x = _start(relative[0], radius)  # (6, 3)
    position, velocity = np.zeros((n, 3)), np.zeros((n, 3))
    for k in range(n):
        t = trust[k][:, None]
        v0, z0 = x[1].copy(), x[0, 2]
        x[0] += dt[k] * x[1]
        x[1] += dt[k] * a[k]
        x[2:] += roll[k]
        y = np.concatenate([-relative[k], (1.0 - t) * v0 - t * leg_velocity[k]])
        model = np.concatenate([x[0] - x[2:], np.tile(x[1], (4, 1))])
        height = t[:, 0] * radius + (1.0 - t[:, 0]) * (z0 + relative[k, :, 2])
        x[:, :2] += horizontal.gain(dt[k], trust[k]) @ (y - model)[:, :2]
        innovation = np.concatenate([(y - model)[:, 2], height - x[2:, 2]])
        x[:, 2] += vertical.gain(dt[k], trust[k]) @ innovation
        position[k], velocity[k] = x[0], x[1]
    return BaseMotion(rotation, position, velocity)


def _start(relative: Array, radius: float) -> Array:
    """Return the state (6, 3) of a robot at rest with its feet on the ground."""
    x = np.zeros((6, 3))
    x[0, 2] = radius - relative[:, 2].mean()
    x[2:] = x[0] + relative
    return x
