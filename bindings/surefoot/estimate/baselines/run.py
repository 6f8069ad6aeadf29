"""Run of all baselines over the same rows."""

from __future__ import annotations

from surefoot.estimate.base_motion import BaseMotion
from surefoot.estimate.baselines.inputs import BaselineInputs
from surefoot.estimate.baselines.leg_odometry import leg_odometry
from surefoot.estimate.baselines.linear_filter import linear_filter
from surefoot.estimate.baselines.stance_trust import stance_trust
from surefoot.estimate.baselines.vqf_attitude import vqf_attitude
from surefoot.estimate.foot_motion import foot_motion

LINEAR_FILTER, LEG_ODOMETRY = "linear_kalman_filter", "leg_odometry"


def run_baselines(inputs: BaselineInputs) -> dict[str, BaseMotion]:
    """Return the motions by LINEAR_FILTER and LEG_ODOMETRY, both with the attitude of VQF.

    The world frames start at the first position of the base, with its heading as x. A minute at
    500 Hz takes about 4 s.

    Raises:
        Error: The package vqf is not installed.
    """
    rotation = vqf_attitude(inputs)
    feet = foot_motion(inputs.robot, inputs.q, inputs.dq)
    trust = stance_trust(inputs.time, inputs.contact)
    return {
        LINEAR_FILTER: linear_filter(inputs, rotation, feet, trust),
        LEG_ODOMETRY: leg_odometry(inputs, rotation, feet, trust),
    }
