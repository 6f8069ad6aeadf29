"""Rows of a run: LowStates as the controller received them, and the truth."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
from surefoot.sim.hardware.wire_format import LOW_STATE, MOTOR_COUNT

Array = npt.NDArray[Any]
Log = dict[str, Array]
"""Rows of a run by name. Arrays are (n, k) or (n,), except the last five, which are single values.

Values that the controller received:

- tick (n,) [ms]
- accelerometer and gyroscope (n, 3), quaternion (n, 4) w x y z
- q, dq and tauEst (n, 12) in motor order
- footForce and footForceEst (n, 4)

The truth at the time when the LowState was sampled:

- truth_p, truth_v and truth_com (n, 3): position and velocity of the base's origin, and centre of
  mass, in the world frame
- truth_quaternion (n, 4) w x y z, base to world
- truth_q and truth_dq (n, 12) in motor order
- truth_foot_forces (n, 12): force of the ground on the feet, x y z of FR FL RR RL
- truth_contact (n, 4)

Single values:

- truth_gyro_bias and truth_accelerometer_bias (3,) in base axes
- push_times (k,) [s] since the first row
- weight () [N] of the model
- fell ()
"""

_SENSORS = ("accelerometer", "gyroscope", "quaternion", "footForce", "footForceEst")
_MOTORS = ("q", "dq", "tauEst")


class LogBuilder:
    """Builder of a log, row by row.

    Args:
        size: Largest number of rows.
    """

    def __init__(self, size: int) -> None:
        self.size = size
        self._frames = np.zeros((size, LOW_STATE.itemsize), np.uint8)
        self._truth: dict[str, list[Array]] = {}
        self._count = 0

    def add(self, frame: Array, truth: Log) -> None:
        """Add a row: the bytes of a LowState, and the truth at the time of this LowState."""
        self._frames[self._count] = frame
        for name, value in truth.items():
            self._truth.setdefault(name, []).append(value)
        self._count += 1

    def log(self) -> Log:
        """Return all rows so far by name; sensor values have the types of LowState."""
        frames = self._frames[: self._count].view(LOW_STATE)[:, 0]
        log = {name: frames[name].copy() for name in (*_SENSORS, "tick")}
        for name in _MOTORS:
            log[name] = frames["motorState"][name][:, :MOTOR_COUNT].copy()
        truth = {name: np.array(rows) for name, rows in self._truth.items()}
        return {**log, **truth}
