"""Inputs of the baselines: sensor rows in base axes, with the contact of each foot."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot._core import Robot
from surefoot.geometry.batch_rotations import Array, matrices_from_xyzw


@dataclass(frozen=True)
class BaselineInputs:
    """Rows of a log for the baselines.

    Attributes:
        robot: Robot model.
        time: (n,) time, strictly increasing [s].
        gyroscope: (n, 3) base axes [rad/s].
        accelerometer: (n, 3) specific force, base axes [m/s^2].
        q: (n, 12) joint angles in motor order [rad].
        dq: (n, 12) joint velocities in motor order [rad/s].
        contact: (n, 4) true for a loaded foot, FR FL RR RL.
    """

    robot: Robot
    time: Array
    gyroscope: Array
    accelerometer: Array
    q: Array
    dq: Array
    contact: npt.NDArray[np.bool_]

    @classmethod
    def from_imu(
        cls,
        robot: Robot,
        time: Array,
        gyroscope: Array,
        accelerometer: Array,
        q: Array,
        dq: Array,
        contact: npt.NDArray[np.bool_],
    ) -> BaselineInputs:
        """Return the inputs from an IMU in its own axes; RobotConfig.quat_base_imu rotates it."""
        w, x, y, z = robot.config.quat_base_imu
        R = matrices_from_xyzw(np.array([[x, y, z, w]]))[0]
        return cls(robot, time, gyroscope @ R.T, accelerometer @ R.T, q, dq, contact)

    @property
    def period(self) -> float:
        """Median step of the time [s]."""
        return float(np.median(np.diff(self.time)))
