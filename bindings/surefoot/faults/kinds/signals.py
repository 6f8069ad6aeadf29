"""Faults of what a report says: one signal, changed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import LowState
from surefoot.faults.kinds.fault import Fault
from surefoot.faults.kinds.injections import Change
from surefoot.messages.low_state_layout import LOW_STATE, MOTOR_COUNT

Values = npt.NDArray[Any]
_MOTOR = ("mode", "q", "dq", "tauEst", "temperature")
_SOC, _CELLS, _REMOTE = slice(838, 839), slice(850, 870), slice(889, 929)  # bytes of LowState


def signal_view(state: LowState, name: str) -> Values:
    """Return a writable view of a signal: of an array of LowState, or of all twelve motors."""
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
    """A signal that goes wrong.

    Args:
        name: Of the signal: quaternion, gyroscope, q, tauEst, SOC and so on.
        change: How.
        parts: Of it: a motor's or foot's number, or several; all by default.
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
    """All that is measured goes wrong alike, while the tick goes on.

    Args:
        change: How, on the bytes of IMU, motors and feet.
    """

    def __init__(self, change: Change) -> None:
        self._change = change

    def change_state(self, state: LowState, k: int) -> None:
        """Change them."""
        self._change(state.raw[22:885], k)


class AttitudeFault(Fault):
    """The IMU's attitude is turned further.

    Args:
        angle: By how much, in the k-th period [deg].
        axis: To turn about: the IMU's 0 roll or 1 pitch; 2, the world's vertical.
    """

    def __init__(self, angle: Callable[[int], float], axis: int) -> None:
        self._angle, self._axis = angle, axis

    def change_state(self, state: LowState, k: int) -> None:
        """Turn it."""
        q = signal_view(state, "quaternion")
        half = np.radians(self._angle(k)) / 2
        turn = np.zeros(4)
        turn[0], turn[1 + self._axis] = np.cos(half), np.sin(half)
        reported = q.astype(float)
        q[:] = _product(turn, reported) if self._axis == 2 else _product(reported, turn)


class RandomAttitudeFault(Fault):
    """The IMU says any attitude, another one every time."""

    def __init__(self) -> None:
        self._rng = np.random.default_rng(13)

    def change_state(self, state: LowState, k: int) -> None:
        """Draw it."""
        q = self._rng.normal(size=4)
        signal_view(state, "quaternion")[:] = q / np.linalg.norm(q)


def _product(a: Values, b: Values) -> Values:
    """Return the quaternion a b; w, x, y, z."""
    scalar = a[0] * b[0] - a[1:] @ b[1:]
    return np.concatenate([[scalar], a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])])
