"""Pinned standing pose: the pose in which all push limits of a robot are computed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from surefoot._core import Robot
from surefoot.geometry.rotations import Array
from surefoot.sim.lip_push_limit import distance_to_edge

UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class StanceModel:
    """A robot in its standing pose on level ground: base level, joint angles of its TOML.

    All positions are in a frame with its origin on the ground (z = 0) below the base, x forward,
    y left and z up. The feet are in leg order.

    Attributes:
        mass: Mass m [kg].
        com: (3,) centre of mass [m].
        contacts: (4, 3) contact points of the feet [m].
        jacobians: (4, 3, 12) Jacobian of each foot. It maps the motor velocities to the velocity of
            the foot's contact point.
        gravity_torque: (12,) motor torques that hold only the weight of the legs [N.m].
        torque_limit: (12,) motor torque limits at rest [N.m].
    """

    mass: float
    com: Array
    contacts: Array
    jacobians: Array
    gravity_torque: Array
    torque_limit: Array

    @property
    def height(self) -> float:
        """Height of the centre of mass above the ground [m]."""
        return float(self.com[2])

    def edge_distance(self, direction_deg: float) -> float:
        """Return the horizontal distance from the centre of mass to the support edge [m].

        Args:
            direction_deg: Direction of the distance, from forward towards left [deg].
        """
        return distance_to_edge(
            self.contacts[:, :2], self.com[:2], direction_vector(direction_deg)[:2]
        )


def direction_vector(direction_deg: float) -> Array:
    """Return the horizontal unit vector (3,) at an angle from forward towards left [deg]."""
    angle = math.radians(direction_deg)
    return np.array([math.cos(angle), math.sin(angle), 0.0])


def stance_model(robot: Robot) -> StanceModel:
    """Compute the stance model of a robot in its pinned standing pose."""
    import pinocchio

    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    data: Any = model.createData()
    q = robot.q_standing()
    pinocchio.computeJointJacobians(model, data, q)
    pinocchio.updateFramePlacements(model, data)
    com = pinocchio.centerOfMass(model, data, q)
    radius, motors = robot.config.foot_radius, np.array(robot.motor_to_v)
    contacts, jacobians = np.zeros((4, 3)), np.zeros((4, 3, 12))
    for leg, frame in enumerate(robot.foot_frame_ids):
        contacts[leg] = data.oMf[frame].translation - radius * UP
        J = pinocchio.getFrameJacobian(
            model, data, frame, pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
        )
        roll = pinocchio.skew(radius * UP)
        jacobians[leg] = (J[:3] + roll @ J[3:])[:, motors]
    ground = float(contacts[:, 2].min())
    torque = pinocchio.computeGeneralizedGravity(model, data, q)[motors]
    return StanceModel(
        float(robot.mass),
        com - ground * UP,
        contacts - ground * UP,
        jacobians,
        torque,
        np.array(robot.config.tau_max),
    )
