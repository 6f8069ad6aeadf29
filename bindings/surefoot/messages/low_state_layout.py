"""NumPy dtype for arrays of packed LowStates (937 bytes each).

The dtype names only the fields that Surefoot reads. It skips the bytes of all other fields: the
header, the raw motor fields, and the fields after the tick.
"""

from __future__ import annotations

import numpy as np

LEGS = ("FR", "FL", "RR", "RL")  # leg order of the SDK; each leg has three motors
MOTOR_COUNT = 12
MOTOR_SLOTS = 20

MOTOR_STATE = np.dtype(
    {
        "names": ["mode", "q", "dq", "ddq", "tauEst", "temperature"],
        "formats": ["u1", "<f4", "<f4", "<f4", "<f4", "i1"],
        "offsets": [0, 1, 5, 9, 13, 29],
        "itemsize": 38,
    }
)
LOW_STATE = np.dtype(
    {
        "names": [
            *("quaternion", "gyroscope", "accelerometer", "rpy", "imu_temperature"),
            *("motorState", "footForce", "footForceEst", "tick"),
        ],
        "formats": [
            *(("<f4", 4), ("<f4", 3), ("<f4", 3), ("<f4", 3), "i1"),
            *((MOTOR_STATE, MOTOR_SLOTS), ("<i2", 4), ("<i2", 4), "<u4"),
        ],
        "offsets": [22, 38, 50, 62, 74, 75, 869, 877, 885],
        "itemsize": 937,
    }
)
