"""Verdict on one push: whether the robot survived it, and whether it stayed in place."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from surefoot.assess.rollout import TrueTrajectory
from surefoot.geometry.rotations import Array

# Protocol of docs/reference/scorecard.md, chosen. The times are 15 and 10 time constants of the LIP
# (0.2 s); longer times only cost run time. The tolerances exceed the motions that noise and soft
# contacts cause (0.1 mm, 0.05 deg).
SURVIVAL_TIME = 3.0  # [s] time after the end of a push without a fall that counts as survived
RETURN_TIME = 2.0  # [s] time after the end of a push at which the body must be back in its pose
MAX_FOOT_DISPLACEMENT = 0.01  # [m] tolerance of a foot's slide or lift; rolling does not count
RETURN_DISTANCE = 0.01  # [m] tolerance of the base position after RETURN_TIME
RETURN_ANGLE = 2.0  # [deg] tolerance of the base attitude after RETURN_TIME


@dataclass(frozen=True)
class PushOutcome:
    """Outcome of one push.

    Attributes:
        survived: True if the robot stays upright for SURVIVAL_TIME and only feet touch the ground.
        in_place: True if the robot survived, no foot moved by more than MAX_FOOT_DISPLACEMENT, and
            after RETURN_TIME the base stays within RETURN_DISTANCE and RETURN_ANGLE of its pose
            before the push.
        foot_mm: Largest slide or lift of a foot [mm]; None if the controller failed.
        return_error_mm: Largest base position error after RETURN_TIME [mm]; None if the robot fell
            or the controller failed.
        return_error_deg: Largest base attitude error after RETURN_TIME [deg]; None if the robot
            fell or the controller failed.
    """

    survived: bool
    in_place: bool
    foot_mm: float | None
    return_error_mm: float | None
    return_error_deg: float | None


FAILED_OUTCOME = PushOutcome(
    survived=False, in_place=False, foot_mm=None, return_error_mm=None, return_error_deg=None
)
"""Outcome of a push in which the controller failed."""


def judge_push(trajectory: TrueTrajectory, push_time: float, duration: float) -> PushOutcome:
    """Return the outcome of a run with one push.

    Args:
        trajectory: True motion until SURVIVAL_TIME after the end of the push, or until the fall.
        push_time: Time at which the push begins [s].
        duration: Duration of the push [s].
    """
    # Row at the start of the push; the last row if the robot fell before the push.
    first = min(round(push_time * trajectory.rate), len(trajectory.base) - 1)
    feet = np.linalg.norm(
        trajectory.feet_without_roll[first:] - trajectory.feet_without_roll[first], axis=2
    )
    foot = float(feet.max())
    if trajectory.fall_tick is not None:
        return PushOutcome(False, False, 1e3 * foot, None, None)
    after_return = trajectory.base[round((push_time + duration + RETURN_TIME) * trajectory.rate) :]
    distance = float(np.linalg.norm(after_return[:, :3] - trajectory.base[first, :3], axis=1).max())
    angle = float(
        np.degrees(attitude_angles(after_return[:, 3:], trajectory.base[first, 3:]).max())
    )
    in_place = (
        foot <= MAX_FOOT_DISPLACEMENT and distance <= RETURN_DISTANCE and angle <= RETURN_ANGLE
    )
    return PushOutcome(True, in_place, 1e3 * foot, 1e3 * distance, angle)


def attitude_angles(q: Array, reference: Array) -> Array:
    """Return the angles (n,) [rad] between unit quaternions q (n, 4) and one reference (4,)."""
    # The chord length stays accurate for nearly equal quaternions; their dot product does not.
    chord = np.linalg.norm(q - reference, axis=1)
    opposite_chord = np.linalg.norm(q + reference, axis=1)
    return np.asarray(4.0 * np.arcsin(np.minimum(1.0, 0.5 * np.minimum(chord, opposite_chord))))


def run_duration(push_time: float, duration: float) -> float:
    """Return the duration of a run with a push [s], rounded up to whole milliseconds.

    Args:
        push_time: Time at which the push begins [s].
        duration: Duration of the push [s].
    """
    return math.ceil(1e3 * (push_time + duration + SURVIVAL_TIME)) / 1e3
