"""One push, judged: did it survive, and did it stand as if nothing had been."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from surefoot.assess.rollout import Track
from surefoot.sim.rotations import Array

UPRIGHT = 3.0  # [s] after the push in which a robot that survived may not fall
BACK = 2.0  # [s] after which it is back, for a strict pass
FOOT_TRAVEL = 0.01  # [m] most that any foot may slide or lift, ever; rolling is neither
BACK_DISTANCE = 0.01  # [m] of the base from where it was
BACK_ANGLE = 2.0  # [deg] of the base from how it was


@dataclass(frozen=True)
class Outcome:
    """What came of one push.

    Attributes:
        survived: Upright UPRIGHT after the push, and nothing but feet touched the ground.
        strict: Survived, no foot ever moved by FOOT_TRAVEL, and from BACK on the base is where and
            as it was.
        foot_mm: Farthest that a foot slid or lifted [mm]; None if the controller broke.
        back_mm: Farthest that the base is off from BACK on [mm]; None if it fell.
        back_deg: Most that it is turned [deg].
    """

    survived: bool
    strict: bool
    foot_mm: float | None
    back_mm: float | None
    back_deg: float | None


BROKEN = Outcome(survived=False, strict=False, foot_mm=None, back_mm=None, back_deg=None)
"""Of a push under which the controller broke."""


def judge(track: Track, begin: float, duration: float) -> Outcome:
    """Judge a run.

    Args:
        track: Until UPRIGHT after the push.
        begin: Of the push [s].
        duration: Of the push [s].
    """
    first = min(round(begin * track.rate), len(track.base) - 1)  # it may fall before
    feet = np.linalg.norm(track.unrolled[first:] - track.unrolled[first], axis=2)
    foot = float(feet.max())
    if track.fell is not None:
        return Outcome(False, False, 1e3 * foot, None, None)
    back = track.base[round((begin + duration + BACK) * track.rate) :]
    distance = float(np.linalg.norm(back[:, :3] - track.base[first, :3], axis=1).max())
    angle = float(np.degrees(angles(back[:, 3:], track.base[first, 3:]).max()))
    good = foot <= FOOT_TRAVEL and distance <= BACK_DISTANCE and angle <= BACK_ANGLE
    return Outcome(True, good, 1e3 * foot, 1e3 * distance, angle)


def angles(q: Array, reference: Array) -> Array:
    """Return the angles (n,) [rad] between attitudes (n, 4) and one (4,), unit quaternions."""
    # The chord is exact where the dot product of nearly equal quaternions is not.
    near = np.linalg.norm(q - reference, axis=1)
    far = np.linalg.norm(q + reference, axis=1)
    return np.asarray(4.0 * np.arcsin(np.minimum(1.0, 0.5 * np.minimum(near, far))))


def run_length(begin: float, duration: float) -> float:
    """Return how long a run with a push has to be [s], whole milliseconds."""
    return math.ceil(1e3 * (begin + duration + UPRIGHT)) / 1e3
