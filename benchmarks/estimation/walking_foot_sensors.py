"""Foot sensors of a walking robot: convert a log to the log of other foot sensors."""

from __future__ import annotations

import math
import zlib

import numpy as np
from surefoot.sim.hardware.foot_sensors import COUNT_NOISE, COUNT_OFFSET, FORCE_NOISE
from surefoot.sim.hardware.walking_errors import COUNT_GAIN, FORCE_FALL_TIME

from estimation.degraded_foot_sensors import int16, normal_forces
from estimation.log_rows import Array, Log
from estimation.recording import sample_rate

WALKING_CONDITIONS = ("est", "dead", "raw without torques")


def walking_condition(condition: str, log: Log, seed: int) -> Log:
    """Return a log with one of WALKING_CONDITIONS.

    "est": both fields work. "dead": both are zero. "raw without torques": footForce and no joint
    torques. The measured forces fall late, with the time constant of the plant.
    """
    rng = np.random.default_rng([seed, zlib.crc32(condition.encode())])
    zeros = np.zeros_like(log["footForce"])
    if condition == "dead":
        return {**log, "footForce": zeros, "footForceEst": zeros}
    force = late_forces(log)
    newtons = force + FORCE_NOISE * rng.standard_normal(force.shape)
    noise = COUNT_NOISE * rng.standard_normal(force.shape)
    counts = rng.uniform(*COUNT_OFFSET, 4) + rng.uniform(*COUNT_GAIN, 4) * force + noise
    if condition == "est":
        return {**log, "footForceEst": int16(newtons), "footForce": int16(counts)}
    no_torques = np.zeros_like(log["tauEst"])
    return {**log, "footForceEst": zeros, "footForce": int16(counts), "tauEst": no_torques}


def late_forces(log: Log) -> Array:
    """Return the vertical forces (n, 4) [N] that follow a falling force with FORCE_FALL_TIME."""
    force = normal_forces(log).copy()
    keep = math.exp(-1.0 / (sample_rate(log) * FORCE_FALL_TIME))
    for k in range(1, len(force)):
        force[k] = np.maximum(force[k], keep * force[k - 1] + (1.0 - keep) * force[k])
    return force
