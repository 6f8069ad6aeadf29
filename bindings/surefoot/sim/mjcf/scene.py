"""The scene of an MJCF file, with the names and joint conventions of the controller's robot."""

from __future__ import annotations

from pathlib import Path

import mujoco

from surefoot._core import Error, Robot
from surefoot.sim.mjcf.adapt import adapt_mjcf
from surefoot.sim.mjcf.find import find_parts, length_doubts
from surefoot.sim.mjcf.imu_mount import ImuMount
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
            supported, or the legs are those of another robot.
    """
    check_replaced_settings(settings)
    parts = find_parts(path, robot)
    for doubt in length_doubts(parts, robot, _OTHER_ROBOT):
        raise Error(f"MJCF '{path}': {doubt}")
    adapt_mjcf(parts, robot, settings, visuals)
    return parts.spec, parts.imu
