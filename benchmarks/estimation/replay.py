"""Replay of a log through the state estimator, without a controller."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from surefoot import LowState, Robot, StateEstimator
from surefoot.sim.hardware.wire_format import LOW_STATE, MOTOR_COUNT, default_low_state

from estimation.log_rows import Array, Log
from estimation.recording import sample_rate

MAX_DT = 0.1  # [s] largest dt for StateEstimator.update()


@dataclass(frozen=True)
class Estimates:
    """Output of the estimator after every row of a log, in the estimator's world frame.

    Attributes:
        q: (n, 19) configurations in Pinocchio's order.
        v: (n, 18) velocities in Pinocchio's order.
        contact: (n, 4) contact confidence.
        covariance: (n, 15, 15) covariance of EstimatorReport; (0, 15, 15) if it is not kept.
        nis: (n,) normalised innovation squared.
        nis_dimension: (n,) dimension of the innovation.
        gyro_bias: (n, 3) base axes [rad/s].
        accelerometer_bias: (n, 3) base axes [m/s^2].
        forces: (n, 3, 4) force of the ground on each foot from joint torques [N], world axes.
    """

    q: Array
    v: Array
    contact: Array
    covariance: Array
    nis: Array
    nis_dimension: Array
    gyro_bias: Array
    accelerometer_bias: Array
    forces: Array


def replay(robot: Robot, log: Log, keep_covariance: bool = False) -> Estimates:
    """Run a new estimator over a log; dt is the difference of ticks.

    The covariance is optional, because it takes a kilobyte per row.
    """
    frames, n = low_state_bytes(log), len(log["tick"])
    dt = np.diff(log["tick"].astype(np.int64), prepend=0) / 1000.0
    dt[0] = 1.0 / sample_rate(log)
    time_steps = np.clip(dt, 0.0, MAX_DT).tolist()
    out = Estimates(
        *(np.zeros((n, robot.nq)), np.zeros((n, robot.nv)), np.zeros((n, 4))),
        np.zeros((n if keep_covariance else 0, 15, 15), np.float32),
        *(np.zeros(n), np.zeros(n, np.int64)),
        *(np.zeros((n, 3)), np.zeros((n, 3)), np.zeros((n, 3, 4), np.float32)),
    )
    estimator, low_state = StateEstimator(robot), LowState()
    raw = low_state.raw  # a view of the LowState's memory
    for k in range(n):
        raw[:] = frames[k]
        estimator.update(low_state, time_steps[k])
        state, report = estimator.state, estimator.report
        out.q[k], out.v[k], out.contact[k] = state.q, state.v, state.contact
        out.forces[k] = report.foot_forces_from_torques
        if keep_covariance:
            out.covariance[k] = report.covariance
        out.nis[k], out.nis_dimension[k] = report.nis, report.nis_dimension
        out.gyro_bias[k] = report.gyroscope_bias
        out.accelerometer_bias[k] = report.accelerometer_bias
    return out


def low_state_bytes(log: Log) -> Array:
    """Return the packed LowStates of a log as bytes (n, 937)."""
    template = np.array(default_low_state().raw)
    rows = np.tile(template, (len(log["tick"]), 1))
    fields = rows.view(LOW_STATE)[:, 0]
    for name in ("accelerometer", "gyroscope", "quaternion", "footForce", "footForceEst", "tick"):
        fields[name] = log[name]
    for name in ("q", "dq", "tauEst"):
        fields["motorState"][name][:, :MOTOR_COUNT] = log[name]
    return rows
