"""The pinned standing pose: the one pose that every limit of a robot is computed at."""

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
    """A robot in its standing pose on level ground: joints as its TOML says, base level.

    Origin below the base's, x forward, y left, z up, ground at z = 0. Feet run FR FL RR RL.

    Attributes:
        mass: m [kg].
        com: (3,) centre of mass [m].
        contacts: (4, 3) where the feet touch the ground [m].
        jacobians: (4, 3, 12) velocity of each contact point from the motors', the foot rolling.
        gravity_torque: (12,) that hold the legs themselves up, were the feet in the air [N.m].
        torque_limit: (12,) of the motors at rest [N.m].
    """

    mass: float
    com: Array
    contacts: Array
    jacobians: Array
    gravity_torque: Array
    torque_limit: Array

    @property
    def height(self) -> float:
        """Of the centre of mass above the ground [m]."""
        return float(self.com[2])

    def edge_distance(self, direction_deg: float) -> float:
        """Return how far the edge of the feet is from below the centre of mass [m].

        Args:
            direction_deg: In this direction, from forward towards left [deg].
        """
        return distance_to_edge(
            self.contacts[:, :2], self.com[:2], direction_vector(direction_deg)[:2]
        )


def direction_vector(direction_deg: float) -> Array:
    """Return the horizontal unit vector (3,) at an angle from forward towards left [deg]."""
    angle = math.radians(direction_deg)
    return np.array([math.cos(angle), math.sin(angle), 0.0])


def stance_model(robot: Robot) -> StanceModel:
    """Return a robot's pinned standing pose."""
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
