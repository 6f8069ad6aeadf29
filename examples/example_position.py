"""Position mode: the front right leg moves linearly to a pose, then its calf swings."""

from __future__ import annotations

import math
import sys

from low_level_loop import run
from surefoot import FR_0, LowCmd, LowState

POSE = (0.0, 1.2, -2.0)  # [rad] hip, thigh, calf
KP, KD = 5.0, 1.0  # [N.m/rad], [N.m.s/rad]
start = [0.0, 0.0, 0.0]


def control(n: int, state: LowState, cmd: LowCmd) -> str:
    """Read the pose until tick 9, move to POSE in 0.4 s, then swing the calf at 0.45 Hz."""
    if n < 10:
        start[:] = [state.motorState[FR_0 + k].q for k in range(3)]
        return ""
    share = min((n - 9) / 200.0, 1.0)  # a step would cause a large torque
    target = [s + share * (goal - s) for s, goal in zip(start, POSE, strict=True)]
    if n >= 400:
        target[2] = POSE[2] - 0.6 * math.sin(1.8 * math.pi * (n - 400) / 1000.0)
    for k in range(3):
        motor = cmd.motorCmd[FR_0 + k]
        motor.q, motor.dq, motor.Kp, motor.Kd = target[k], 0.0, KP, KD
    calf = state.motorState[FR_0 + 2].q
    return f"{n * 0.002:5.1f} s  FR_2 {calf:6.3f} of {target[2]:6.3f} rad" if n % 250 == 0 else ""


sys.exit(run(control, "Position mode: one leg moves.", protect_from_tick=11))
