"""LowCmd and LowState as arrays: what the packed frames carry and how coarsely."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot._core import LowCmd, LowState, PosStopF, VelStopF
from surefoot.low_state_layout import LOW_STATE, MOTOR_STATE, MOTORS, SLOTS
from surefoot.sim.rotations import Array

_MOTOR_CMD = np.dtype(
    {
        "names": ["mode", "q", "dq", "tau", "Kp", "Kd"],
        "formats": ["u1", "<f4", "<f4", "<f4", "<f4", "<f4"],
        "offsets": [0, 1, 5, 9, 13, 17],
        "itemsize": 33,
    }
)
_LOW_CMD = np.dtype(
    {"names": ["motorCmd"], "formats": [(_MOTOR_CMD, SLOTS)], "offsets": [22], "itemsize": 734}
)


@dataclass(frozen=True)
class Command:
    """A LowCmd's twelve motors as arrays (12,), SI units, SDK order."""

    mode: npt.NDArray[np.uint8]
    q: Array
    dq: Array
    tau: Array
    kp: Array
    kd: Array


class Wire:
    """Reads commands and torques as the robot gets them.

    On the wire tau is an int16 of 1/256 N.m (1/128 on B1), Kp a uint16 of 1/32 and Kd of 1/16,
    truncated toward zero. Values out of range wrap there; here they saturate.

    Args:
        robot_name: "b1" has the coarser torque unit.
        real: False passes values through unchanged.
    """

    def __init__(self, robot_name: str, real: bool) -> None:
        self._real = real
        self._per_tau = 128.0 if robot_name == "b1" else 256.0

    def torque(self, tau: Array) -> Array:
        """Return torques (12,) [N.m] as an int16 carries them."""
        if not self._real:
            return tau
        whole = np.trunc(np.minimum(np.maximum(tau * self._per_tau, -32767.0), 32767.0))
        return np.asarray(whole / self._per_tau)

    def read(self, cmd: LowCmd) -> Command:
        """Return the motors' part of a LowCmd; what is not finite counts as not said."""
        motors = cmd.raw.view(_LOW_CMD)[0]["motorCmd"][:MOTORS]
        q, dq, tau, kp, kd = (
            motors[name].astype(np.float64) for name in ("q", "dq", "tau", "Kp", "Kd")
        )
        q[~np.isfinite(q)] = PosStopF
        dq[~np.isfinite(dq)] = VelStopF
        for values in (tau, kp, kd):
            values[~np.isfinite(values)] = 0.0
        if self._real:
            tau = self.torque(tau)
            kp = np.trunc(np.clip(kp * 32.0, 0.0, 65535.0)) / 32.0
            kd = np.trunc(np.clip(kd * 16.0, 0.0, 65535.0)) / 16.0
        return Command(motors["mode"].copy(), q, dq, tau, kp, kd)


class StateFrame:
    """One packed LowState that is filled in place, field by field, and handed out as copies.

    Attributes:
        fields: Every field this plant fills, as writable views by name; motors' are (12,).
    """

    def __init__(self) -> None:
        state = LowState()  # head and levelFlag are in it
        _fill_battery(state)
        self._bytes = np.array(state.raw)
        frame = self._bytes.view(LOW_STATE)
        self.fields = {
            name: frame[name][0] if frame[name].ndim > 1 else frame[name]
            for name in LOW_STATE.names or ()
        }
        motors = self.fields.pop("motorState")[:MOTORS]
        for name in MOTOR_STATE.names or ():
            self.fields[f"motor_{name}"] = motors[name]
        self.fields["motor_mode"][:] = 0x0A
        self.fields["motor_temperature"][:] = 35
        self.fields["imu_temperature"][:] = 45

    def copy(self) -> LowState:
        """Return what has been filled in so far as a LowState of its own."""
        return LowState.from_bytes(self._bytes.tobytes())


def _fill_battery(state: LowState) -> None:
    # A six-cell pack in the middle of its charge.
    state.bms.version_h, state.bms.bms_status, state.bms.SOC = 1, 1, 80
    state.bms.current, state.bms.cycle = -3000, 50
    state.bms.BQ_NTC[:], state.bms.MCU_NTC[:] = 30, 32
    state.bms.cell_vol[:6] = 3850


def measured_power(state: LowState) -> float:
    """Return the sum of |tauEst dq| over the motors [W]: the power that PowerProtect looks at."""
    motors = state.raw.view(LOW_STATE)[0]["motorState"][:MOTORS]
    return float(np.abs(motors["tauEst"] * motors["dq"]).sum())
