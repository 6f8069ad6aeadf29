"""The sensors of LowStates as a log's columns."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot.messages.low_state_layout import LOW_STATE, MOTOR_COUNT


def sensor_columns(reports: npt.NDArray[np.uint8]) -> dict[str, np.ndarray]:
    """Return what the sensors say in LowStates, to the last bit.

    Args:
        reports: (n, 937) their bytes.

    Returns:
        Arrays (n, width) by the name of the log's column: its clock is tick.
    """
    states = np.ascontiguousarray(reports).view(LOW_STATE)[:, 0]
    motors = states["motorState"][:, :MOTOR_COUNT]
    columns = {"tick": states["tick"][:, None]}
    columns |= {name: states[name] for name in ("gyroscope", "accelerometer", "quaternion")}
    columns |= {name: motors[name] for name in ("q", "dq", "tauEst")}
    columns |= {name: states[name] for name in ("footForce", "footForceEst")}
    return {name: values.astype(np.float64) for name, values in columns.items()}
