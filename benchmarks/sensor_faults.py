"""Faults of the sensors of a walking robot, for sensor_verdicts.py: changes of a healthy log."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from log_mutations import Columns, in_leg_order
from surefoot.estimate import SensorLog
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.column_definitions import FOOT_COLUMNS

AXES = "xyz"
IMU = ("gyroscope", "accelerometer", "quaternion")
LEG_COLUMNS = ("q", "dq", "tauEst")
CALF_OFFSET = 0.1  # [rad]
GYRO_BIAS = 0.2  # [rad/s]
ACCELEROMETER_BIAS = 1.0  # [m/s^2]
DELAY = 0.02  # [s]


@dataclass(frozen=True)
class Fault:
    """A fault of a log.

    Attributes:
        name: Row of the table.
        change: Function that returns the columns that change, from all columns, the row of the
            onset and the period [s].
        verdict: Regular expression that the right verdict matches.
        halfway: Whether the fault begins in the middle of the log.
        foot_forces: Whether the log must have foot forces.
    """

    name: str
    change: Callable[[Columns, int, float], Columns]
    verdict: str
    halfway: bool = False
    foot_forces: bool = False


def draw_faults(rng: np.random.Generator) -> list[Fault]:
    """Return one fault of each kind and axis, with random signs, legs and orders."""
    leg, axis_sign = int(rng.integers(4)), rng.choice([-1.0, 1.0], 7)
    order = rng.permutation(4)
    while np.array_equal(order, [0, 1, 2, 3]):
        order = rng.permutation(4)
    faults = [
        Fault("legs left/right", _legs([1, 0, 3, 2]), "in the order FL FR RL RR"),
        Fault("legs front/rear", _legs([2, 3, 0, 1]), "in the order RR RL FR FL"),
        Fault("footForce order", _foot_order(order), "footForce.* follows", foot_forces=True),
        Fault("calf offset", _calf(leg, axis_sign[6]), f"calf of {LEGS[leg]} has an offset"),
        Fault("IMU late", _delay(IMU), "IMU is late"),
        Fault("joints late", _delay((*LEG_COLUMNS, *FOOT_COLUMNS)), "joints are late"),
        Fault("footForce stuck", _dead(leg, True), f"of {LEGS[leg]} stays", True, True),
        Fault("footForce zero", _dead(leg, False), f"of {LEGS[leg]} stays at 0", True, True),
    ]
    for k, axis in enumerate(AXES):
        scale = float(rng.choice([0.5, 2.0]))
        bias, force = GYRO_BIAS * axis_sign[k], ACCELEROMETER_BIAS * axis_sign[3 + k]
        verdict = f"axis {axis} of the base turns"
        faults += [
            Fault(f"gyroscope sign {axis}", _gain(k, -1.0), f"{verdict} -"),
            Fault(f"gyroscope scale {axis}", _gain(k, scale), rf"{verdict} [\d]"),
            Fault(f"gyroscope bias {axis}", _bias("gyroscope", k, bias), "gyroscope has a bias"),
            Fault(
                f"accelerometer bias {axis}",
                _bias("accelerometer", k, force),
                "accelerometer has a bias",
            ),
        ]
    return faults


def with_fault(log: SensorLog, fault: Fault, onset: int) -> SensorLog:
    """Return a log with a fault from the row `onset` on, or in all rows."""
    changed = fault.change(log.columns, onset if fault.halfway else 0, log.period)
    return replace(log, columns={**log.columns, **changed})


def _legs(order: list[int]) -> Callable[[Columns, int, float], Columns]:
    def change(columns: Columns, _onset: int, _period: float) -> Columns:
        return {name: in_leg_order(columns[name], order) for name in LEG_COLUMNS if name in columns}

    return change


def _foot_order(order: np.ndarray) -> Callable[[Columns, int, float], Columns]:
    return lambda columns, _onset, _period: {
        name: columns[name][:, order] for name in FOOT_COLUMNS if name in columns
    }


def _calf(leg: int, sign: float) -> Callable[[Columns, int, float], Columns]:
    offset = sign * CALF_OFFSET * (np.arange(12) == 3 * leg + 2)
    return lambda columns, _onset, _period: {"q": columns["q"] + offset}


def _gain(axis: int, gain: float) -> Callable[[Columns, int, float], Columns]:
    factor = np.where(np.arange(3) == axis, gain, 1.0)
    return lambda columns, _onset, _period: {"gyroscope": columns["gyroscope"] * factor}


def _bias(name: str, axis: int, bias: float) -> Callable[[Columns, int, float], Columns]:
    offset = bias * (np.arange(3) == axis)
    return lambda columns, _onset, _period: {name: columns[name] + offset}


def _delay(names: tuple[str, ...]) -> Callable[[Columns, int, float], Columns]:
    def change(columns: Columns, _onset: int, period: float) -> Columns:
        rows = round(DELAY / period)
        late = {}
        for name in names:
            if name in columns:
                values = columns[name]
                late[name] = np.concatenate([np.repeat(values[:1], rows, axis=0), values[:-rows]])
        return late

    return change


def _dead(leg: int, stuck: bool) -> Callable[[Columns, int, float], Columns]:
    def change(columns: Columns, onset: int, _period: float) -> Columns:
        changed = {}
        for name in FOOT_COLUMNS:
            if name in columns:
                changed[name] = columns[name].copy()
                changed[name][onset:, leg] = columns[name][onset, leg] if stuck else 0.0
        return changed

    return change
