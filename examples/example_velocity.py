"""Velocity mode: the front right thigh follows a sine of 2 rad/s at 0.5 Hz."""

from __future__ import annotations

import math
import sys

from low_level_loop import run
from surefoot import FR_1, LowCmd, LowState, PosStopF


def control(n: int, state: LowState, cmd: LowCmd) -> str:
    """Command dq = 2 sin(3 pi (n - 500) / 1500) rad/s with Kd = 4, from tick 500 on."""
    if n < 500:
        return ""
    thigh, motor = state.motorState[FR_1], cmd.motorCmd[FR_1]
    speed = 2.0 * math.sin(3.0 * math.pi * (n - 500) / 1500.0)
    motor.q, motor.dq, motor.Kp, motor.Kd, motor.tau = PosStopF, speed, 0.0, 4.0, 0.0
    return f"{n * 0.002:5.1f} s  FR_1 {thigh.dq:6.3f} of {speed:6.3f} rad/s" if n % 250 == 0 else ""


sys.exit(run(control, "Velocity mode: one thigh moves back and forth.", protect_from_tick=11))
