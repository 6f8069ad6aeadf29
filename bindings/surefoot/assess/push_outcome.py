"""One push, judged: did it survive, and did it stand as if nothing had been."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from surefoot.assess.rollout import TrueTrajectory
from surefoot.geometry.rotations import Array

SURVIVAL_TIME = 3.0  # [s] after the push in which a robot that survived may not fall
RETURN_TIME = 2.0  # [s] after which it is back, for a strict pass
MAX_FOOT_TRAVEL = 0.01  # [m] most that any foot may slide or lift, ever; rolling is neither
RETURN_DISTANCE = 0.01  # [m] of the base from where it was
RETURN_ANGLE = 2.0  # [deg] of the base from how it was


@dataclass(frozen=True)
class PushOutcome:
    """What came of one push.

    Attributes:
        survived: Upright UPRIGHT after the push, and nothing but feet touched the ground.
        in_place: Survived, no foot ever moved by MAX_FOOT_TRAVEL, and from BACK on the base is where and
            as it was.
        foot_mm: Farthest that a foot slid or lifted [mm]; None if the controller broke.
        return_error_mm: Farthest that the base is off from BACK on [mm]; None if it fell.
        return_error_deg: Most that it is turned [deg].
    """

    survived: bool
    in_place: bool
    foot_mm: float | None
    return_error_mm: float | None
    return_error_deg: float | None


FAILED_OUTCOME = PushOutcome(
    survived=False, in_place=False, foot_mm=None, return_error_mm=None, return_error_deg=None
)
"""Of a push under which the controller broke."""


def judge_push(trajectory: TrueTrajectory, push_time: float, duration: float) -> PushOutcome:
    """Judge a run.

    Args:
        trajectory: Until UPRIGHT after the push.
        push_time: Of the push [s].
        duration: Of the push [s].
    """
    first = min(round(push_time * trajectory.rate), len(trajectory.base) - 1)  # it may fall before
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
    in_place = foot <= MAX_FOOT_TRAVEL and distance <= RETURN_DISTANCE and angle <= RETURN_ANGLE
    return PushOutcome(True, in_place, 1e3 * foot, 1e3 * distance, angle)


def attitude_angles(q: Array, reference: Array) -> Array:
    """Return the angles (n,) [rad] between attitudes (n, 4) and one (4,), unit quaternions."""
    # The chord is exact where the dot product of nearly equal quaternions is not.
    chord = np.linalg.norm(q - reference, axis=1)
    opposite_chord = np.linalg.norm(q + reference, axis=1)
    return np.asarray(4.0 * np.arcsin(np.minimum(1.0, 0.5 * np.minimum(chord, opposite_chord))))


def run_duration(push_time: float, duration: float) -> float:
    """Return how long a run with a push has to be [s], whole milliseconds."""
    return math.ceil(1e3 * (push_time + duration + SURVIVAL_TIME)) / 1e3
