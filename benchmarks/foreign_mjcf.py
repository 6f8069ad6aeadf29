# SPDX-License-Identifier: BSD-3-Clause
"""Writes MJCF files of robots that differ from ours, as other people's models do."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import mujoco
import numpy as np
from surefoot.robot.loading import build_robot, describe_robot
from surefoot.sim import PlantSettings
from surefoot.sim.model.urdf_scene import urdf_scene

Change = Callable[[mujoco.MjSpec], None]
FEET = ("FR_foot", "FL_foot", "RR_foot", "RL_foot")
SOFT_SOLIMP = [0.015, 1.0, 0.031, 0.5, 2.0]  # feet of MuJoCo Menagerie's quadrupeds
IMU_POSITION = [0.06, 0.03, 0.05]  # [m] of the moved site
POSE = {"thigh": 0.6, "calf": -1.2}  # [rad] angles of our convention in the changed initial pose


def write_mjcf(path: Path, *changes: Change, robot: str = "go1") -> Path:
    """Write our model of a robot with changes, twelve motors and an IMU site, and return the path.

    The feet keep their spheres, and the ground is a plane.
    """
    description = describe_robot(robot)
    model = build_robot(description)
    spec = urdf_scene(model, description, PlantSettings())
    base = next(body for body in spec.worldbody.bodies if body.joints)
    base.add_site(name="imu", pos=model.config.p_base_imu)
    for name in model.config.joint_names:
        spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    for change in changes:
        change(spec)
    spec.compile()
    path.write_text(spec.to_xml(), encoding="utf-8")
    return path


def friction(coefficient: float) -> Change:
    """Set the sliding friction of the feet."""

    def change(spec: mujoco.MjSpec) -> None:
        for name in FEET:
            spec.geom(name).friction = [coefficient, 0.005, 0.0001]

    return change


def soft_contact(spec: mujoco.MjSpec) -> None:
    """Give the feet the contact stiffness of MuJoCo Menagerie's quadrupeds."""
    for name in FEET:
        spec.geom(name).solref, spec.geom(name).solimp = [0.02, 1.0], SOFT_SOLIMP


def damping(value: float) -> Change:
    """Set the joint damping [N.m.s/rad]."""

    def change(spec: mujoco.MjSpec) -> None:
        for joint in hinges(spec):
            joint.damping = [value, 0.0, 0.0]

    return change


def mass(scale: float) -> Change:
    """Scale masses and inertias of all bodies."""

    def change(spec: mujoco.MjSpec) -> None:
        for body in spec.bodies[1:]:
            body.mass *= scale
            body.fullinertia, body.inertia = body.fullinertia * scale, body.inertia * scale

    return change


def foot_radius(scale: float) -> Change:
    """Scale the radius of the feet."""

    def change(spec: mujoco.MjSpec) -> None:
        for name in FEET:
            spec.geom(name).size = scale * np.array(spec.geom(name).size)

    return change


def imu_elsewhere(spec: mujoco.MjSpec) -> None:
    """Move the IMU site to IMU_POSITION."""
    spec.site("imu").pos = IMU_POSITION


def bent_pose(spec: mujoco.MjSpec) -> None:
    """Bend the legs in the initial pose, in which all joint angles of the file are zero."""
    for joint in hinges(spec):
        for part, angle in POSE.items():
            if part in joint.name:
                w, y = math.cos(angle / 2), math.sin(angle / 2)
                joint.parent.quat = [w, 0.0, y, 0.0]
                joint.range = np.array(joint.range) - angle


def other_axes(spec: mujoco.MjSpec) -> None:
    """Turn the axes of the calves around."""
    for joint in hinges(spec):
        if "calf" in joint.name:
            joint.axis = -np.array(joint.axis)
            joint.range = -np.array(joint.range)[::-1]


def hinges(spec: mujoco.MjSpec) -> list[mujoco.MjsJoint]:
    """Return all hinge joints."""
    return [joint for joint in spec.joints if joint.type == mujoco.mjtJoint.mjJNT_HINGE]


VARIANTS: dict[str, tuple[Change, ...]] = {
    "ours": (),
    "friction 0.4": (friction(0.4),),
    "soft contact": (soft_contact,),
    "damping 2": (damping(2.0),),
    "mass +10 %": (mass(1.1),),
    "mass -10 %": (mass(0.9),),
    "foot radius +10 %": (foot_radius(1.1),),
    "foot radius -10 %": (foot_radius(0.9),),
    "IMU elsewhere": (imu_elsewhere,),
    "other initial pose": (bent_pose,),
    "other axes": (other_axes,),
}
"""Changes of our model, by name."""
