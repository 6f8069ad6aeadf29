"""Paths of the feet relative to the IMU, on a grid of times, for every order of the legs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot._core import Robot
from surefoot.estimate.checks.walking.samples import finite_samples, interpolated
from surefoot.estimate.foot_placements import foot_jacobians, foot_placements
from surefoot.geometry.batch_rotations import Array, rotation_vectors
from surefoot.sensor_log.sensor_log import SensorLog

# [s] Step of the grid. Chosen: at least ten samples in the shortest stance, 0.1 s.
STEP = 0.01
# [s] Longest analysed part of a log, from the first motion on. Chosen: many times the 10 s in which
# a fault shows; bounds time (a second) and memory for long logs.
MAX_DURATION = 120.0
MIN_DURATION = 1.0  # [s] shortest log that is analysed. Chosen: two strides
# [rad] Change of a joint angle within a second that counts as motion. Chosen: a step bends a calf
# further.
MIN_MOTION = 0.1
# [s] Longest step of the clock that the joint angles are interpolated over. Chosen: four samples
# at 200 Hz; in a longer gap a swing foot moves by several centimetres.
MAX_GAP = 0.02


@dataclass(frozen=True)
class LegPaths:
    """Paths of the feet, if leg k is mounted at the place of leg s; base axes, from the IMU.

    A foot in stance rolls on its spherical sole. The point of the foot that would stay in place is
    the contact point, so the paths are those of a point that moves with the foot and starts below
    its centre.

    Attributes:
        time: (n,) [s], step STEP.
        valid: (n,) false in gaps of the log.
        angles: (n, 12) joint angles [rad].
        height: (n, 4) height of the foot centres in the logged order, base axes [m].
        path: (n, 4, 4, 3) path of the foot of leg k at place s, without the distance that the foot
            has rolled [m]; indices n, s, k, xyz.
        arm: (n, 4, 4, 3) from the IMU to the contact point [m].
        jacobian: (n, 4, 3, 3) derivative of the path in the logged order with respect to the
            angles of hip, thigh and calf [m/rad].
    """

    time: Array
    valid: npt.NDArray[np.bool_]
    angles: Array
    height: Array
    path: Array
    arm: Array
    jacobian: Array

    @property
    def calf(self) -> Array:
        """(n, 4, 3) derivative of the path with respect to the angle of the calf [m/rad]."""
        return np.asarray(self.jacobian[:, :, :, 2])


def leg_paths(robot: Robot, log: SensorLog) -> LegPaths | None:
    """Compute the paths of the feet for up to MAX_DURATION; None if the log is too short."""
    time, (q, _, _) = finite_samples(log, "q", "gyroscope", "accelerometer")
    if len(time) < 2 or time[-1] - time[0] < MIN_DURATION:
        return None
    start = _first_motion(time, q)
    grid = np.arange(start, min(time[-1], start + MAX_DURATION), STEP)
    following = np.clip(np.searchsorted(time, grid), 1, len(time) - 1)
    valid = time[following] - time[following - 1] < MAX_GAP
    angles = interpolated(grid, time, q)
    n = len(grid)
    path, arm = np.zeros((n, 4, 4, 3)), np.zeros((n, 4, 4, 3))
    height = np.zeros((n, 4))
    for shift in range(4):
        legs = (np.arange(4) + shift) % 4
        moved, point, centre = _contact_paths(robot, angles.reshape(n, 4, 3)[:, legs])
        path[:, np.arange(4), legs], arm[:, np.arange(4), legs] = moved, point
        height = centre[:, :, 2] if shift == 0 else height
    jacobian = foot_jacobians(robot, angles)
    return LegPaths(grid, valid, angles, height, path, arm, jacobian)


def _first_motion(time: Array, q: Array) -> float:
    """Return the time up to two seconds before the first motion of a joint [s]."""
    seconds = np.unique(np.floor(time), return_index=True)[1]
    if len(seconds) < 2:
        return float(time[0])
    ranges = np.maximum.reduceat(q, seconds) - np.minimum.reduceat(q, seconds)
    first = int(np.argmax(np.any(ranges > MIN_MOTION, axis=1)))
    return float(time[seconds[max(first - 2, 0)]])


def _contact_paths(robot: Robot, angles: Array) -> tuple[Array, Array, Array]:
    """Return path, arm and foot centres (n, 4, 3) for joint angles (n, 4, 3), by place."""
    centre, rotation = foot_placements(robot, angles.reshape(-1, 12))
    down = np.array([0.0, 0.0, -robot.config.foot_radius])
    n = len(angles)
    turn = np.swapaxes(rotation[:-1], 2, 3).reshape(-1, 3, 3)
    turn = rotation[1:].reshape(-1, 3, 3) @ turn
    steps = np.cross(rotation_vectors(turn).reshape(n - 1, 4, 3), down)
    rolled = np.concatenate([np.zeros((1, 4, 3)), np.cumsum(steps, axis=0)])
    from_imu = centre - robot.config.p_base_imu
    return from_imu + rolled, from_imu + down, centre
