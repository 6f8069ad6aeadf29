"""What an estimator made of a log, row by row."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot._core import Robot
from surefoot.geometry.batch_rotations import Array, matrices_from_xyzw, rpy_from_matrices
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.sensor_log import SensorLog

IMU_SENSORS = ("gyroscope", "accelerometer", "quaternion")
FOOT_SENSORS = ("footForceEst", "footForce", "tauEst")  # as surefoot.ContactSource begins
SENSOR_NAMES = IMU_SENSORS + tuple(f"{name}[{leg}]" for name in FOOT_SENSORS for leg in LEGS)
"""Of what there are verdicts, in the order of Estimate.verdicts."""


@dataclass(frozen=True)
class Estimate:
    """One run of an estimator over a log.

    Row k belongs to row rows[k] of the log: repetitions of a row and rows without a time are left
    out. A row that the estimator refused repeats the last it took; before the first that it took
    all is NaN. World z is up; the estimator's world begins under the base, with its heading.

    Attributes:
        robot: The model.
        log: The log.
        rows: (m,) index of each row in the log.
        time: (m,) since the log's first row [s].
        status: (m,) values of surefoot.Status.
        q: (m, nq) Pinocchio's: position, quaternion x y z w, joints.
        v: (m, nv) base twist in base axes, joint velocities.
        contact: (m, 4) probability that a foot bears load.
        std: (m, 15) of the errors of rotation (world axes) [rad], v_world [m/s], p_world [m],
            gyroscope bias [rad/s], accelerometer bias [m/s^2].
        rotation_covariance: (m, 3, 3) of the rotation's error, world axes [rad^2].
        gyroscope_bias: (m, 3) base axes [rad/s].
        accelerometer_bias: (m, 3) base axes [m/s^2].
        nis: (m,) normalised innovation squared.
        nis_dimension: (m,) its dimension.
        slip: (m, 4) how surely a standing foot slips.
        contact_by_source: (m, 4, 4) [ContactSource][foot], 0.5 is nothing.
        foot_forces_from_torques: (m, 4) vertical ground force from joint torques [N].
        refused: (m, 4) whether the innovation gate refused a foot.
        payload: (m,) [kg] more than the model has.
        com_shift: (m, 3) [m] base axes.
        verdicts: (m, 15) values of surefoot.SensorVerdict on SENSOR_NAMES.
        update_us: (m,) time of StateEstimator.update() [us]; 0 where it was not called.
        derived: How columns that the log has not were made, by name.
        non_finite: Rows with NaN or infinity by column.
        duplicates: Rows whose clock repeats the one before; skipped.
        rows_without_time: Rows without a finite clock; skipped.
        gaps: Steps longer than the estimator is told.
        longest_gap: The longest step [s].
        warnings: What was strange.
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

    @property
    def valid(self) -> npt.NDArray[np.bool_]:
        """(m,) whether the estimator has taken a row by now."""
        return np.isfinite(self.q[:, 0])

    @property
    def rotation(self) -> Array:
        """(m, 3, 3) base axes to world axes."""
        return matrices_from_xyzw(self.q[:, 3:7])

    @property
    def rpy(self) -> Array:
        """(m, 3) roll, pitch, yaw [rad] (ZYX)."""
        return rpy_from_matrices(self.rotation)

    @property
    def v_world(self) -> Array:
        """(m, 3) of the base in world axes [m/s]."""
        return np.asarray(np.einsum("nij,nj->ni", self.rotation, self.v[:, :3]))

    @property
    def rpy_std(self) -> Array:
        """(m, 3) of roll, pitch, yaw [rad], from the rotation's covariance to first order."""
        _, pitch, yaw = self.rpy.T
        c, s, o = np.cos(yaw), np.sin(yaw), np.zeros_like(yaw)
        flat = np.maximum(np.cos(pitch), 1e-6)
        slope = np.sin(pitch) / flat
        rows = [[c / flat, s / flat, o], [-s, c, o], [c * slope, s * slope, o + 1.0]]
        J = np.moveaxis(np.array(rows), 2, 0)
        variance = np.einsum("nij,njk,nik->ni", J, self.rotation_covariance, J)
        return np.asarray(np.sqrt(np.maximum(variance, 0.0)))
