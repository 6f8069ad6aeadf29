# SPDX-License-Identifier: BSD-3-Clause
"""surefoot.symbolic, compared with Pinocchio."""

from __future__ import annotations

import builtins

import numpy as np
import pinocchio as pin
import pytest
import surefoot
from surefoot import symbolic


class Motion:
    def __init__(self, body, seed=5) -> None:
        state = body.random_state(seed, speed=1.0)
        rng = np.random.default_rng(seed)
        self.q, self.v = state.q, state.v
        self.a, self.tau = rng.normal(size=(2, body.robot.nv))


@pytest.fixture
def motion(body):
    return Motion(body)


def assert_same(symbolic_value, expected):
    expected = np.asarray(expected)
    value = np.asarray(symbolic_value).reshape(expected.shape)
    scale = max(1.0, float(np.abs(expected).max()))
    np.testing.assert_allclose(value, expected, atol=1e-10 * scale, rtol=0.0)


def test_symbolic_mass_matrix_and_bias_match_pinocchio(body, motion):
    M = pin.crba(body.model, body.data, motion.q)
    assert_same(symbolic.mass_matrix(body.robot)(motion.q), np.triu(M) + np.triu(M, 1).T)
    h = pin.nonLinearEffects(body.model, body.data, motion.q, motion.v)
    assert_same(symbolic.bias(body.robot)(motion.q, motion.v), h)


def test_inverse_and_forward_dynamics_match_pinocchio(body, motion):
    q, v = motion.q, motion.v
    tau = pin.rnea(body.model, body.data, q, v, motion.a)
    assert_same(symbolic.inverse_dynamics(body.robot)(q, v, motion.a), tau)
    a = pin.aba(body.model, body.data, q, v, motion.tau)
    assert_same(symbolic.forward_dynamics(body.robot)(q, v, motion.tau), a)


def test_foot_functions_match_pinocchio(body, motion):
    model, data, axes = body.model, body.data, pin.LOCAL_WORLD_ALIGNED
    pin.forwardKinematics(model, data, motion.q, motion.v, np.zeros(model.nv))
    pin.computeJointJacobians(model, data, motion.q)
    pin.updateFramePlacements(model, data)
    feet = body.robot.foot_frame_ids
    p = np.column_stack([data.oMf[i].translation for i in feet])
    J = np.vstack([pin.getFrameJacobian(model, data, i, axes)[:3] for i in feet])
    drifts = [pin.getFrameClassicalAcceleration(model, data, i, axes).linear for i in feet]
    assert_same(symbolic.foot_positions(body.robot)(motion.q), p)
    assert_same(symbolic.foot_jacobian(body.robot)(motion.q), J)
    assert_same(symbolic.foot_drifts(body.robot)(motion.q, motion.v), np.column_stack(drifts))


def test_centroidal_functions_match_pinocchio(body, motion):
    pin.ccrba(body.model, body.data, motion.q, motion.v)
    assert_same(symbolic.centroidal_matrix(body.robot)(motion.q), body.data.Ag)
    momentum = symbolic.centroidal_momentum(body.robot)(motion.q, motion.v)
    assert_same(momentum, body.data.hg.vector)
    com = pin.centerOfMass(body.model, body.data, motion.q)
    assert_same(symbolic.center_of_mass(body.robot)(motion.q), com)


def test_derivatives_match_pinocchio(body, motion):
    q, v = motion.q, motion.v
    found = symbolic.inverse_dynamics_derivatives(body.robot)(q, v, motion.a)
    expected = pin.computeRNEADerivatives(body.model, body.data, q, v, motion.a)
    for value, matrix in zip(found, expected, strict=True):
        assert_same(value, matrix)
    found = symbolic.forward_dynamics_derivatives(body.robot)(q, v, motion.tau)
    expected = pin.computeABADerivatives(body.model, body.data, q, v, motion.tau)
    for value, matrix in zip(found, expected, strict=True):
        assert_same(value, np.array(matrix))


# Joints that no robot of ours has: a wheel, whose coordinates are cosine and sine, a lift on a
# tilted axis, and a wheel on this lift.
@pytest.fixture
def robot_with_lift(go1):
    model = pin.Model()
    model.loadFromString(go1.robot.serialized_model())
    rng = np.random.default_rng(3)
    pin.seed(3)
    placement = pin.SE3(pin.exp3(np.array([0.3, 0.5, -0.2])), np.array([0.05, -0.02, 0.1]))
    lift = pin.JointModelPrismaticUnaligned(np.array([0.6, 0.0, 0.8]))
    parent = 1
    for name, joint in (
        ("wheel", pin.JointModelRUBZ()),
        ("lift", lift),
        ("top", pin.JointModelRUBX()),
    ):
        parent = model.addJoint(1 if name == "lift" else parent, joint, pin.SE3.Random(), name)
        model.appendBodyToJoint(parent, pin.Inertia.FromBox(0.4, 0.1, 0.2, 0.1), placement)
        model.armature[model.idx_vs[parent]] = rng.uniform()
    config = go1.robot.config
    return type(go1)(surefoot.Robot.from_serialized_model(model.saveToString(), config))


def test_wheels_and_prismatic_joints_match_pinocchio(robot_with_lift):
    body = robot_with_lift
    motion = Motion(body)
    q, v = motion.q, motion.v
    assert q.size == 19 + 5 and v.size == 18 + 3
    tau = pin.rnea(body.model, body.data, q, v, motion.a)
    assert_same(symbolic.inverse_dynamics(body.robot)(q, v, motion.a), tau)
    a = pin.aba(body.model, body.data, q, v, motion.tau)
    assert_same(symbolic.forward_dynamics(body.robot)(q, v, motion.tau), a)
    pin.ccrba(body.model, body.data, q, v)
    assert_same(symbolic.centroidal_matrix(body.robot)(q), body.data.Ag)
    found = symbolic.inverse_dynamics_derivatives(body.robot)(q, v, motion.a)
    expected = pin.computeRNEADerivatives(body.model, body.data, q, v, motion.a)
    for value, matrix in zip(found, expected, strict=True):
        assert_same(value, matrix)


def test_functions_accept_casadi_symbols(go1):
    import casadi

    q = casadi.MX.sym("q", go1.robot.nq)
    height = symbolic.center_of_mass(go1.robot)(q)[2]
    slope = casadi.Function("slope", [q], [casadi.jacobian(height, q)])
    assert float(slope(go1.robot.q_standing())[2]) == pytest.approx(1.0)


def test_without_casadi_the_error_names_the_extra(go1, monkeypatch):
    real = builtins.__import__

    def without_casadi(name, *args, **kwargs):
        if name == "casadi":
            raise ImportError(name)
        return real(name, *args, **kwargs)

    monkeypatch.setattr(builtins, "__import__", without_casadi)
    with pytest.raises(surefoot.Error, match=r"pip install surefoot\[tune\]"):
        symbolic.bias(go1.robot)


# The controller's torques in random states must satisfy the equations of motion.
def test_torques_of_random_states_match_pinocchio_inverse_dynamics(body):
    controller = surefoot.WholeBodyController(body.robot)
    usable = 0
    for seed in range(20):
        state = body.random_state(seed, speed=0.5)
        state.contact = np.ones(4)
        solution = controller.update(state, body.reference_at(state))
        if solution.status not in (surefoot.Status.OK, surefoot.Status.SATURATED):
            continue
        usable += 1
        J = body.contact_jacobian(state.q)
        tau = pin.rnea(body.model, body.data, state.q, state.v, solution.accelerations)
        tau -= J.T @ np.asarray(solution.forces).T.ravel()
        scale = np.abs(tau).max()
        np.testing.assert_allclose(tau[:6], 0.0, atol=1e-7 * max(body.weight, scale))
        np.testing.assert_allclose(solution.torques, tau[6:], atol=1e-9 * body.weight)
    assert usable >= 10
