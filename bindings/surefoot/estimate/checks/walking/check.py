"""Verdicts about the sensors of a walking robot, from the hypothesis that explains the log best."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot._core import Error, Robot
from surefoot.estimate.checks.walking.foot_forces import check_foot_forces
from surefoot.estimate.checks.walking.hypotheses import FAULTS, Fit, WalkingEvidence
from surefoot.estimate.checks.walking.identities import LOGGED
from surefoot.estimate.checks.walking.imu_path import ImuIntegrals
from surefoot.estimate.checks.walking.leg_paths import LegPaths, leg_paths
from surefoot.estimate.checks.walking.stances import Stances, find_stances
from surefoot.estimate.checks.windows import DEG_PER_RAD
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.sensor_log import SensorLog

# Number of swings of every leg from which on a log shows a walking robot. Chosen: a robot that
# regains its balance makes fewer.
MIN_STEPS = 4
# Smallest gain of the logarithm of the likelihood over healthy sensors, for a warning and for an
# error. Chosen: healthy logs have up to 1, wrong signs 70 and more.
MIN_EVIDENCE, ERROR_EVIDENCE = 1.5, 5.0
# Smallest gain of the logarithm of the RMS of one identity, for faults without a parameter whose
# size could be judged. Chosen: half of what the faults give in simulated logs; in long logs, a
# small gain would be strong evidence.
IMPROVEMENTS = {"order": 0.5, "delay": 0.5}
# Smallest fault that counts. Chosen: what an estimate does not survive unharmed, and several times
# what sole radius, mounting and calibration cause.
MIN_SCALE = 1.25  # ratio of the gyroscope to the legs, or its inverse
MIN_GYRO_BIAS = 0.08  # [rad/s]
MIN_ACCELEROMETER_BIAS = 0.6  # [m/s^2]
MIN_CALF_OFFSET = 0.07  # [rad]
MIN_DELAY = 0.01  # [s]
# Smallest error of a gyroscope's scale, in its standard deviations. Chosen: about an axis that
# hardly turns, as the pitch axis of a b1 that trots, a healthy log gives 2.7.
GAIN_SIGMAS = 3.0
_BIASES = {
    "gyroscope": ("rad/s", MIN_GYRO_BIAS),
    "accelerometer": ("m/s^2", MIN_ACCELEROMETER_BIAS),
}


@dataclass(frozen=True)
class WalkingLog:
    """A log of a robot that walks."""

    robot: Robot
    log: SensorLog
    paths: LegPaths
    stances: Stances


def find_walk(robot: Robot, log: SensorLog) -> WalkingLog | None:
    """Return the feet of a walking robot; None if the robot does not walk."""
    paths = leg_paths(robot, log)
    if paths is None:
        return None
    stances = find_stances(paths)
    return WalkingLog(robot, log, paths, stances) if stances.steps.min() >= MIN_STEPS else None


def check_walk(walk: WalkingLog) -> list[str]:
    """Return a warning for the fault that explains a walking log, and for its foot forces.

    Raises:
        Error: Legs are exchanged, or the gyroscope has a wrong sign or unit.
    """
    with np.errstate(over="ignore", invalid="ignore"):  # absurd values explain nothing
        integrals = ImuIntegrals(walk.robot, walk.log, walk.stances.stride)
        healthy, *faults = WalkingEvidence(walk.paths, walk.stances, integrals).fits()
    best = min(faults, key=lambda fit: fit.cost)
    text = _describe(best) if _is_proven(healthy, best) else None
    if text is not None and _is_error(best):
        raise Error(f"{walk.log.source}: {text}")
    order = best.order if text is not None else LOGGED
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        forces = check_foot_forces(walk.log, walk.paths, walk.stances, order)
    return [*([text] if text is not None else []), *forces]


def _is_proven(healthy: Fit, best: Fit) -> bool:
    """Return whether a fault explains a log clearly better than healthy sensors."""
    better = np.log(healthy.rms / np.maximum(best.rms, 1e-12)).max()
    evidence = ERROR_EVIDENCE if _is_error(best) else MIN_EVIDENCE
    least = IMPROVEMENTS.get(best.fault, -np.inf)
    return bool(healthy.cost - best.cost > evidence and better >= least)


def _is_error(fit: Fit) -> bool:
    if fit.fault.startswith("gain"):
        return _gain(fit) < 0.0 or _gain(fit) > 0.5 * DEG_PER_RAD
    return fit.fault == "order"


def _gain(fit: Fit) -> float:
    """Return the reading of the gyroscope over the true rate."""
    return float(1.0 / (1.0 + fit.x[FAULTS[fit.fault][0]]))


def _describe(fit: Fit) -> str | None:
    """Return a sentence about a fault; None if it is too small to count."""
    if fit.fault == "order":
        names = " ".join(LEGS[fit.order.index(leg)] for leg in range(4))
        return (
            "columns 'q' and 'gyroscope': got feet that stay in place with the legs in the order "
            f"{names} while the robot walks, expected FR FL RR RL, signs of the SDK"
        )
    if fit.fault == "delay":
        if abs(fit.delay) < MIN_DELAY:
            return None
        late, other = ("IMU is", "joints") if fit.delay > 0.0 else ("joints are", "IMU")
        return f"the {late} late by {1000.0 * abs(fit.delay):.0f} ms against the {other}"
    if fit.fault.startswith("gain"):
        (column,) = FAULTS[fit.fault]
        if abs(fit.x[column]) < GAIN_SIGMAS * fit.sigma[column]:
            return None
        return _describe_gain("xyz"[column], _gain(fit))
    x = fit.x[FAULTS[fit.fault]]
    if fit.fault.startswith("calf"):
        small = abs(x[0]) < MIN_CALF_OFFSET
        leg = LEGS[int(fit.fault[-1])]
        return None if small else f"q: the calf of {leg} has an offset of {-x[0]:+.2f} rad"
    sensor = fit.fault.split()[0]
    unit, smallest = _BIASES[sensor]
    if np.linalg.norm(x) < smallest:
        return None
    values = ", ".join(f"{value:.2f}" for value in x)
    return f"{sensor} has a bias of {values} {unit} (x, y, z of the base)"


def _describe_gain(axis: str, gain: float) -> str | None:
    if gain < 0.0:
        return (
            f"column 'gyroscope': got rates by which axis {axis} of the base turns {gain:.2f} "
            "times as far as the legs show, expected the same sign"
        )
    if gain > 0.5 * DEG_PER_RAD:
        return (
            f"column 'gyroscope': got rates about axis {axis} of the base {gain:.0f} times those "
            "that the legs show, expected rad/s: it seems to be in deg/s"
        )
    if 1.0 / MIN_SCALE < gain < MIN_SCALE:
        return None
    return f"gyroscope: axis {axis} of the base turns {gain:.2f} times as far as the legs show"
