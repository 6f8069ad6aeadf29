"""Build a RobotConfig from a model and a checked TOML: limits, IMU mount, motors, gains."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import Error, Gains, RobotConfig
from surefoot.robot.gain_files import apply_gains
from surefoot.robot.robot_toml import suggest

_LEG_JOINTS = ("hip", "thigh", "calf")


def build_config(model: Any, table: dict[str, Any]) -> RobotConfig:
    """Build the configuration of a robot.

    Args:
        model: The pinocchio.Model, with a free-flyer root.
        table: The robot's TOML, as returned by read_table().

    Raises:
        Error: The model lacks a joint or frame that the table names, or a gain is invalid.
    """
    config = RobotConfig()
    robot, feet, motors = table["robot"], table["feet"], table["motors"]
    config.name = robot["name"]
    _check_root(config, model)
    config.joint_names = robot["joints"]
    config.foot_frames = feet["frames"]
    config.foot_radius = float(feet["radius"])
    # The default of RobotConfig::friction, chosen: rubber on a smooth floor.
    config.friction = float(robot.get("friction", 0.6))
    config.q_standing = per_motor(robot["standing"], "robot.standing")
    config.armature = per_motor(motors["armature"], "motors.armature")
    _set_imu(config, model, table.get("imu", {}))
    _set_limits(config, model, table.get("limits", {}), float(motors["corner_fraction"]))
    gains = Gains()
    apply_gains(gains, table.get("gains", {}), config.name)
    config.gains = gains
    return config


def _check_root(config: RobotConfig, model: Any) -> None:
    """Raise Error unless joint 1, the root joint, is a free-flyer; joint 0 is the universe."""
    root = model.joints[1] if model.njoints > 1 else None
    if root is None or (root.nq, root.nv) != (7, 6):
        got = "no joint" if root is None else f"'{model.names[1]}' ({root.shortname()})"
        raise Error(
            f"robot '{config.name}': the model's first joint: got {got}, expected a free-flyer; "
            "build the model with a JointModelFreeFlyer root"
        )


def _set_imu(config: RobotConfig, model: Any, imu: dict[str, Any]) -> None:
    if "frame" in imu:
        names = [frame.name for frame in model.frames]
        if imu["frame"] not in names:
            raise Error(
                f"robot '{config.name}': missing IMU frame '{imu['frame']}'"
                f"{suggest(imu['frame'], names)}; the model has: {', '.join(names)}"
            )
        frame = model.frames[names.index(imu["frame"])]
        if frame.parentJoint != 1:
            raise Error(
                f"robot '{config.name}': IMU frame '{imu['frame']}': got parent joint "
                f"'{model.names[frame.parentJoint]}', expected the base"
            )
        import pinocchio

        x, y, z, w = pinocchio.Quaternion(frame.placement.rotation).coeffs()
        config.p_base_imu = frame.placement.translation
        config.quat_base_imu = np.array([w, x, y, z])
    else:
        config.p_base_imu = np.array(imu.get("position", [0, 0, 0]), dtype=float)
        config.quat_base_imu = np.array(imu.get("quaternion", [1, 0, 0, 0]), dtype=float)


def _set_limits(
    config: RobotConfig, model: Any, limits: dict[str, Any], corner_fraction: float
) -> None:
    lower, upper, speed, effort = (np.zeros(12) for _ in range(4))
    for i, name in enumerate(config.joint_names):
        if not model.existJointName(name):
            names = list(model.names)[2:]
            raise Error(
                f"robot '{config.name}': missing joint '{name}' (motor {i})"
                f"{suggest(name, names)}; the model has: {', '.join(names)}"
            )
        joint = model.joints[model.getJointId(name)]
        sdk_limits = limits.get(_LEG_JOINTS[i % 3], [-np.inf, np.inf])
        lower[i] = max(model.lowerPositionLimit[joint.idx_q], sdk_limits[0])
        upper[i] = min(model.upperPositionLimit[joint.idx_q], sdk_limits[1])
        speed[i] = model.velocityLimit[joint.idx_v]
        effort[i] = model.effortLimit[joint.idx_v]
    config.q_lower, config.q_upper = lower, upper
    config.hip_inward = float(limits.get("hip_inward", config.hip_inward))
    config.dq_max, config.no_load_speed, config.tau_max = speed, speed, effort
    config.corner_speed = corner_fraction * speed


def per_motor(values: list[float], field: str) -> np.ndarray:
    """Return an array (12,) in motor order from 12 values, or from 3 (hip, thigh, calf).

    Three values are repeated for each leg. `field` names the values in the message.

    Raises:
        Error: `values` has neither 3 nor 12 entries.
    """
    if len(values) not in (3, 12):
        raise Error(f"{field}: got {len(values)} values, expected 3 (hip, thigh, calf) or 12")
    return np.array(values * (12 // len(values)), dtype=float)
