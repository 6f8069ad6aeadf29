"""A quiet stand, judged: is the body still where and as it was when the robot was handed over."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot.assess.condition import Condition
from surefoot.assess.push_run import angles
from surefoot.assess.rollout import Track
from surefoot.stand.geometry import pose_in_support, rotation_angle

HOLD = 4.0  # [s] of standing after the quiet and what moved
WINDOW = 1.0  # [s] at the end over which it is judged


@dataclass(frozen=True)
class Stood:
    """What came of a stand, the worst of the last WINDOW, from the pose that was handed over.

    On ground that moves a body may stay level or be carried along: the smaller angle and height
    counts, and feet are seen from above.

    Attributes:
        stood: Did it stand to the end?
        tilt_deg: Of the body from its attitude [deg]; None if it fell.
        height_mm: Of the body above its feet [mm].
        foot_mm: Farthest that a foot ever moved [mm].
    """

    stood: bool
    tilt_deg: float | None
    height_mm: float | None
    foot_mm: float

    def passes(self, condition: Condition) -> bool:
        """Is it within what the condition asks for?"""
        if self.tilt_deg is None or self.height_mm is None:
            return False
        return (
            self.tilt_deg <= condition.tilt_within_deg
            and self.height_mm <= condition.height_within_mm
            and self.foot_mm <= condition.foot_within_mm
        )


def judge_stand(track: Track, condition: Condition) -> Stood:
    """Judge a run."""
    axes = 2 if condition.moves else 3
    foot = float(np.linalg.norm((track.unrolled - track.unrolled[0])[:, :, :axes], axis=2).max())
    if track.fell is not None:
        return Stood(False, None, None, 1e3 * foot)
    last = slice(-round(WINDOW * track.rate), None)
    base, feet = track.base[last], track.feet[last]
    tilt = angles(base[:, 3:], track.base[0, 3:])
    rise = base[:, 2] - feet[:, :, 2].mean(axis=1)
    first = track.base[0, 2] - track.feet[0, :, 2].mean()
    height = np.abs(rise - first)
    if condition.moves:
        rows = np.vstack([track.base[:1], base])[:, [0, 1, 2, 4, 5, 6, 3]]
        pose = pose_in_support(rows, np.moveaxis(np.vstack([track.feet[:1], feet]), 1, 2))
        turned = rotation_angle(pose.rotation[0].T @ pose.rotation[1:])
        tilt = np.minimum(tilt, turned)
        height = np.minimum(height, np.abs(pose.position[1:, 2] - pose.position[0, 2]))
    return Stood(True, float(np.degrees(tilt.max())), 1e3 * float(height.max()), 1e3 * foot)
