# SPDX-License-Identifier: BSD-3-Clause
"""benchmarks/push_bound.py: its model against the scorecard's own, and one bound."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

pytest.importorskip("casadi")
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from plant_helpers import ROBOTS
from push_bound import Case, Program, contact_jacobian, dynamics, integration, standing
from surefoot import Robot, load_robot
from surefoot.assess.pinned import pin as pin_down
from surefoot.assess.push_limits import push_limit


def random_pose(robot: Robot, model: pin.Model) -> np.ndarray:
    """Return q some way from the standing pose, turned any way."""
    step = 0.3 * np.random.default_rng(1).normal(size=robot.nv)
    return pin.integrate(model, np.array(robot.q_standing()), step)


def model_of(robot: Robot) -> pin.Model:
    """Return Pinocchio's model."""
    model = pin.Model()
    model.loadFromString(robot.serialized_model())
    return model


@pytest.mark.parametrize("name", ROBOTS)
def test_contact_points_roll_under_their_feet(name: str) -> None:
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
def test_what_holds_the_standing_pose_holds_it(name: str) -> None:
    robot = load_robot(name)
    contact = contact_jacobian(robot)
    f, tau = standing(robot, contact)
    rest = np.zeros(18)
    residual = dynamics(robot, contact, 30.0)(robot.q_standing(), rest, rest, tau, f, 0.0).full()
    assert np.abs(residual).max() < 1e-9
    pushed = dynamics(robot, contact, 90.0)(robot.q_standing(), rest, rest, tau, f, 50.0)
    np.testing.assert_allclose(pushed.full().ravel()[:3], [0.0, -5.0, 0.0], atol=1e-9)


def test_a_knot_moves_q_as_the_library_does() -> None:
    robot = load_robot("go1")
    model = model_of(robot)
    v = np.random.default_rng(2).normal(size=robot.nv)
    q = random_pose(robot, model)
    moved = integration(robot)(q, v).full().ravel()
    np.testing.assert_allclose(moved, pin.integrate(model, q, 0.01 * v), atol=2e-4)


def test_a1_survives_more_than_its_own_limit_forward() -> None:
    robot = load_robot("a1")
    own = push_limit(pin_down(robot), 0.0, 0.1, 0.0, 0.8).own
    program = Program(Case(0.0, 5.0, 0.8), robot)
    impulse, said = program.largest(0.7 * own)
    assert said == "Solve_Succeeded"
    assert own < impulse < 1.25 * own
    q, f = (np.array(program.opti.value(x)) for x in (program.q, program.f))
    assert np.degrees(2.0 * np.arcsin(np.hypot(q[3], q[4]))).max() < 5.01
    x, y, z = f.reshape(4, 3, -1).transpose(1, 0, 2)
    assert np.all(np.hypot(x, y) <= 0.8 * z + 1e-3)
