"""Finds the IMU of a compiled model: a site by its name or by the file's gyroscope."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import mujoco
import numpy as np

from surefoot._core import Robot
from surefoot.geometry.rotations import Array
from surefoot.sim.mjcf.tree import Tree

# [rad] Largest angle that counts as an inaccurate mount. Chosen: a larger one is another
# convention of the axes, for the axes in LowState are those of the robot's SDK.
_MAX_MOUNT_ERROR = math.radians(10.0)


@dataclass(frozen=True)
class ImuMount:
    """Pose of the IMU in the base frame.

    Attributes:
        position: (3,) [m].
        quaternion: (4,) rotation from IMU to base axes, w x y z.
        source: Where the pose was found, in words.
    """

    position: Array
    quaternion: Array
    source: str


def find_imu(model: mujoco.MjModel, tree: Tree, robot: Robot) -> ImuMount:
    """Return the mount of the IMU.

    The IMU is the site on the base with "imu" in its name, else the site of the file's gyroscope,
    else the IMU mount of the robot's TOML.
    """
    position, quaternion = (
        np.array(robot.config.p_base_imu, dtype=float),
        np.array(robot.config.quat_base_imu, dtype=float),
    )
    site, why = _find_site(model, tree)
    if site is None:
        return ImuMount(position, quaternion, f"mount of the TOML of '{robot.name}', no site found")
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    rotation = data.xmat[tree.base].reshape(3, 3)
    position = rotation.T @ (data.site_xpos[site] - data.xpos[tree.base])
    found = np.zeros(4)
    mujoco.mju_mat2Quat(found, (rotation.T @ data.site_xmat[site].reshape(3, 3)).ravel())
    source = f"site '{model.site(site).name}' {why}"
    angle = 2.0 * math.acos(min(1.0, abs(float(found @ quaternion))))
    if angle > _MAX_MOUNT_ERROR:
        degrees = math.degrees(angle)
        return ImuMount(
            position, quaternion, f"{source}; its axes, {degrees:.0f} deg apart, are not used"
        )
    return ImuMount(position, found, source)


def _find_site(model: mujoco.MjModel, tree: Tree) -> tuple[int | None, str]:
    """Return a site that is fixed to the base, and how it was found."""
    sites = [s for s in range(model.nsite) if model.body_weldid[model.site_bodyid[s]] == tree.base]
    for site in sites:
        if re.search("imu", model.site(site).name, re.IGNORECASE):
            return site, "by its name"
    gyro = mujoco.mjtSensor.mjSENS_GYRO
    for sensor in range(model.nsensor):
        if model.sensor_type[sensor] == gyro and model.sensor_objid[sensor] in sites:
            return int(model.sensor_objid[sensor]), "of the file's gyroscope"
    return None, ""
