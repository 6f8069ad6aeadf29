"""Faults of signals in a LowState: one signal, or all sensors."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import LowState
from surefoot.faults.kinds.fault import Fault
from surefoot.faults.kinds.signal_faults import Change
from surefoot.messages.low_state_layout import LOW_STATE, MOTOR_COUNT

Values = npt.NDArray[Any]
_MOTOR = ("mode", "q", "dq", "tauEst", "temperature")
_SOC, _CELLS, _REMOTE = slice(838, 839), slice(850, 870), slice(889, 929)  # bytes of LowState


def signal_view(state: LowState, name: str) -> Values:
    """Return a writable view of a signal: a LowState array, or a field of all twelve motors."""
    fields = state.raw.view(LOW_STATE)[0]
    if name in _MOTOR:
        return np.asarray(fields["motorState"][name][:MOTOR_COUNT])
    if name == "SOC":
        return np.asarray(state.raw[_SOC])
    if name == "wirelessRemote":
        return np.asarray(state.raw[_REMOTE])
    if name == "tick":
        return np.asarray(state.raw[885:889].view("<u4"))
    return np.asarray(fields[name])


class SignalFault(Fault):
    """One signal is wrong.

    Args:
        name: Signal: quaternion, gyroscope, q, tauEst, SOC and so on.
        change: Change of the signal.
        parts: Index or indices of motors, feet or axes to change; None changes all.
    """

    def __init__(self, name: str, change: Change, parts: int | list[int] | None = None) -> None:
        self._name, self._change = name, change
        self._parts = slice(None) if parts is None else np.atleast_1d(parts)

    def change_state(self, state: LowState, k: int) -> None:
        """Change the signal."""
        values = signal_view(state, self._name)
        if isinstance(self._parts, slice):
            self._change(values, k)
            return
        chosen = values[self._parts]
        self._change(chosen, k)
        values[self._parts] = chosen


class AllSensorsFault(Fault):
    """All sensors are wrong in the same way, while the tick advances.

    Args:
        change: Change of the bytes of IMU, motors and feet.
    """

    def __init__(self, change: Change) -> None:
        self._change = change

    def change_state(self, state: LowState, k: int) -> None:
        """Change the bytes of the sensors."""
        self._change(state.raw[22:885], k)


class AttitudeFault(Fault):
    """The attitude of the IMU has an additional rotation.

    Args:
        angle: Angle in period k [deg].
        axis: Axis: 0 roll or 1 pitch of the IMU, 2 the vertical of the world.
    """

    def __init__(self, angle: Callable[[int], float], axis: int) -> None:
        self._angle, self._axis = angle, axis

    def change_state(self, state: LowState, k: int) -> None:
        """Rotate the quaternion."""
        q = signal_view(state, "quaternion")
        half = np.radians(self._angle(k)) / 2
        turn = np.zeros(4)
        turn[0], turn[1 + self._axis] = np.cos(half), np.sin(half)
        reported = q.astype(float)
        q[:] = _product(turn, reported) if self._axis == 2 else _product(reported, turn)


class RandomAttitudeFault(Fault):
    """The IMU reports another random attitude in every sample."""

    def __init__(self) -> None:
        self._rng = np.random.default_rng(13)  # any seed: runs repeat

    def change_state(self, state: LowState, k: int) -> None:
        """Replace the quaternion by a random one."""
        q = self._rng.normal(size=4)
        signal_view(state, "quaternion")[:] = q / np.linalg.norm(q)


def _product(a: Values, b: Values) -> Values:
    """Return the quaternion product a b; order w, x, y, z."""
    scalar = a[0] * b[0] - a[1:] @ b[1:]
    return np.concatenate([[scalar], a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])])
