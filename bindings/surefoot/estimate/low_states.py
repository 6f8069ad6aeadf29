"""Conversion of the rows of a log to LowStates, in blocks."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from surefoot._core import LowState
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LOW_STATE, MOTOR_COUNT
from surefoot.sensor_log.column_definitions import FOOT_COLUMNS, SENSOR_COLUMNS
from surefoot.sensor_log.sensor_log import SensorLog

# Chosen: bounds the memory; the overhead of a block is small against its rows.
CHUNK = 4096  # rows per block: 4 MB of LowStates
# MotorState::mode of unitree_legged_sdk.
SERVO_MODE = 0x0A
_IMU = ("quaternion", "gyroscope", "accelerometer")
_INT16 = np.iinfo(np.int16)


def low_state_blocks(log: SensorLog, dq: Array) -> Iterator[npt.NDArray[np.uint8]]:
    """Yield the packed LowStates of a log in order, as blocks of bytes (up to CHUNK, 937).

    Columns that the log lacks are zeros.

    Args:
        log: The log.
        dq: (n, 12) joint velocities [rad/s], from the log or from derive_velocities().
    """
    empty_state = np.array(LowState().raw)
    for start in range(0, log.rows, CHUNK):
        rows = slice(start, min(start + CHUNK, log.rows))
        block = np.tile(empty_state, (rows.stop - start, 1))
        state = block.view(LOW_STATE)[:, 0]
        # Values beyond float32 become infinite; the estimator rejects them.
        with np.errstate(over="ignore", invalid="ignore"):
            for name in _IMU:
                state[name] = log.sensor(name)[rows]
            motors = state["motorState"]
            for name, values in (("q", log.sensor("q")), ("tauEst", log.sensor("tauEst"))):
                motors[name][:, :MOTOR_COUNT] = values[rows]
            motors["dq"][:, :MOTOR_COUNT] = dq[rows]
            motors["mode"][:, :MOTOR_COUNT] = SERVO_MODE
            for name in FOOT_COLUMNS:
                values = np.nan_to_num(log.sensor(name)[rows])
                state[name] = np.clip(np.round(values), _INT16.min, _INT16.max)
        state["tick"] = _ticks(log, rows)
        yield block


def _ticks(log: SensorLog, rows: slice) -> Array:
    if log.clock == "tick":
        values = log.columns["tick"][rows, 0]
    else:
        values = np.round(1000.0 * log.time[rows]) % 2**32
    return np.where(np.isfinite(values), values, 0.0).astype(np.uint32)


def finite_rows(log: SensorLog) -> tuple[npt.NDArray[np.bool_], dict[str, int]]:
    """Return which rows have only finite values (n,), and a count of bad rows by column.

    The count is the number of rows with NaN or infinity in the column. Zero counts are omitted.
    """
    good = np.isfinite(log.time)
    counts = {} if good.all() else {log.clock: int((~good).sum())}
    for name in (*SENSOR_COLUMNS, *FOOT_COLUMNS):
        if name in log.columns:
            finite = np.isfinite(log.columns[name]).all(axis=1)
            if not finite.all():
                counts[name] = int((~finite).sum())
                good &= finite
    return good, counts
