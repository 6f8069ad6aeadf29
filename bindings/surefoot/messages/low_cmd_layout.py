"""NumPy dtype of the packed LowCmd (734 bytes), with all its fields, for arrays of commands."""

from __future__ import annotations

import numpy as np

from surefoot.messages.low_state_layout import MOTOR_SLOTS

MOTOR_CMD = np.dtype(
    {
        "names": ["mode", "q", "dq", "tau", "Kp", "Kd", "reserve"],
        "formats": ["u1", "<f4", "<f4", "<f4", "<f4", "<f4", ("<u4", 3)],
        "offsets": [0, 1, 5, 9, 13, 17, 21],
        "itemsize": 33,
    }
)
LOW_CMD = np.dtype(
    {
        "names": [
            *("head", "levelFlag", "frameReserve", "SN", "version", "bandWidth"),
            *("motorCmd", "bms", "wirelessRemote", "reserve", "crc"),
        ],
        "formats": [
            *(("u1", 2), "u1", "u1", ("<u4", 2), ("<u4", 2), "<u2"),
            *((MOTOR_CMD, MOTOR_SLOTS), ("u1", 4), ("u1", 40), "<u4", "<u4"),
        ],
        "offsets": [*(0, 2, 3, 4, 12, 20), *(22, 682, 686, 726, 730)],
        "itemsize": 734,
    }
)
