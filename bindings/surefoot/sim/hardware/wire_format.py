"""Quantisation of commands and torques in the SDK's packed frames, and a default LowState."""

from __future__ import annotations

import numpy as np

from surefoot import _plant
from surefoot._core import LowState
from surefoot.messages.low_state_layout import LOW_STATE, MOTOR_COUNT
from surefoot.sim.hardware.motors import SERVO_MODE

MotorCommands = _plant.MotorCommands


class WireFormat(_plant.WireFormat):
    """Quantises commands and torques as the robot's frames do; see bindings/src/plant/motors.hpp.

    Args:
        robot_name: Name of the robot; "b1" has the coarser torque unit, 1/128 instead of 1/256 N.m.
        real: Whether values are quantised; False leaves them unchanged.
    """

    def __init__(self, robot_name: str, real: bool) -> None:
        # Counts per N.m in unitree_legged_sdk's frames, as in controller/src/protocol.
        super().__init__(128.0 if robot_name == "b1" else 256.0, real)


def default_low_state() -> LowState:
    """Return a LowState with the constant fields set: motor modes, temperatures, battery."""
    state = LowState()  # sets head and levelFlag
    for i in range(MOTOR_COUNT):
        state.motorState[i].mode, state.motorState[i].temperature = SERVO_MODE, 35
    state.imu.temperature = 45
    # Battery and temperatures are not modelled. The values are plausible constants [deg C], [%],
    # [mA], [mV], far from all limits, of a battery with six cells.
    state.bms.version_h, state.bms.bms_status, state.bms.SOC = 1, 1, 80
    state.bms.current, state.bms.cycle = -3000, 50
    state.bms.BQ_NTC[:], state.bms.MCU_NTC[:] = 30, 32
    state.bms.cell_vol[:6] = 3850
    return state


def measured_power(state: LowState) -> float:
    """Return the power [W] that PowerProtect monitors: sum of abs(tauEst dq) over the motors."""
    motors = state.raw.view(LOW_STATE)[0]["motorState"][:MOTOR_COUNT]
    return float(np.abs(motors["tauEst"] * motors["dq"]).sum())
