"""Verdict on a quiet stand: whether the body still has its initial pose."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot.assess.condition import Condition
from surefoot.assess.push_outcome import attitude_angles
from surefoot.assess.rollout import TrueTrajectory
from surefoot.stand.foot_frame import pose_in_support, rotation_angle

# Protocol of docs/reference/scorecard.md. Chosen: after the ground motion, the body stops swinging
# within these times; longer times only cost run time.
HOLD_TIME = 4.0  # [s] time of standing after the quiet phase and the ground motion
JUDGED_TIME = 1.0  # [s] time at the end of the run in which tilt and height are judged


@dataclass(frozen=True)
class StandOutcome:
    """Outcome of a quiet stand: largest errors relative to the initial pose.

    On moving ground the body may keep its attitude or follow the ground. So tilt and height are
    compared with the initial pose in two frames, the world frame and a frame along the plane of the
    feet, and the smaller error counts. On moving ground, only the horizontal part of a foot
    displacement counts.

    Attributes:
        stood: True if the robot did not fall.
        tilt_deg: Largest attitude error of the base in the last JUDGED_TIME [deg]; None after a
            fall.
        height_mm: Largest error of the base height above the feet in the last JUDGED_TIME [mm];
            None after a fall.
        foot_mm: Largest slide or lift of a foot in the whole run [mm].
    """

    stood: bool
    tilt_deg: float | None
    height_mm: float | None
    foot_mm: float

    def passes(self, condition: Condition) -> bool:
        """Return True if all errors are within the tolerances of the condition."""
        if self.tilt_deg is None or self.height_mm is None:
            return False
        return (
            self.tilt_deg <= condition.tilt_within_deg
            and self.height_mm <= condition.height_within_mm
            and self.foot_mm <= condition.foot_within_mm
        )


def judge_stand(trajectory: TrueTrajectory, condition: Condition) -> StandOutcome:
    """Return the outcome of a quiet stand from its true motion."""
    axis_count = 2 if condition.ground_moves else 3
    foot = float(
        np.linalg.norm(
            (trajectory.feet_without_roll - trajectory.feet_without_roll[0])[:, :, :axis_count],
            axis=2,
        ).max()
    )
    if trajectory.fall_tick is not None:
        return StandOutcome(False, None, None, 1e3 * foot)
    last = slice(-round(JUDGED_TIME * trajectory.rate), None)
    base, feet = trajectory.base[last], trajectory.feet[last]
    tilt = attitude_angles(base[:, 3:], trajectory.base[0, 3:])
    height_over_feet = base[:, 2] - feet[:, :, 2].mean(axis=1)
    initial_height = trajectory.base[0, 2] - trajectory.feet[0, :, 2].mean()
    height = np.abs(height_over_feet - initial_height)
    if condition.ground_moves:
        rows = np.vstack([trajectory.base[:1], base])[:, [0, 1, 2, 4, 5, 6, 3]]
        pose = pose_in_support(rows, np.moveaxis(np.vstack([trajectory.feet[:1], feet]), 1, 2))
        turn_angle = rotation_angle(pose.rotation[0].T @ pose.rotation[1:])
        tilt = np.minimum(tilt, turn_angle)
        height = np.minimum(height, np.abs(pose.position[1:, 2] - pose.position[0, 2]))
    return StandOutcome(True, float(np.degrees(tilt.max())), 1e3 * float(height.max()), 1e3 * foot)
