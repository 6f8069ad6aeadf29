"""Checks of the signs of the joint torques: they must carry the robot.

The feet of the right legs are to the right of their hips, so the weight turns the hips of both
sides in opposite directions. Hip torques of the opposite sign show exchanged legs even at rest.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot._core import Error, Robot
from surefoot.estimate.checks.windows import finite_median
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.sensor_log import SensorLog

GRAVITY = 9.81
# Chosen, with equal distance from 0. The share is 1 for a standing foot, 0 for a foot in the air,
# and -1 for a standing foot whose torque has the wrong sign.
MAX_PULLING_SHARE = -0.3  # calf torque over that of a loaded leg, below which the foot pulls
MIN_LOADED_SHARE = 0.3  # calf torque over that of a loaded leg, above which the foot is loaded


def check_torques(robot: Robot, log: SensorLog) -> list[str]:
    """Compare the median torques with the torques that carry the weight in the median pose.

    Returns:
        Warnings.

    Raises:
        Error: The calf torques of all four legs have the wrong sign: the feet would pull the
            ground up. Or the hip torques of two or more loaded legs have the wrong sign.
    """
    if "tauEst" not in log.columns:
        return []
    shares = finite_median(log.columns["tauEst"]) / _standing_torques(robot, log)
    share = shares[2::3]
    if np.all(share < MAX_PULLING_SHARE):
        raise Error(
            f"{log.source}: column 'tauEst': got median calf torques {np.mean(share):.2f} "
            "times those that carry the robot, expected the same sign"
        )
    doubts = _check_sides(log, shares[0::3], share)
    pulling = [leg for leg, value in zip(LEGS, share, strict=True) if value < MAX_PULLING_SHARE]
    if pulling:
        doubts.append(f"tauEst of {', '.join(pulling)} pulls the ground up most of the time")
    return doubts


def _check_sides(log: SensorLog, hip_share: Array, calf_share: Array) -> list[str]:
    """Check that the hips of loaded legs carry the robot as hips of their side do.

    On slopes of up to 10 deg, with payloads and pushes, a healthy hip has a share of 0.4 to 1.7.
    The hip of a leg of the other side has the negative. A lateral force of a third of the foot's
    load would reverse a healthy hip too, so one leg is a doubt.

    Args:
        log: The log.
        hip_share: (4,) hip torques over those of loaded legs.
        calf_share: (4,) calf torques over those of loaded legs.

    Returns:
        Warnings.

    Raises:
        Error: Two or more hips have the wrong sign.
    """
    wrong = (hip_share < MAX_PULLING_SHARE) & (calf_share > MIN_LOADED_SHARE)
    legs = ", ".join(leg for leg, found in zip(LEGS, wrong, strict=True) if found)
    if not legs:
        return []
    if np.count_nonzero(wrong) == 1:
        return [f"tauEst: the hip of {legs} carries the robot as a leg of the other side would"]
    raise Error(
        f"{log.source}: columns 'q' and 'tauEst': got hip torques of {legs} with "
        f"{np.mean(hip_share[wrong]):.2f} times the value that carries the robot, expected the "
        "same sign: are left and right legs exchanged? Use the order FR FL RR RL, signs of the SDK"
    )


def feet_are_loaded(robot: Robot, log: SensorLog, rows: npt.NDArray[np.int64]) -> bool:
    """Return whether the median calf torques over `rows` show that all feet are loaded."""
    if "tauEst" not in log.columns:
        return False
    share = finite_median(log.columns["tauEst"][rows])[2::3] / _standing_torques(robot, log)[2::3]
    return bool(np.all(share > MIN_LOADED_SHARE))


def _standing_torques(robot: Robot, log: SensorLog) -> Array:
    """Compute the torques (12,) [N.m] of a level robot at rest on four equally loaded feet."""
    import pinocchio

    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    data = model.createData()
    q = robot.q_standing()
    q[list(robot.motor_to_q)] = finite_median(log.columns["q"])
    tau = pinocchio.computeGeneralizedGravity(model, data, q)
    pinocchio.computeJointJacobians(model, data, q)
    pinocchio.updateFramePlacements(model, data)
    for frame in robot.foot_frame_ids:
        J = pinocchio.getFrameJacobian(model, data, frame, pinocchio.LOCAL_WORLD_ALIGNED)
        tau = tau - 0.25 * robot.mass * GRAVITY * J[2]
    return np.asarray(tau[list(robot.motor_to_v)])
