"""Run of the state estimator over a log, without a controller."""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter_ns

import numpy as np
import numpy.typing as npt

from surefoot._core import Gains, LowState, Robot, StateEstimator, Status
from surefoot.estimate.checks import check_log
from surefoot.estimate.estimate_recorder import EstimateRecorder
from surefoot.estimate.estimate_result import Estimate
from surefoot.estimate.joint_velocities import METHOD, derive_velocities
from surefoot.estimate.low_states import finite_rows, low_state_blocks
from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.clock_unit import MAX_STEP
from surefoot.sensor_log.column_definitions import FOOT_COLUMNS
from surefoot.sensor_log.sensor_log import SensorLog

Progress = Callable[[str, int, int], None]
_ZEROS = "zeros: the log lacks the column"


def run_estimator(
    robot: Robot, log: SensorLog, gains: Gains | None = None, progress: Progress | None = None
) -> Estimate:
    """Run the state estimator over a log.

    For each row the estimator receives a LowState with the sensor columns, and the time since the
    last accepted row, limited to 0.1 s. It never receives the columns ``truth_...``. A row that
    repeats the clock is skipped. Columns that the log lacks are zeros, except dq:
    derive_velocities() computes dq from q.

    Args:
        robot: Robot that the log comes from.
        log: Log of the robot's sensors.
        gains: Gains of the estimator. None: the robot's own gains.
        progress: Called with "estimate", the number of rows done and the number of all rows.

    Raises:
        Error: Gains are out of range, or a check of the log fails (units, orders, signs; see
            check_log()).
    """
    estimator = StateEstimator(robot)
    if gains is not None:
        estimator.set_gains(gains)
    warnings = [*log.warnings, *check_log(robot, log)]
    derived = {
        name: _ZEROS for name in ("quaternion", "tauEst", *FOOT_COLUMNS) if name not in log.columns
    }
    dq = log.columns.get("dq")
    if dq is None:
        dq = derive_velocities(log.time, log.columns["q"])
        derived["dq"] = METHOD
    _, non_finite = finite_rows(log)
    rows, new = _rows_with_new_time(log)
    recorder = EstimateRecorder(robot, len(rows))
    _run_rows(estimator, log, dq, rows, recorder, progress)
    if not np.any(recorder.status == Status.OK.value):
        names = sorted({Status(int(value)).name for value in recorder.status})
        warnings.append(f"the estimator accepted no row: {', '.join(names)}")
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
        rows_without_time=log.rows - len(new),
        gaps=int((steps > MAX_STEP + 1e-9).sum()),
        longest_gap=float(steps.max(initial=0.0)),
        warnings=tuple(warnings),
        **recorder.arrays(),
    )


def _rows_with_new_time(log: SensorLog) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.bool_]]:
    """Return the rows to use, and for each row with a finite time whether its time is new."""
    timed = np.flatnonzero(np.isfinite(log.time))
    new = np.concatenate([[True], np.diff(log.time[timed]) > 0.0])
    return timed[new], new


def _run_rows(
    estimator: StateEstimator,
    log: SensorLog,
    dq: Array,
    rows: npt.NDArray[np.int64],
    recorder: EstimateRecorder,
    progress: Progress | None,
) -> None:
    # Skip rows with a NaN foot force: the integer field of a LowState cannot hold NaN.
    foot_forces_finite = np.ones(log.rows, dtype=np.bool_)
    for name in FOOT_COLUMNS:
        if name in log.columns:
            foot_forces_finite &= np.isfinite(log.columns[name]).all(axis=1)
    state = LowState()
    raw = state.raw
    blocks = low_state_blocks(log, dq)
    first = end = 0
    block = np.zeros((0, 0), dtype=np.uint8)
    time, last = log.time.tolist(), log.time[rows[0]] - log.period
    for k, row in enumerate(rows.tolist()):
        while row >= end:
            first, block = end, next(blocks)
            end = first + len(block)
            if progress is not None:
                progress("estimate", k, len(rows))
        if not foot_forces_finite[row]:
            continue
        raw[:] = block[row - first]
        dt = min(time[row] - last, MAX_STEP)
        start = perf_counter_ns()
        status = estimator.update(state, dt)
        recorder.record(k, status, estimator, 1e-3 * (perf_counter_ns() - start))
        if status == Status.OK:
            last = time[row]  # dt counts from the last accepted row
    if progress is not None:
        progress("estimate", len(rows), len(rows))
