"""Computation of the directions of a standing robot, from its model and its controller's QP."""

from __future__ import annotations

import math

import numpy as np

from surefoot import symbolic
from surefoot._core import Error, Gains, Robot
from surefoot.robot.loading import RobotDescription, build_robot, per_motor
from surefoot.tune.design.directions import DIRECTION_NAMES, Array, Direction, StandingBody
from surefoot.tune.design.qp_limits import GRAVITY, qp_limits
from surefoot.tune.design.ranges import check_range

# Range of the factor on the joint friction. Chosen: from no friction to far more than a worn gear.
FRICTION_SCALE_RANGE = (0.0, 10.0)
# Impulse of the push as a share of the LIP push limit. Chosen: joint friction hides the motion of a
# weaker push, and a stronger push saturates the torques.
_PUSH_SHARE = 0.5


def compute_standing_body(
    description: RobotDescription,
    joint_friction_scale: float = 1.0,
    gains: Gains | None = None,
) -> StandingBody:
    """Compute the directions of a standing robot.

    Args:
        description: The robot's files. The section ``simulation`` of the TOML has the joint
            friction; without it the friction is zero.
        joint_friction_scale: Factor on dry and viscous friction of the joints.
        gains: Gains of the QP: hold_down, weights, penalties, force limits. None: the robot's own
            gains.

    Raises:
        Error: The scale is out of its range; the robot cannot be built or does not have twelve
            joints; CasADi is missing.
    """
    check_range("joint_friction_scale", joint_friction_scale, *FRICTION_SCALE_RANGE)
    robot = build_robot(description)
    if robot.nv != 18:
        raise Error(
            f"robot '{robot.name}': got {robot.nv - 6} joints, expected twelve, as for a "
            "StandController"
        )
    motions = _body_motions(robot)
    joints = np.array(robot.motor_to_v)
    q = robot.q_standing()
    inertia = motions.T @ np.asarray(symbolic.mass_matrix(robot)(q)) @ motions
    friction, viscous = (
        joint_friction_scale * np.array(_joint_table(description, name))
        for name in ("joint_friction", "joint_damping")
    )
    height, reach = _height_and_reach(robot)
    speed = _PUSH_SHARE * math.sqrt(GRAVITY / height) * reach
    qp_response = qp_limits(robot, height, gains or robot.config.gains)
    directions = {}
    for k, name in enumerate(DIRECTION_NAMES):
        dq = motions[joints, k]
        decelerations = [
            float(np.linalg.solve(inertia, motions[joints].T @ torque)[k])
            for torque in (friction * np.sign(dq), viscous * dq)
        ]
        rotates = k >= 3
        base_ratio = 1.0 if rotates else float(motions[k, k])
        directions[name] = Direction(
            name=name,
            rotates=rotates,
            inertia=float(inertia[k, k]),
            # Dry friction hardly slows motion along y: the hip joints stick, and the body rolls.
            friction=0.0 if name == "y" else decelerations[0],
            viscous=decelerations[1],
            base_motion_ratio=base_ratio,
            external_acceleration_ratio=1.0
            if rotates
            else base_ratio * robot.mass / float(inertia[k, k]),
            limits=qp_response[k],
            push_velocity=speed / height if rotates else speed,
        )
    return StandingBody(robot, height, directions)


def _body_motions(robot: Robot) -> Array:
    """Return the matrix (nv, 6) that maps task velocities (v_com, w) to v, with fixed feet.

    v_com is the velocity of the centre of mass, w the angular velocity of the base. Fixed feet
    mean J_b v_b + J_l v_l = 0, where J_b and J_l are the columns of the foot Jacobian for the base
    and for the legs. The base velocity v_b gives (v_com, w) = T v_b.
    """
    q = robot.q_standing()
    jacobian = np.asarray(symbolic.foot_jacobian(robot)(q))
    legs = -np.linalg.solve(jacobian[:, 6:], jacobian[:, :6])
    motion = np.vstack([np.eye(6), legs])
    momentum = np.asarray(symbolic.centroidal_matrix(robot)(q)) @ motion
    tasks = np.vstack([momentum[:3] / robot.mass, np.eye(6)[3:]])
    return np.asarray(motion @ np.linalg.inv(tasks))


def _joint_table(description: RobotDescription, name: str) -> list[float]:
    table = description.table.get("simulation", {})
    if name not in table:
        return [0.0] * 12
    return list(per_motor(table[name], f"simulation.{name}"))


def _height_and_reach(robot: Robot) -> tuple[float, float]:
    """Return the height of the centre of mass and its distance to the nearest support edge [m]."""
    q = robot.q_standing()
    com = np.asarray(symbolic.center_of_mass(robot)(q)).ravel()
    feet = np.asarray(symbolic.foot_positions(robot)(q)) - com[:, None]
    height = robot.config.foot_radius - float(feet[2].mean())
    reach = min(float(np.abs(feet[0]).mean()), float(np.abs(feet[1]).mean()))
    return height, reach
