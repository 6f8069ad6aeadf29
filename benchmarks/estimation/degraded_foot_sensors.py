"""Sensor conditions: convert a log to the log of other, worse or faulty sensors."""

from __future__ import annotations

import zlib
from collections.abc import Callable

import numpy as np

from estimation.log_rows import Array, Log

FORCE_NOISE = 3.0  # [N] standard deviation of the noise of footForceEst
COUNT_OFFSET, COUNT_GAIN = (5.0, 50.0), (1.0, 2.0)  # [counts], [counts/N] ranges of offset and gain
COUNT_NOISE = 2.0  # [counts] standard deviation of the noise
COUNT_DRIFT = 5.0  # [counts] standard deviation of the random walk after a minute
FAULTY_FOOT_DRIFT = 50.0  # [counts/min] drift of the faulty foot in the condition drifting
TORQUE_ERROR = 0.2  # largest relative error of tauEst, in the condition raw
INT16_MAX = 32767

Condition = Callable[[Log, np.random.Generator], Log]


def normal_forces(log: Log) -> Array:
    """Return the true vertical force on every foot (n, 4) [N]."""
    return np.asarray(log["truth_foot_forces"].reshape(-1, 4, 3)[:, :, 2])


def all_foot_sensors(log: Log, rng: np.random.Generator) -> Log:
    """Return a log in which both foot force fields work; motors as recorded."""
    newtons = normal_forces(log)
    newtons = newtons + FORCE_NOISE * rng.standard_normal(newtons.shape)
    return {**log, "footForceEst": int16(newtons), "footForce": int16(raw_counts(log, rng))}


def raw_counts_only(log: Log, rng: np.random.Generator) -> Log:
    """Return a log with only raw counts, and a scale error of up to 20 % of each motor's tauEst."""
    torque_scale = rng.uniform(1.0 - TORQUE_ERROR, 1.0 + TORQUE_ERROR, 12)
    tau = (log["tauEst"] * torque_scale).astype(np.float32)
    zero_forces = np.zeros_like(log["footForceEst"])
    return {
        **log,
        "footForceEst": zero_forces,
        "footForce": int16(raw_counts(log, rng)),
        "tauEst": tau,
    }


def joint_torque_only(log: Log, rng: np.random.Generator) -> Log:
    """Return a log without foot forces; motors as recorded."""
    zero_forces = np.zeros_like(log["footForceEst"])
    return {**log, "footForceEst": zero_forces, "footForce": zero_forces.copy()}


def _one_foot(fault: str) -> Condition:
    def condition(log: Log, rng: np.random.Generator) -> Log:
        foot = int(rng.integers(4))
        out = all_foot_sensors(log, rng)
        row = int(rng.uniform(0.0, 0.5) * len(log["tick"]))
        for name in ("footForceEst", "footForce"):
            values = out[name].copy()
            values[row:, foot] = {"stuck": values[row, foot], "zero": 0, "saturated": INT16_MAX}[
                fault
            ]
            out[name] = values
        return out

    condition.__doc__ = (
        f"Both fields work; from a random time in the first half on, one foot is {fault}."
    )
    return condition


def drifting_foot(log: Log, rng: np.random.Generator) -> Log:
    """Return a log with only raw counts, of which one foot drifts by FAULTY_FOOT_DRIFT."""
    foot = int(rng.integers(4))
    values = raw_counts(log, rng)
    sign = rng.choice([-1.0, 1.0])
    values[:, foot] += sign * FAULTY_FOOT_DRIFT / 60.0 * seconds(log)
    return {
        **log,
        "footForceEst": np.zeros_like(log["footForceEst"]),
        "footForce": int16(values),
    }


def raw_counts(log: Log, rng: np.random.Generator) -> Array:
    """Return the readings of raw foot force sensors (n, 4), before rounding."""
    newtons = normal_forces(log)
    step = np.sqrt(np.diff(seconds(log), prepend=0.0) / 60.0)[:, None]
    walk = np.cumsum(COUNT_DRIFT * step * rng.standard_normal(newtons.shape), axis=0)
    offset, gain = rng.uniform(*COUNT_OFFSET, 4), rng.uniform(*COUNT_GAIN, 4)
    noise = COUNT_NOISE * rng.standard_normal(newtons.shape)
    return np.asarray(offset + walk + gain * newtons + noise)


def seconds(log: Log) -> Array:
    """Return the time (n,) [s] since the first row."""
    tick = log["tick"].astype(np.int64)
    return np.asarray((tick - tick[0]) / 1000.0)


def int16(values: Array) -> Array:
    """Return the values, rounded and clipped to int16."""
    return np.clip(np.round(values), -32768, INT16_MAX).astype(np.int16)


def recorded(log: Log, rng: np.random.Generator) -> Log:
    """Return the log as the controller received it."""
    return log


CONDITIONS: dict[str, Condition] = {
    "est": all_foot_sensors,
    "raw": raw_counts_only,
    "torque": joint_torque_only,
    "stuck": _one_foot("stuck"),
    "zero": _one_foot("zero"),
    "saturated": _one_foot("saturated"),
    "drifting": drifting_foot,
}


def apply_condition(condition: str, log: Log, seed: int) -> Log:
    """Return a log under one of CONDITIONS; random numbers depend on seed and condition only."""
    rng = np.random.default_rng([seed, zlib.crc32(condition.encode())])
    return CONDITIONS[condition](log, rng)
