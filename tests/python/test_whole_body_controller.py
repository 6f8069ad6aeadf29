# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import math

import numpy as np
import pinocchio as pin
import pytest
import surefoot
from surefoot import Status, WholeBodyController

SEEDS = range(12)
UP = np.array([0.0, 0.0, 1.0])
SLOPE = np.array([0.15, -0.1, math.sqrt(1 - 0.15**2 - 0.1**2)])


def rotation(q):
    return pin.Quaternion(*np.roll(q[3:7], 1)).toRotationMatrix()


def state_and_reference(body, seed: int, normal=UP, swing=()):
    """Return a random state and a reference with small errors in every task."""
    rng = np.random.default_rng(1000 + seed)
    state = body.random_state(seed)
    reference = body.reference_at(state, normal)
    reference.p_com = reference.p_com + 0.005 * rng.uniform(-1, 1, 3)
    reference.v_com = reference.v_com + 0.02 * rng.uniform(-1, 1, 3)
    reference.a_com = 0.3 * rng.uniform(-1, 1, 3)
    turn = pin.exp3(0.01 * rng.uniform(-1, 1, 3)) @ rotation(state.q)
    reference.quat_world_base = pin.Quaternion(turn).coeffs()
    reference.w_world_base = reference.w_world_base + 0.02 * rng.uniform(-1, 1, 3)
    reference.alpha_world_base = rng.uniform(-1, 1, 3)
    for leg in range(4):
        foot = reference.foot(leg)
        foot.p_world = foot.p_world + 0.005 * rng.uniform(-1, 1, 3)
        foot.v_world, foot.a_world = 0.2 * rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3)
        foot.stance = leg not in swing
    return state, reference


def com_acceleration(body, state, a):
    pin.centerOfMass(body.model, body.data, state.q, state.v, a)
    return body.data.acom[0].copy()


def feet_acceleration(body, state, a, normal):
    """Return the accelerations of the rolling feet's contact points, (4, 3), world axes."""
    pin.forwardKinematics(body.model, body.data, state.q, state.v, a)
    roll = body.robot.config.foot_radius * normal
    rows = []
    for i in body.robot.foot_frame_ids:
        frame = (body.model, body.data, i, pin.LOCAL_WORLD_ALIGNED)
        turning = pin.getFrameAcceleration(*frame).angular
        rows.append(pin.getFrameClassicalAcceleration(*frame).linear + np.cross(roll, turning))
    return np.array(rows)


def authority(body, state, normal=UP):
    """Return the map (6, 12) from foot forces to CoM and angular base accelerations."""
    nv = body.robot.nv
    M = pin.crba(body.model, body.data, state.q)
    M = np.triu(M) + np.triu(M, 1).T
    J = body.contact_jacobian(state.q, normal)
    actuation = np.vstack([np.zeros((6, nv - 6)), np.eye(nv - 6)])
    system = np.block([[M, -actuation], [J, np.zeros((12, nv - 6))]])
    a = np.linalg.solve(system, np.vstack([J.T, np.zeros((12, 12))]))[:nv]
    return np.vstack([np.tile(np.eye(3) / body.robot.mass, 4), rotation(state.q) @ a[3:6]])


@pytest.mark.parametrize("normal", [UP, SLOPE], ids=["flat", "slope"])
def test_rigid_body_dynamics_hold_exactly(body, normal) -> None:
    controller = WholeBodyController(body.robot)
    for seed in SEEDS:
        state, reference = state_and_reference(body, seed, normal, swing=[seed % 8])
        solution = controller.update(state, reference)
        assert solution.status == Status.OK
        J = body.contact_jacobian(state.q, normal)
        effort = pin.rnea(body.model, body.data, state.q, state.v, solution.accelerations)
        effort -= J.T @ solution.forces.T.ravel()
        np.testing.assert_allclose(effort[:6], 0.0, atol=1e-8)
        np.testing.assert_allclose(effort[6:], solution.torques, atol=1e-8)


@pytest.mark.parametrize("normal", [UP, SLOPE], ids=["flat", "slope"])
def test_foot_accelerations_match_their_gains(body, normal) -> None:
    controller = WholeBodyController(body.robot)
    gains = controller.gains
    for seed in SEEDS:
        state, reference = state_and_reference(body, seed, normal, swing=[seed % 8])
        solution = controller.update(state, reference)
        feet = [reference.foot(leg) for leg in range(4)]
        p = body.contact_points(state.q, normal)
        v = (body.contact_jacobian(state.q, normal) @ state.v).reshape(4, 3)
        wanted = np.array([foot.a_world for foot in feet])
        wanted += gains.foot_kp * (np.array([foot.p_world for foot in feet]) - p)
        wanted += gains.foot_kd * (np.array([foot.v_world for foot in feet]) - v)
        happens = feet_acceleration(body, state, solution.accelerations, normal)
        np.testing.assert_allclose(happens, wanted, atol=1e-8)


def test_contact_velocities_change_by_the_foot_accelerations(body) -> None:
    state, reference = state_and_reference(body, seed=3)
    a = WholeBodyController(body.robot).update(state, reference).accelerations
    step, velocities = 1e-5, []
    for dt in (-step, step):
        q = pin.integrate(body.model, state.q, dt * state.v + 0.5 * dt * dt * a)
        velocities.append(body.contact_jacobian(q) @ (state.v + dt * a))
    measured = (velocities[1] - velocities[0]) / (2 * step)
    happens = feet_acceleration(body, state, a, UP).ravel()
    np.testing.assert_allclose(measured, happens, atol=1e-5)


def test_com_acceleration_matches_its_gains(body) -> None:
    controller = WholeBodyController(body.robot)
    g = controller.gains
    kp = np.array([g.com_kp_horizontal, g.com_kp_horizontal, g.com_kp_vertical])
    kd = np.array([g.com_kd_horizontal, g.com_kd_horizontal, g.com_kd_vertical])
    for seed in SEEDS:
        state, reference = state_and_reference(body, seed)
        solution = controller.update(state, reference)
        happens = com_acceleration(body, state, solution.accelerations)
        wanted = reference.a_com + kp * (reference.p_com - body.data.com[0])
        wanted += kd * (reference.v_com - body.data.vcom[0])
        np.testing.assert_allclose(happens, wanted, atol=2e-5)


def test_base_angular_acceleration_matches_its_gains(body) -> None:
    controller = WholeBodyController(body.robot)
    g = controller.gains
    kp = np.array([g.base_kp_tilt, g.base_kp_tilt, g.base_kp_yaw])
    kd = np.array([g.base_kd_tilt, g.base_kd_tilt, g.base_kd_yaw])
    for seed in SEEDS:
        state, reference = state_and_reference(body, seed)
        solution = controller.update(state, reference)
        R = rotation(state.q)
        R_wanted = pin.Quaternion(reference.quat_world_base).toRotationMatrix()
        wanted = reference.alpha_world_base + kp * pin.log3(R_wanted @ R.T)
        wanted += kd * (reference.w_world_base - R @ state.v[3:6])
        np.testing.assert_allclose(R @ solution.accelerations[3:6], wanted, atol=2e-3)


def test_body_velocities_change_by_the_solved_accelerations(body) -> None:
    state, reference = state_and_reference(body, seed=4)
    a = WholeBodyController(body.robot).update(state, reference).accelerations
    step, com, spin = 1e-5, [], []
    for dt in (-step, step):
        q = pin.integrate(body.model, state.q, dt * state.v + 0.5 * dt * dt * a)
        pin.centerOfMass(body.model, body.data, q, state.v + dt * a)
        com.append(body.data.vcom[0].copy())
        spin.append(rotation(q) @ (state.v + dt * a)[3:6])
    com_measured, spin_measured = ((x[1] - x[0]) / (2 * step) for x in (com, spin))
    np.testing.assert_allclose(com_measured, com_acceleration(body, state, a), atol=1e-5)
    np.testing.assert_allclose(spin_measured, rotation(state.q) @ a[3:6], atol=1e-5)


def test_forces_have_minimum_norm(body) -> None:
    controller = WholeBodyController(body.robot)
    for seed in SEEDS:
        state, reference = state_and_reference(body, seed)
        forces = controller.update(state, reference).forces.T.ravel()
        A = authority(body, state)
        needless = forces - np.linalg.pinv(A) @ (A @ forces)
        np.testing.assert_allclose(needless, 0.0, atol=2e-4 * body.weight)


@pytest.mark.parametrize("normal", [UP, SLOPE], ids=["flat", "slope"])
def test_forces_stay_inside_the_friction_cone_and_reach_it(body, normal) -> None:
    gains = body.robot.config.gains
    # Only the friction cone may limit the force, and the normal force must not grow instead.
    gains.weight_com_horizontal, gains.weight_com_vertical = 10.0, 10.0
    gains.weight_base_tilt, gains.edge_height, gains.weight_force = 0.01, 1.0, 0.05
    controller, reached = WholeBodyController(body.robot, gains), []
    friction = body.robot.config.friction
    for k in range(24):
        state = body.random_state(seed=k, speed=0.05)
        reference = body.reference_at(state, normal)
        angle = 2 * math.pi * k / 24
        reference.a_com = 12.0 * np.array([math.cos(angle), math.sin(angle), 0.0])
        solution = controller.update(state, reference)
        assert surefoot.is_usable(solution.status)
        along = normal @ solution.forces
        across = np.linalg.norm(solution.forces - np.outer(normal, along), axis=0)
        assert along.min() >= -1e-4 * body.weight
        assert (across - friction * along).max() <= 1e-4 * body.weight
        loaded = along > 0.05 * body.weight
        reached.append((across[loaded] / along[loaded]).max())
    assert min(reached) > friction * 0.97


def test_friction_limit_comes_from_the_configuration(go1) -> None:
    body = go1.with_config(friction=0.2)
    state = body.random_state(seed=1, speed=0.0)
    reference = body.reference_at(state)
    reference.a_com = np.array([0.0, 8.0, 0.0])
    forces = WholeBodyController(body.robot).update(state, reference).forces
    across, along = np.linalg.norm(forces[:2], axis=0), forces[2]
    assert (across - 0.2 * along).max() <= 1e-4 * body.weight
    assert across.sum() > 0.19 * along.sum()


def impossible_demands(body, count: int, speed: float):
    """Yield states with random joint velocities, and references that cannot be reached."""
    rng = np.random.default_rng(7)
    for seed in range(count):
        state = body.random_state(seed, speed)
        reference = body.reference_at(state)
        reference.a_com = 100.0 * rng.choice([-1.0, 0.0, 1.0], 3)
        reference.alpha_world_base = 1000.0 * rng.choice([-1.0, 0.0, 1.0], 3)
        yield state, reference


def test_impossible_demands_give_torques_within_motor_limits(body) -> None:
    controller, config = WholeBodyController(body.robot), body.robot.config
    solved, inside = [], []
    for state, reference in impossible_demands(body, 100, speed=10.0):
        solution = controller.update(state, reference)
        indices = np.array(body.robot.motor_to_v)
        tau, dq = solution.torques[indices - 6], state.v[indices]
        limit = [surefoot.motor_torque_limit(config, i, dq[i], np.sign(tau[i])) for i in range(12)]
        assert (np.abs(tau) <= config.tau_max).all()
        solved.append(surefoot.is_usable(solution.status))
        inside.append((np.abs(tau) <= np.array(limit) + 1e-9).all())
    assert sum(solved) > 80
    assert np.array(inside)[solved].all()


def test_impossible_demands_are_solved_in_199_of_200_ticks(body) -> None:
    controller = WholeBodyController(body.robot)
    statuses = [controller.update(*ask).status for ask in impossible_demands(body, 200, speed=2.0)]
    usable = [surefoot.is_usable(status) for status in statuses]
    assert sum(usable) >= 199  # one tick may reach the iteration limit
    assert set(statuses) <= {Status.OK, Status.SATURATED, Status.MAX_ITERATIONS}


@pytest.mark.parametrize("start", ["warm", "cold"])
def test_every_qp_near_standing_is_solved(body, start: str) -> None:
    controller, statuses = WholeBodyController(body.robot), []
    for seed in range(400):
        state, reference = state_and_reference(body, seed, SLOPE, swing=[seed % 8])
        statuses.append(controller.update(state, reference).status)
        if start == "cold":
            controller.reset()
    assert [seed for seed, status in enumerate(statuses) if not surefoot.is_usable(status)] == []


@pytest.mark.parametrize("lift", [50.0, -9.0])
def test_torque_limits_are_constraints_of_the_qp(body, lift: float) -> None:
    weak = body.with_config(tau_max=0.3 * body.robot.config.tau_max)
    state = weak.random_state(seed=2, speed=0.0)
    reference = weak.reference_at(state)
    reference.a_com, reference.alpha_world_base = lift * UP, np.array([0.0, 300.0, 0.0])
    solution = WholeBodyController(weak.robot).update(state, reference)
    assert solution.status == Status.SATURATED
    indices, tau_max = np.array(weak.robot.motor_to_v) - 6, weak.robot.config.tau_max
    share = np.abs(solution.torques)[indices] / tau_max
    assert share.max() == pytest.approx(1.0, abs=1e-4)
    # Torques that were clipped after the solve would violate the equations of motion.
    effort = pin.rnea(weak.model, weak.data, state.q, state.v, solution.accelerations)
    effort -= weak.contact_jacobian(state.q).T @ solution.forces.T.ravel()
    np.testing.assert_allclose(effort[6:], solution.torques, atol=1e-4 * tau_max.max())


def test_a_swing_foot_gets_no_force_and_the_others_carry(body) -> None:
    controller = WholeBodyController(body.robot)
    for leg in range(4):
        state, reference = state_and_reference(body, seed=leg, swing=[leg])
        solution = controller.update(state, reference)
        assert solution.status == Status.OK
        assert np.abs(solution.forces[:, leg]).max() < 1e-4 * body.weight
        assert solution.forces[2].sum() > 0.7 * body.weight


def test_force_of_a_foot_without_contact_is_limited(body) -> None:
    gains = body.robot.config.gains
    gains.force_lost_contact = 0.2
    controller = WholeBodyController(body.robot, gains)
    state = body.random_state(seed=6, speed=0.0)
    state.contact = np.array([1.0, 0.0, 1.0, 1.0])
    reference = body.reference_at(state)
    reference.a_com = np.array([0.0, 4.0, 9.0])
    forces = controller.update(state, reference).forces
    limit = controller.gains.force_lost_contact * body.weight
    assert forces[2, 1] <= limit + 1e-4 * body.weight
    assert forces[2, 3] > 1.5 * limit


def test_share_lost_contact_scales_the_force_of_a_foot_without_contact(body) -> None:
    state = body.random_state(seed=6, speed=0.0)
    state.contact = np.array([1.0, 0.0, 1.0, 1.0])
    offered = []
    for share in (0.1, 0.5, 1.0):
        gains = body.robot.config.gains
        gains.force_lost_contact, gains.share_lost_contact = 0.5, share
        controller = WholeBodyController(body.robot, gains)
        offered.append(controller.update(state, body.reference_at(state)).forces[2, 1])
    assert offered[0] < 0.9 * offered[1]
    assert offered[1] < 0.95 * offered[2]


def test_no_foot_force_exceeds_force_max_contact(go1) -> None:
    gains = surefoot.Gains()
    gains.force_max_contact = 0.3
    state = go1.random_state(seed=8, speed=0.0)
    reference = go1.reference_at(state)
    reference.a_com = np.array([0.0, 0.0, 20.0])
    forces = WholeBodyController(go1.robot, gains).update(state, reference).forces
    np.testing.assert_allclose(forces[2], 0.3 * go1.weight, atol=1e-4 * go1.weight)


@pytest.mark.parametrize("more", ["com_vertical", "base_tilt"])
def test_higher_task_weight_reduces_the_task_error(go1, more: str) -> None:
    state = go1.random_state(seed=9, speed=0.0)
    reference = go1.reference_at(state)
    reference.a_com, reference.alpha_world_base = 12.0 * UP, np.array([60.0, 60.0, 0.0])
    missed = {}
    for weight in (0.001, 100.0):
        gains = surefoot.Gains()
        gains.force_max_contact, gains.weight_force = 0.4, 0.005
        setattr(gains, f"weight_{more}", weight)
        solution = WholeBodyController(go1.robot, gains).update(state, reference)
        turn = rotation(state.q) @ solution.accelerations[3:6] - reference.alpha_world_base
        lift = com_acceleration(go1, state, solution.accelerations) - reference.a_com
        missed[weight] = {"com_vertical": abs(lift[2]), "base_tilt": np.linalg.norm(turn[:2])}
    assert missed[100.0][more] < 0.7 * missed[0.001][more]


def test_changed_gains_apply_in_the_next_tick(go1) -> None:
    controller, state = WholeBodyController(go1.robot), go1.random_state(seed=3, speed=0.0)
    reference = go1.reference_at(state)
    reference.p_com = reference.p_com + np.array([0.0, 0.0, 0.01])
    controller.update(state, reference)
    gains = surefoot.Gains()
    gains.com_kp_vertical = 300.0
    controller.set_gains(gains)
    solution = controller.update(state, reference)
    assert com_acceleration(go1, state, solution.accelerations)[2] == pytest.approx(3.0, abs=1e-4)


def set_invalid_value(field: str, value: float):
    def set_invalid_value(state, reference) -> None:
        owner = state if hasattr(state, field) else reference
        broken = np.array(getattr(owner, field))
        broken[1] = value
        setattr(owner, field, broken)

    return set_invalid_value


@pytest.mark.parametrize("value", [math.nan, math.inf])
@pytest.mark.parametrize("field", ["q", "v", "contact", "p_com", "a_com", "ground_normal"])
def test_non_finite_input_is_refused_and_the_last_solution_is_kept(go1, field, value) -> None:
    controller = WholeBodyController(go1.robot)
    state, reference = state_and_reference(go1, seed=1)
    good = controller.update(state, reference)
    set_invalid_value(field, value)(state, reference)
    refused = controller.update(state, reference)
    assert refused.status == Status.NON_FINITE
    np.testing.assert_array_equal(refused.torques, good.torques)
    np.testing.assert_array_equal(refused.forces, good.forces)
    np.testing.assert_array_equal(refused.accelerations, good.accelerations)
    assert controller.update(*state_and_reference(go1, seed=1)).status == Status.OK


def test_nan_foot_reference_is_refused(go1) -> None:
    controller = WholeBodyController(go1.robot)
    state, reference = state_and_reference(go1, seed=1)
    reference.foot(2).p_world = np.array([math.nan, 0.0, 0.0])
    assert controller.update(state, reference).status == Status.NON_FINITE
    assert controller.update(*state_and_reference(go1, seed=1)).status == Status.OK


@pytest.mark.parametrize(("nq", "nv"), [(18, 18), (19, 17), (26, 25), (0, 0)])
def test_a_state_of_another_robots_size_is_refused(go1, nq: int, nv: int) -> None:
    state, reference = state_and_reference(go1, seed=1)
    state.q, state.v = np.zeros(nq), np.zeros(nv)
    assert WholeBodyController(go1.robot).update(state, reference).status == Status.WRONG_SIZE


@pytest.mark.parametrize(
    "normal", [[0.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]]
)
def test_invalid_ground_normal_is_refused(go1, normal: list[float]) -> None:
    controller = WholeBodyController(go1.robot)
    state, reference = state_and_reference(go1, seed=1)
    good = controller.update(state, reference)
    reference.ground_normal = np.array(normal)
    refused = controller.update(state, reference)
    assert refused.status == Status.BAD_REFERENCE
    np.testing.assert_array_equal(refused.torques, good.torques)


def test_a_reference_refuses_a_quaternion_that_is_not_unit() -> None:
    reference = surefoot.Reference()
    with pytest.raises(surefoot.Error, match=r"\(x, y, z, w\): got norm 2.*, expected 1"):
        reference.quat_world_base = np.array([2.0, 0.0, 0.0, 0.0])
    np.testing.assert_array_equal(reference.quat_world_base, [0.0, 0.0, 0.0, 1.0])


def test_hold_returns_a_reference_at_the_current_state(body) -> None:
    controller, state = WholeBodyController(body.robot), body.random_state(seed=5)
    held, expected = controller.hold(state), body.reference_at(state)
    np.testing.assert_allclose(held.p_com, expected.p_com, atol=1e-9)
    assert abs(held.quat_world_base @ expected.quat_world_base) == pytest.approx(1.0)
    for leg in range(4):
        np.testing.assert_allclose(held.foot(leg).p_world, expected.foot(leg).p_world, atol=1e-9)
    for at_rest in (held.v_com, held.a_com, held.w_world_base, held.alpha_world_base):
        np.testing.assert_array_equal(at_rest, 0.0)
    state.v = np.zeros(body.robot.nv)
    a = controller.update(state, held).accelerations
    np.testing.assert_allclose(com_acceleration(body, state, a), 0.0, atol=1e-5)
    with pytest.raises(surefoot.Error, match=r"expected"):
        controller.hold(surefoot.RobotState(20, 19))


@pytest.mark.parametrize(("nq", "nv"), [(6, 18), (19, 5), (-1, 18)])
def test_a_state_too_small_for_a_base_is_refused(nq: int, nv: int) -> None:
    with pytest.raises(surefoot.Error, match="expected"):
        surefoot.RobotState(nq, nv)


@pytest.mark.parametrize("leg", range(4))
def test_straight_leg_is_singular_and_a_bent_leg_is_solved_again(body, leg) -> None:
    options = surefoot.WholeBodyOptions(form=surefoot.QpForm.CONDENSED)
    controller = WholeBodyController(body.robot, body.robot.config.gains, options)
    state, reference = state_and_reference(body, seed=1)
    bent = np.array(state.q)
    straight = bent.copy()
    straight[body.robot.motor_to_q[3 * leg + 2]] = 0.0
    state.q = straight
    assert controller.update(state, reference).status == Status.SINGULAR
    solution = WholeBodyController(body.robot).update(state, reference)
    assert surefoot.is_usable(solution.status)
    assert solution.form == surefoot.QpForm.GENERAL
    assert np.isfinite(solution.accelerations).all()
    tau = solution.torques[np.array(body.robot.motor_to_v) - 6]
    assert (np.abs(tau) <= body.robot.config.tau_max).all()
    state.q = bent
    assert controller.update(state, reference).status == Status.OK


def test_controller_without_a_solution_returns_zero_torques(go1) -> None:
    controller = WholeBodyController(go1.robot)
    state, reference = state_and_reference(go1, seed=1)
    state.q = np.full(19, math.nan)
    solution = controller.update(state, reference)
    np.testing.assert_array_equal(solution.torques, np.zeros(12))
    assert solution.status == Status.NON_FINITE


def test_identical_inputs_give_identical_solutions(body) -> None:
    first, second = WholeBodyController(body.robot), WholeBodyController(body.robot)
    for seed in range(20):
        state, reference = state_and_reference(body, seed)
        ours, theirs = first.update(state, reference), second.update(state, reference)
        np.testing.assert_array_equal(ours.torques, theirs.torques)
        np.testing.assert_array_equal(ours.accelerations, theirs.accelerations)


def test_reset_whole_body_controller_equals_a_new_one(go1) -> None:
    used, fresh = WholeBodyController(go1.robot), WholeBodyController(go1.robot)
    for seed in range(10):
        state, reference = state_and_reference(go1, seed)
        reference.a_com = 30.0 * np.ones(3)
        used.update(state, reference)
    used.reset()
    for seed in range(5):
        state, reference = state_and_reference(go1, seed)
        ours, theirs = used.update(state, reference), fresh.update(state, reference)
        np.testing.assert_array_equal(ours.torques, theirs.torques)


def test_torques_do_not_depend_on_the_world_origin(body) -> None:
    state, reference = state_and_reference(body, seed=2)
    here = WholeBodyController(body.robot).update(state, reference)
    shift = np.array([3.0, -7.0, 1.0])
    state.q = np.concatenate([state.q[:3] + shift, state.q[3:]])
    reference.p_com = reference.p_com + shift
    for leg in range(4):
        reference.foot(leg).p_world = reference.foot(leg).p_world + shift
    there = WholeBodyController(body.robot).update(state, reference)
    np.testing.assert_allclose(there.torques, here.torques, atol=1e-4)


@pytest.mark.parametrize("length", [0.0, 0.5, 2.0])
def test_a_base_quaternion_far_from_unit_length_is_refused(go1, length: float) -> None:
    state, reference = state_and_reference(go1, seed=1)
    state.q = np.concatenate([state.q[:3], length * state.q[3:7], state.q[7:]])
    assert WholeBodyController(go1.robot).update(state, reference).status == Status.BAD_QUATERNION


def test_any_finite_input_gives_finite_torques_within_limits(go1) -> None:
    controller, tau_max = WholeBodyController(go1.robot), go1.robot.config.tau_max.max()
    rng = np.random.default_rng(5)
    reference = go1.reference_at(go1.random_state(0))
    for _ in range(500):
        state = surefoot.RobotState()
        q = 10.0 ** rng.uniform(-3, 12) * rng.normal(size=19)
        q[3:7] /= np.linalg.norm(q[3:7])
        state.q, state.v = q, 10.0 ** rng.uniform(-3, 200) * rng.normal(size=18)
        state.contact = 10.0 ** rng.uniform(-3, 200) * rng.normal(size=4)
        reference.a_com = 10.0 ** rng.uniform(-3, 200) * rng.normal(size=3)
        solution = controller.update(state, reference)
        assert np.abs(solution.torques).max() <= tau_max
        assert np.isfinite(solution.forces).all()
        assert np.isfinite(solution.accelerations).all()


def test_stand_controller_matches_the_whole_body_controller(body) -> None:
    # The contact points depend on the ground normal, which the estimator updates one tick late. Low
    # foot gains keep the effect small.
    gains = body.robot.config.gains
    gains.foot_kp, gains.foot_kd = 400.0, 35.0
    standing, rng = surefoot.StandController(body.robot, gains), np.random.default_rng(6)
    for tick in range(180):
        report = body.resting_sample(2 * tick)
        report.imu.gyroscope[:] = 0.1 * rng.uniform(-1, 1, 3)
        report.imu.accelerometer[:] += 2.0 * np.sin(0.1 * tick)
        for i in range(12):
            report.motorState[i].dq = 0.3 * rng.uniform(-1, 1)
        standing.update(report)
        assert surefoot.is_usable(standing.status)
        if tick < 80:
            continue  # the attitude converges: the normal of the last tick differs too much
        twin = WholeBodyController(body.robot, gains).update(standing.state, standing.reference)
        theirs = standing.solution
        tau_max = body.robot.config.tau_max.max()
        np.testing.assert_allclose(theirs.torques, twin.torques, atol=1e-3 * tau_max)
        most = max(20.0, np.abs(twin.accelerations).max())  # grows as the random samples diverge
        np.testing.assert_allclose(theirs.accelerations, twin.accelerations, atol=1e-3 * most)


def test_overloaded_motors_are_saturated_within_limits(body) -> None:
    weak = body.with_config(tau_max=0.1 * body.robot.config.tau_max)
    state = weak.random_state(seed=1, speed=0.0)
    solution = WholeBodyController(weak.robot).update(state, weak.reference_at(state))
    assert solution.status == Status.SATURATED
    assert (np.abs(solution.torques) <= weak.robot.config.tau_max.max() + 1e-9).all()


@pytest.mark.parametrize("weight", [1e3, 1e5])
@pytest.mark.parametrize("form", [surefoot.QpForm.CONDENSED, surefoot.QpForm.GENERAL])
def test_heavy_task_does_not_disturb_unrelated_forces(go1, weight: float, form) -> None:
    class Yaw(surefoot.Task):
        def rows(self) -> int:
            return 1

        def write(self, state, rows) -> bool:
            rows.A_a[0, 5], rows.weight[0] = 1.0, weight
            return np.isfinite(state.q).all()  # a NumPy bool is accepted

    options = surefoot.WholeBodyOptions(form=form)
    free = WholeBodyController(go1.robot, options=options)
    state = surefoot.RobotState()
    state.q = go1.robot.q_standing()
    reference = free.hold(state)
    reference.p_com[2] += 0.01
    expected = free.update(state, reference).forces
    controller = WholeBodyController(go1.robot, options=options)
    controller.add_task(Yaw())
    solution = controller.update(state, reference)
    if surefoot.is_usable(solution.status):
        np.testing.assert_allclose(solution.forces, expected, atol=0.02 * go1.weight)
    else:
        assert weight > 1e4 and solution.status in (Status.BAD_TASK, Status.MAX_ITERATIONS)


def test_vector_fields_accept_array_likes_and_name_shape_errors() -> None:
    reference, state = surefoot.Reference(), surefoot.RobotState()
    reference.p_com, state.contact = [0, 0, 0.3], (1, 1, 0.5, 1)
    np.testing.assert_array_equal(reference.p_com, [0, 0, 0.3])
    for bad in ([0.0, 1.0], np.zeros((3, 3))):
        with pytest.raises(ValueError, match=r"p_com: got shape \(.*\), expected \(3,\)"):
            reference.p_com = bad


def test_contact_confidence_outside_0_to_1_is_refused(go1) -> None:
    state, reference = state_and_reference(go1, seed=1)
    for contact in ([1.0, 1.0, 1.0, 1.1], [-0.1, 1.0, 1.0, 1.0]):
        state.contact = contact
        assert WholeBodyController(go1.robot).update(state, reference).status == Status.IMPLAUSIBLE
