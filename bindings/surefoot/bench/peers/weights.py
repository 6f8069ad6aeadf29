"""Weights of our QP in the units of the peers."""

from __future__ import annotations

import numpy as np
import pinocchio

from surefoot._core import Gains, Robot

GRAVITY = 9.81
# [1/N^2] Weight of the contact forces in the cost of the peers. TSID penalises the deviation of
# each force from m g / 4 upward, PlaCo the force itself. (Our QP penalises the deviation from the
# even forces.) Chosen: so small that the peers' other tasks are not disturbed.
FORCE_WEIGHT = 1e-6


def peer_weights(robot: Robot, gains: Gains) -> dict[str, float]:
    """Compute the weights of squared accelerations (com, base, posture) and forces; com is 1.

    Our QP divides each acceleration by a scale. A force of m g / 4 on one foot causes an
    acceleration; the scale is the root of the sum of its squares over the four feet. So the scale
    of the centre of mass is g / 2. For the base, this function computes the scale from the inertia
    of the robot with locked joints, which gives almost the scale of the QP. For the posture, the
    scale is g / leg length.

    Args:
        robot: Robot, evaluated in its standing pose.
        gains: Gains with the weights to convert.
    """
    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    data = model.createData()
    q = robot.q_standing()
    pinocchio.ccrba(model, data, q, np.zeros(model.nv))
    pinocchio.framesForwardKinematics(model, data, q)
    feet = np.array([data.oMf[i].translation for i in robot.foot_frame_ids])
    inverse = np.linalg.inv(data.Ig.inertia)
    angular_response = np.hstack([inverse @ pinocchio.skew(foot - data.com[0]) for foot in feet])
    foot_load = 0.25 * robot.mass * GRAVITY
    angular = np.sqrt(3.0) / (foot_load * np.linalg.norm(angular_response))
    # The hip height is that of the thigh joints (the second joint of each leg).
    hips = [data.oMi[model.getJointId(robot.config.joint_names[i])] for i in range(1, 12, 3)]
    leg_length = float(np.mean([hip.translation[2] for hip in hips]) - feet[:, 2].mean())
    com = gains.weight_com_horizontal * (2.0 / GRAVITY) ** 2
    return {
        "com": 1.0,
        "base": float(gains.weight_base_tilt * angular**2 / com),
        "posture": float(gains.weight_posture * (leg_length / GRAVITY) ** 2 / com),
        "force": FORCE_WEIGHT,
    }
