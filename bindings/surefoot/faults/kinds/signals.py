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
_SOC, _CELLS, _REMOTE = slice(838, 839), slice(850, 870), slice(889, 929)  # byte ranges in LowState


def signal_view(state: LowState, name: str) -> Values:
    """Return a writable view of a signal: a field of LowState, or a field of all twelve motors."""
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
        name: Name of the signal for signal_view(): quaternion, gyroscope, q, tauEst, SOC and so on.
        change: Function that changes the signal.
        parts: Index or indices of the motors, feet or axes to change; None: all.
    """

    def __init__(self, name: str, change: Change, parts: int | list[int] | None = None) -> None:
        self._name, self._change = name, change
        self._parts = slice(None) if parts is None else np.atleast_1d(parts)

    def change_state(self, state: LowState, k: int) -> None:
        """Change the signal in a sample."""
        values = signal_view(state, self._name)
        if isinstance(self._parts, slice):
            self._change(values, k)
            return
        chosen = values[self._parts]
        self._change(chosen, k)
        values[self._parts] = chosen


class AllSensorsFault(Fault):
    """All sensors are wrong in the same way, but the tick is right.

    Args:
        change: Function that changes the bytes of IMU, motors, battery and feet.
    """

    def __init__(self, change: Change) -> None:
        self._change = change

    def change_state(self, state: LowState, k: int) -> None:
        """Change the bytes between the header and the tick of a sample."""
        self._change(state.raw[22:885], k)


class AttitudeFault(Fault):
    """The IMU reports an attitude that is rotated from the true attitude.

    Args:
        angle: Function of the period k that returns the angle of this rotation [deg].
        axis: Axis of this rotation: 0: x axis of the IMU (roll), 1: y axis of the IMU (pitch), 2:
            z axis of the world.
    """

    def __init__(self, angle: Callable[[int], float], axis: int) -> None:
        self._angle, self._axis = angle, axis

    def change_state(self, state: LowState, k: int) -> None:
        """Rotate the quaternion in a sample."""
        q = signal_view(state, "quaternion")
        half = np.radians(self._angle(k)) / 2
        turn = np.zeros(4)
        turn[0], turn[1 + self._axis] = np.cos(half), np.sin(half)
        reported = q.astype(float)
        q[:] = _product(turn, reported) if self._axis == 2 else _product(reported, turn)


class RandomAttitudeFault(Fault):
    """The IMU reports a new random attitude in every sample."""

    def __init__(self) -> None:
        self._rng = np.random.default_rng(13)  # any fixed seed, so that runs repeat

    def change_state(self, state: LowState, k: int) -> None:
        """Replace the quaternion in a sample by a random one."""
        q = self._rng.normal(size=4)
        signal_view(state, "quaternion")[:] = q / np.linalg.norm(q)


def _product(a: Values, b: Values) -> Values:
    """Return the quaternion product a b; the order of components is w, x, y, z."""
    scalar = a[0] * b[0] - a[1:] @ b[1:]
    return np.concatenate([[scalar], a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])])
