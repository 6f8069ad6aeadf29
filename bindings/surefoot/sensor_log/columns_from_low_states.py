"""Conversion of LowStates to the columns of a log."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot.messages.low_state_layout import LOW_STATE, MOTOR_COUNT


def sensor_columns(low_states: npt.NDArray[np.uint8]) -> dict[str, np.ndarray]:
    """Return the sensor values of LowStates as log columns, without loss of precision.

    Args:
        low_states: Packed LowStates, (n, 937) bytes.

    Returns:
        Arrays (n, width) by column name. The clock is `tick`.
    """
    states = np.ascontiguousarray(low_states).view(LOW_STATE)[:, 0]
    motors = states["motorState"][:, :MOTOR_COUNT]
    columns = {"tick": states["tick"][:, None]}
    columns |= {name: states[name] for name in ("gyroscope", "accelerometer", "quaternion")}
    columns |= {name: motors[name] for name in ("q", "dq", "tauEst")}
    columns |= {name: states[name] for name in ("footForce", "footForceEst")}
    return {name: values.astype(np.float64) for name, values in columns.items()}
