"""Torque mode: hold the front right thigh at zero with a torque of at most 5 N.m."""

from __future__ import annotations

import sys

from low_level_loop import run
from surefoot import FR_1, LowCmd, LowState, PosStopF, VelStopF


def control(n: int, state: LowState, cmd: LowCmd) -> str:
    """Command tau = 10 (0 - q) + 1 (0 - dq), limited to +-5 N.m, from tick 500 on."""
    if n < 500:
        return ""
    thigh, motor = state.motorState[FR_1], cmd.motorCmd[FR_1]
    torque = 10.0 * (0.0 - thigh.q) + 1.0 * (0.0 - thigh.dq)
    motor.q, motor.dq, motor.Kp, motor.Kd = PosStopF, VelStopF, 0.0, 0.0
    motor.tau = min(max(torque, -5.0), 5.0)
    return (
        f"{n * 0.002:5.1f} s  FR_1 {thigh.q:6.3f} rad, {motor.tau:5.2f} N.m" if n % 250 == 0 else ""
    )


sys.exit(run(control, "Torque mode: one thigh is held at zero."))
