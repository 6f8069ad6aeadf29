"""Our program's weights in the peers' units."""

from __future__ import annotations

import numpy as np
import pinocchio

from surefoot._core import Gains, Robot

GRAVITY = 9.81
# Of forces, per N^2. Ours draws to the forces that fulfil the tasks, which costs the tasks nothing;
# the peers draw to a quarter of the weight and to zero: so little that it costs them nothing.
FORCE_WEIGHT = 1e-6


def peer_weights(robot: Robot, gains: Gains) -> dict[str, float]:
    """Return weights per squared acceleration (com, base, posture) and force; com is one.

    Ours weigh accelerations in units of what a quarter of the weight on a foot does: of the centre
    of mass exactly, of the base by the inertia of the robot with its joints locked, which is near
    what the program takes.

    Args:
        robot: In its standing pose.
        gains: Whose weights.
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
    # Hip axes are as high as the thighs' joints: the second of each leg.
    hips = [data.oMi[model.getJointId(robot.config.joint_names[i])] for i in range(1, 12, 3)]
    leg_length = float(np.mean([hip.translation[2] for hip in hips]) - feet[:, 2].mean())
    com = gains.weight_com_horizontal * (2.0 / GRAVITY) ** 2
    return {
        "com": 1.0,
        "base": float(gains.weight_base_tilt * angular**2 / com),
        "posture": float(gains.weight_posture * (leg_length / GRAVITY) ** 2 / com),
        "force": FORCE_WEIGHT,
    }
