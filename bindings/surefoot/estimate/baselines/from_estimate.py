"""Baselines over the log of an estimate."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.typing as npt

from surefoot._core import Status
from surefoot.estimate.base_motion import BaseMotion
from surefoot.estimate.baselines.inputs import BaselineInputs
from surefoot.estimate.baselines.run import run_baselines
from surefoot.estimate.contact_events import THRESHOLD
from surefoot.estimate.estimate_result import Estimate
from surefoot.estimate.joint_velocities import derive_velocities
from surefoot.geometry.batch_rotations import rotations_about_z


def with_baselines(estimate: Estimate) -> Estimate:
    """Return the estimate with Estimate.baselines: known estimators on the same rows of the log.

    The baselines receive the rows that the estimator accepted, and its contacts. Their motions
    start at the estimator's first position and heading. With fewer than two accepted rows there
    are none.

    Raises:
        Error: The package vqf is not installed.
    """
    accepted = np.flatnonzero(estimate.status == Status.OK.value)
    if len(accepted) < 2:
        return estimate
    motions = run_baselines(_inputs(estimate, accepted))
    aligned = {name: _aligned(estimate, accepted, motion) for name, motion in motions.items()}
    return replace(estimate, baselines=aligned)


def _inputs(estimate: Estimate, accepted: npt.NDArray[np.int64]) -> BaselineInputs:
    log, rows = estimate.log, estimate.rows[accepted]
    dq = log.columns.get("dq")
    if dq is None:
        dq = derive_velocities(log.time, log.columns["q"])
    return BaselineInputs.from_imu(
        estimate.robot,
        estimate.time[accepted],
        log.columns["gyroscope"][rows],
        log.columns["accelerometer"][rows],
        log.columns["q"][rows],
        dq[rows],
        estimate.contact[accepted] > THRESHOLD,
    )


def _aligned(estimate: Estimate, accepted: npt.NDArray[np.int64], motion: BaseMotion) -> BaseMotion:
    """Return a motion for every row: a rejected row repeats the last accepted row."""
    start = estimate.motion.rows(slice(accepted[0], accepted[0] + 1))
    turn = rotations_about_z(start.yaw - motion.yaw[:1])[0]
    position = (motion.position - motion.position[0]) @ turn.T + start.position
    index = np.searchsorted(accepted, np.arange(len(estimate.time)), side="right") - 1
    known = (index >= 0)[:, None]
    index = np.maximum(index, 0)
    return BaseMotion(
        np.where(known[:, None], (turn @ motion.rotation)[index], np.nan),
        np.where(known, position[index], np.nan),
        np.where(known, (motion.velocity @ turn.T)[index], np.nan),
    )
