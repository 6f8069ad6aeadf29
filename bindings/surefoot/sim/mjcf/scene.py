"""The scene of an MJCF file, with the names and joint conventions of the controller's robot."""

from __future__ import annotations

from pathlib import Path

import mujoco

from surefoot._core import Error, Robot
from surefoot.sim.mjcf.adapt import adapt_mjcf
from surefoot.sim.mjcf.doubts import length_doubts
from surefoot.sim.mjcf.find import MjcfParts, find_parts
from surefoot.sim.mjcf.imu_mount import ImuMount
from surefoot.sim.mjcf.names import joint_name
from surefoot.sim.mjcf.replaced_settings import check_replaced_settings
from surefoot.sim.settings import PlantSettings

# Smallest difference of link lengths that is refused, as a share. Chosen: above the 17 % between
# go1 and aliengo, and below the 60 % between go2 and b2, whose legs the controller cannot fold.
_OTHER_ROBOT = 0.25


def mjcf_scene(
    robot: Robot, path: Path, settings: PlantSettings, visuals: bool
) -> tuple[mujoco.MjSpec, ImuMount]:
    """Return the scene of an MJCF file without sensors and actuators, and the mount of its IMU.

    Args:
        robot: The controller's robot.
        path: The MJCF file.
        settings: Settings of the plant, without those that the file replaces.
        visuals: Whether to keep geoms that do not collide, for pictures.

    Raises:
        Error: A setting is replaced by the file, the file is invalid, a part is missing or not
            supported, the legs are those of another robot, or a joint cannot reach the standing
            pose.
    """
    check_replaced_settings(settings)
    parts = find_parts(path, robot)
    for difference in length_doubts(parts, robot, _OTHER_ROBOT):
        raise Error(f"MJCF '{path}': {difference}; choose the robot of the file (--robot)")
    _check_ranges(parts, path, robot)
    adapt_mjcf(parts, robot, settings, visuals)
    return parts.spec, parts.imu


def _check_ranges(parts: MjcfParts, path: Path, robot: Robot) -> None:
    """Raise Error if the standing pose is outside the range of a joint of the file."""
    model, joints = parts.model, [joint for leg in parts.tree.legs for joint in leg]
    for joint, convention, standing in zip(
        joints, parts.conventions, robot.config.q_standing, strict=True
    ):
        start = float(model.qpos0[model.jnt_qposadr[joint]])
        angle = start + convention.sign * (standing - convention.reference)
        low, high = model.jnt_range[joint]
        if model.jnt_limited[joint] and not low <= angle <= high:
            raise Error(
                f"MJCF '{path}': joint '{joint_name(model, joint)}': got range {low:.4g} .. "
                f"{high:.4g} rad, expected one with the standing pose of '{robot.name}', "
                f"{angle:.4g} rad in the file; widen the range"
            )
