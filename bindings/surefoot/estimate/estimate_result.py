"""Result of the estimator for each row of a log."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from surefoot._core import Robot
from surefoot.estimate.base_motion import BaseMotion
from surefoot.geometry.batch_rotations import Array, matrices_from_xyzw, rpy_from_matrices
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.sensor_log import SensorLog

IMU_SENSORS = ("gyroscope", "accelerometer", "quaternion")
FOOT_SENSORS = (
    "footForceEst",
    "footForce",
    "tauEst",
)  # the first entries of surefoot.ContactSource
SENSOR_NAMES = IMU_SENSORS + tuple(f"{name}[{leg}]" for name in FOOT_SENSORS for leg in LEGS)
"""Sensors that the estimator judges, in the order of Estimate.verdicts."""


@dataclass(frozen=True)
class Estimate:
    """One run of the estimator over a log.

    Row k is the estimate after row rows[k] of the log. Log rows that repeat the clock, or have no
    finite clock, are skipped. A rejected row repeats the last accepted row. Rows before the first
    accepted row are NaN. The origin of the world frame is below the first pose of the base, x has
    the first heading of the base, and z is up.

    Attributes:
        robot: Robot model.
        log: Log that was estimated.
        rows: (m,) index of each row in the log.
        time: (m,) time since the first row of the log [s].
        status: (m,) values of surefoot.Status.
        q: (m, nq) configuration as in Pinocchio: position, quaternion x y z w, joints.
        v: (m, nv) base twist in base axes [m/s, rad/s], joint velocities [rad/s].
        contact: (m, 4) contact confidence of each foot.
        std: (m, 15) standard deviations of the errors of rotation (world axes) [rad], v_world
            [m/s], p_world [m], gyroscope bias [rad/s], accelerometer bias [m/s^2].
        rotation_covariance: (m, 3, 3) covariance of the rotation error, world axes [rad^2].
        gyroscope_bias: (m, 3) estimated bias of the gyroscope, base axes [rad/s].
        accelerometer_bias: (m, 3) estimated bias of the accelerometer, base axes [m/s^2].
        nis: (m,) normalised innovation squared.
        nis_dimension: (m,) dimension of the innovation.
        slip: (m, 4) how sure the estimator is that a loaded foot slips, 0 .. 1.
        friction: (m,) learnt friction coefficient of the ground.
        contact_by_source: (m, 4, 4) evidence of each ContactSource for each foot: 0 off the
            ground, 1 loaded, 0.5 none.
        foot_forces_from_torques: (m, 4) vertical ground force from joint torques [N].
        refused: (m, 4) true if the innovation gate rejected the measurement of a foot.
        payload: (m,) mass beyond the model [kg].
        com_shift: (m, 3) centre of mass with payload minus that of the model, base axes [m].
        verdicts: (m, 15) values of surefoot.SensorVerdict for SENSOR_NAMES.
        update_us: (m,) time of StateEstimator.update() [us]; 0 where it was not called.
        derived: For each column that the log lacks, by name: the origin of its values, as text.
        non_finite: Number of rows with NaN or infinity, by column.
        duplicates: Number of rows that were skipped because they repeat the clock of another row.
        rows_without_time: Number of rows that were skipped because their clock is not finite.
        gaps: Number of steps longer than 0.1 s, the largest dt that the estimator receives.
        longest_gap: Longest step of the clock [s].
        warnings: Findings that make the log or the estimate doubtful.
        baselines: Motions (m) by other estimators, by name; empty without with_baselines().
    """

    robot: Robot
    log: SensorLog
    rows: npt.NDArray[np.int64]
    time: Array
    status: npt.NDArray[np.int64]
    q: Array
    v: Array
    contact: Array
    std: Array
    rotation_covariance: Array
    gyroscope_bias: Array
    accelerometer_bias: Array
    nis: Array
    nis_dimension: Array
    slip: Array
    friction: Array
    contact_by_source: Array
    foot_forces_from_torques: Array
    refused: Array
    payload: Array
    com_shift: Array
    verdicts: npt.NDArray[np.int64]
    update_us: Array
    derived: dict[str, str]
    non_finite: dict[str, int]
    duplicates: int
    rows_without_time: int
    gaps: int
    longest_gap: float
    warnings: tuple[str, ...]
    baselines: Mapping[str, BaseMotion] = field(default_factory=dict)

    @property
    def valid(self) -> npt.NDArray[np.bool_]:
        """(m,) true from the first accepted row on."""
        return np.isfinite(self.q[:, 0])

    @property
    def rotation(self) -> Array:
        """(m, 3, 3) rotation matrices, base axes to world axes."""
        return matrices_from_xyzw(self.q[:, 3:7])

    @property
    def motion(self) -> BaseMotion:
        """Pose and velocity of the base (m)."""
        return BaseMotion(self.rotation, self.q[:, :3], self.v_world)

    @property
    def rpy(self) -> Array:
        """(m, 3) roll, pitch, yaw [rad], ZYX convention."""
        return rpy_from_matrices(self.rotation)

    @property
    def v_world(self) -> Array:
        """(m, 3) velocity of the base in world axes [m/s]."""
        return np.asarray(np.einsum("nij,nj->ni", self.rotation, self.v[:, :3]))

    @property
    def rpy_std(self) -> Array:
        """(m, 3) standard deviations of roll, pitch, yaw [rad], to first order."""
        _, pitch, yaw = self.rpy.T
        c, s, o = np.cos(yaw), np.sin(yaw), np.zeros_like(yaw)
        flat = np.maximum(np.cos(pitch), 1e-6)
        slope = np.sin(pitch) / flat
        rows = [[c / flat, s / flat, o], [-s, c, o], [c * slope, s * slope, o + 1.0]]
        J = np.moveaxis(np.array(rows), 2, 0)
        variance = np.einsum("nij,njk,nik->ni", J, self.rotation_covariance, J)
        return np.asarray(np.sqrt(np.maximum(variance, 0.0)))
