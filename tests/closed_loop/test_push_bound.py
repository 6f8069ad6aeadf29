# SPDX-License-Identifier: BSD-3-Clause
"""benchmarks/push_bound.py: its model, compared with Pinocchio, and one bound."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

pytest.importorskip("casadi")
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from plant_helpers import ROBOTS
from push_bound import (
    Case,
    PushOcp,
    contact_jacobian,
    dynamics_residual,
    integrator,
    standing_forces,
)
from surefoot import Robot, load_robot
from surefoot.assess.push_limits import push_limit
from surefoot.assess.stance_model import stance_model

pytestmark = pytest.mark.slow


def random_pose(robot: Robot, model: pin.Model) -> np.ndarray:
    """Return a random q around the standing pose, with another attitude."""
    step = 0.3 * np.random.default_rng(1).normal(size=robot.nv)
    return pin.integrate(model, np.array(robot.q_standing()), step)


def model_of(robot: Robot) -> pin.Model:
    """Return the robot's Pinocchio model."""
    model = pin.Model()
    model.loadFromString(robot.serialized_model())
    return model


@pytest.mark.parametrize("name", ROBOTS)
def test_contact_jacobian_includes_foot_rolling(name: str) -> None:
    robot = load_robot(name)
    model = model_of(robot)
    data = model.createData()
    q = random_pose(robot, model)
    J = contact_jacobian(robot)(q).full()
    below = pin.skew(np.array([0.0, 0.0, robot.config.foot_radius]))
    for leg, frame in enumerate(robot.foot_frame_ids):
        centre = pin.computeFrameJacobian(model, data, q, frame, pin.LOCAL_WORLD_ALIGNED)
        expected = centre[:3] + below @ centre[3:]
        np.testing.assert_allclose(J[3 * leg : 3 * leg + 3], expected, atol=1e-10)


@pytest.mark.parametrize("name", ROBOTS)
def test_standing_forces_and_torques_balance_the_pose(name: str) -> None:
    robot = load_robot(name)
    contact = contact_jacobian(robot)
    f, tau = standing_forces(robot, contact)
    rest = np.zeros(18)
    residual = dynamics_residual(robot, contact, 30.0)(
        robot.q_standing(), rest, rest, tau, f, 0.0
    ).full()
    assert np.abs(residual).max() < 1e-9
    pushed = dynamics_residual(robot, contact, 90.0)(robot.q_standing(), rest, rest, tau, f, 50.0)
    np.testing.assert_allclose(pushed.full().ravel()[:3], [0.0, -5.0, 0.0], atol=1e-9)


def test_integration_step_matches_pinocchio() -> None:
    robot = load_robot("go1")
    model = model_of(robot)
    v = np.random.default_rng(2).normal(size=robot.nv)
    q = random_pose(robot, model)
    moved = integrator(robot)(q, v).full().ravel()
    np.testing.assert_allclose(moved, pin.integrate(model, q, 0.01 * v), atol=2e-4)


def test_a1_push_bound_is_1_to_1_25_times_its_push_limit() -> None:
    robot = load_robot("a1")
    own = push_limit(stance_model(robot), 0.0, 0.1, 0.0, 0.8).limit
    ocp = PushOcp(Case(0.0, 5.0, 0.8), robot)
    impulse, status = ocp.largest_impulse(0.7 * own)
    assert status == "Solve_Succeeded"
    assert own < impulse < 1.25 * own
    q, f = (np.array(ocp.opti.value(x)) for x in (ocp.q, ocp.f))
    assert np.degrees(2.0 * np.arcsin(np.hypot(q[3], q[4]))).max() < 5.01
    x, y, z = f.reshape(4, 3, -1).transpose(1, 0, 2)
    assert np.all(np.hypot(x, y) <= 0.8 * z + 1e-3)
