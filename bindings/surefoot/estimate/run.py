"""The estimator over a log, without a controller."""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter_ns

import numpy as np
import numpy.typing as npt

from surefoot._core import Gains, LowState, Robot, StateEstimator, Status
from surefoot.estimate.checks import check_log
from surefoot.estimate.clock import LONGEST_STEP
from surefoot.estimate.columns import FEET
from surefoot.estimate.derive import METHOD, derive_velocities
from surefoot.estimate.frames import finite_rows, frames
from surefoot.estimate.recorder import Recorder
from surefoot.estimate.result import Estimate
from surefoot.estimate.sensor_log import SensorLog
from surefoot.row_rotations import Array

Progress = Callable[[str, int, int], None]
_ZEROS = "zeros: the log has none"


def run_estimator(
    robot: Robot, log: SensorLog, gains: Gains | None = None, progress: Progress | None = None
) -> Estimate:
    """Run the state estimator over a log.

    It gets LowStates made of the sensors' columns and the time since the last that it took, at most
    0.1 s; of truth_ columns it gets nothing. A clock that repeats is no new row. What the log has
    not is zeros, but for dq, which derive_velocities() makes of q.

    Args:
        robot: The robot that the log is of.
        log: What its sensors said.
        gains: None for the robot's own.
        progress: Told how far it is.

    Raises:
        Error: Gains out of range; a log that contradicts itself or the robot: units, order of
            quaternion or legs, signs. What is doubtful only is a warning.
    """
    estimator = StateEstimator(robot)
    if gains is not None:
        estimator.set_gains(gains)
    warnings = [*log.warnings, *check_log(robot, log)]
    derived = {name: _ZEROS for name in ("quaternion", "tauEst", *FEET) if name not in log.columns}
    dq = log.columns.get("dq")
    if dq is None:
        dq = derive_velocities(log.time, log.columns["q"])
        derived["dq"] = METHOD
    _, non_finite = finite_rows(log)
    rows, new = _new_rows(log)
    recorder = Recorder(robot, len(rows))
    _feed(estimator, log, dq, rows, recorder, progress)
    if not np.any(recorder.status == Status.OK.value):
        names = sorted({Status(int(value)).name for value in recorder.status})
        warnings.append(f"no row was taken by the estimator: {', '.join(names)}")
    steps = np.diff(log.time[rows])
    return Estimate(
        robot=robot,
        log=log,
        rows=rows,
        time=log.time[rows],
        status=recorder.status,
        verdicts=recorder.verdicts,
        update_us=recorder.update_us,
        derived=derived,
        non_finite=non_finite,
        duplicates=len(new) - int(new.sum()),
        unclocked=log.rows - len(new),
        gaps=int((steps > LONGEST_STEP + 1e-9).sum()),
        longest_gap=float(steps.max(initial=0.0)),
        warnings=tuple(warnings),
        **recorder.arrays(),
    )


def _new_rows(log: SensorLog) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.bool_]]:
    """Return the rows to take, and of those with a time whether each is new."""
    timed = np.flatnonzero(np.isfinite(log.time))
    new = np.concatenate([[True], np.diff(log.time[timed]) > 0.0])
    return timed[new], new


def _feed(
    estimator: StateEstimator,
    log: SensorLog,
    dq: Array,
    rows: npt.NDArray[np.int64],
    recorder: Recorder,
    progress: Progress | None,
) -> None:
    # Feet's forces are integers in a LowState: a NaN in them would arrive as a number.
    told = np.ones(log.rows, dtype=np.bool_)
    for name in FEET:
        if name in log.columns:
            told &= np.isfinite(log.columns[name]).all(axis=1)
    state = LowState()
    raw = state.raw
    blocks = frames(log, dq)
    first = end = 0
    block = np.zeros((0, 0), dtype=np.uint8)
    time, last = log.time.tolist(), log.time[rows[0]] - log.period
    for k, row in enumerate(rows.tolist()):
        while row >= end:
            first, block = end, next(blocks)
            end = first + len(block)
            if progress is not None:
                progress("estimate", k, len(rows))
        if not told[row]:
            continue
        raw[:] = block[row - first]
        dt = min(time[row] - last, LONGEST_STEP)
        start = perf_counter_ns()
        status = estimator.update(state, dt)
        recorder.record(k, status, estimator, 1e-3 * (perf_counter_ns() - start))
        if status == Status.OK:
            last = time[row]  # time in refused rows is not lost to the estimator
    if progress is not None:
        progress("estimate", len(rows), len(rows))
