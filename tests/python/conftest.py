# SPDX-License-Identifier: BSD-3-Clause
"""Robots with their Pinocchio models, for tests that compare Surefoot with Pinocchio."""

from __future__ import annotations

import functools

import numpy as np
import pinocchio as pin
import pytest
import surefoot

ROBOTS = ["a1", "go1", "go2", "b1"]
UP = np.array([0.0, 0.0, 1.0])
LEVEL = np.eye(3)


class Body:
    def __init__(self, robot: surefoot.Robot) -> None:
        self.robot = robot
        self.model = pin.Model()
        self.model.loadFromString(robot.serialized_model())
        self.data = self.model.createData()
        self.weight = robot.mass * 9.81  # [N]

    def with_config(self, **changes) -> Body:
        """Return the same robot with some fields of its configuration replaced."""
        config = self.robot.config
        for field, value in changes.items():
            setattr(config, field, value)
        text = self.robot.serialized_model()
        return Body(surefoot.Robot.from_serialized_model(text, config))

    def random_state(self, seed: int, speed: float = 0.3) -> surefoot.RobotState:
        """Return a random moving state near the standing pose, with the base at 0.3 m."""
        rng = np.random.default_rng(seed)
        state = surefoot.RobotState(self.robot.nq, self.robot.nv)
        q = self.robot.q_standing()
        q[2] = 0.3
        state.q = pin.integrate(self.model, q, 0.15 * rng.uniform(-1, 1, self.robot.nv))
        state.v = speed * rng.uniform(-1, 1, self.robot.nv)
        return state

    def reference_at(self, state: surefoot.RobotState, normal=UP) -> surefoot.Reference:
        """Return a reference that equals the state, except that its feet are at rest."""
        reference = surefoot.Reference()
        reference.p_com = pin.centerOfMass(self.model, self.data, state.q, state.v)
        reference.v_com = self.data.vcom[0]
        reference.quat_world_base = state.q[3:7]
        reference.w_world_base = rotation(state.q) @ state.v[3:6]
        reference.ground_normal = normal
        for leg, point in enumerate(self.contact_points(state.q, normal)):
            reference.foot(leg).p_world = point
        return reference

    def contact_points(self, q, normal=UP):
        """Return the contact points of the feet, (4, 3), world frame [m]."""
        pin.framesForwardKinematics(self.model, self.data, q)
        centres = [self.data.oMf[i].translation for i in self.robot.foot_frame_ids]
        return np.array(centres) - self.robot.config.foot_radius * normal

    def contact_jacobian(self, q, normal=UP):
        """Return the Jacobian (12, nv) of the rolling feet's contact points, world axes."""
        pin.computeJointJacobians(self.model, self.data, q)
        pin.updateFramePlacements(self.model, self.data)
        roll = pin.skew(self.robot.config.foot_radius * normal)
        rows = []
        for i in self.robot.foot_frame_ids:
            J = pin.getFrameJacobian(self.model, self.data, i, pin.LOCAL_WORLD_ALIGNED)
            rows.append(J[:3] + roll @ J[3:])
        return np.vstack(rows)

    def resting_sample(self, tick: int, R_world_base=LEVEL, loads=(0.25,) * 4):
        """Return the LowState of a robot at rest in its standing pose.

        Args:
            tick: Robot clock [ms].
            R_world_base: Attitude of the base.
            loads: Load of each foot as a share of the weight, FR FL RR RL.
        """
        config, q = self.robot.config, self.robot.q_standing()
        q[3:7] = pin.Quaternion(R_world_base).coeffs()
        forces = np.outer(loads, self.weight * UP).ravel()
        tau = pin.computeGeneralizedGravity(self.model, self.data, q)
        tau = tau - self.contact_jacobian(q).T @ forces
        report = surefoot.LowState()
        report.tick = tick % 2**32
        R_base_imu = pin.Quaternion(*config.quat_base_imu).toRotationMatrix()
        R_world_imu = R_world_base @ R_base_imu
        report.imu.quaternion[:] = np.roll(pin.Quaternion(R_world_imu).coeffs(), 1)
        report.imu.accelerometer[:] = 9.81 * R_world_imu[2]
        for i, motor in enumerate(report.motorState[k] for k in range(12)):
            motor.mode, motor.q = 0x0A, config.q_standing[i]
            motor.tauEst = tau[self.robot.motor_to_v[i]]
        return report


def rotation(q):
    """Return R_world_base of Pinocchio's q."""
    return pin.Quaternion(*np.roll(q[3:7], 1)).toRotationMatrix()


@functools.cache
def body_of(name: str) -> Body:
    return Body(surefoot.load_robot(name))


@pytest.fixture(params=ROBOTS)
def body(request) -> Body:
    return body_of(request.param)


@pytest.fixture
def go1() -> Body:
    return body_of("go1")
