# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import math

import numpy as np
import pinocchio as pin
import pytest
import surefoot
from surefoot import SensorVerdict, StateEstimator, Status

DT = 0.002
SUBSTEPS = 4  # integration steps of the true motion between two samples
MOUNT = np.array([0.5, 0.5, -0.5, 0.5])  # turns every IMU axis onto another base axis
TILTED = pin.rpy.rpyToMatrix(0.1, -0.08, 2.5)
AIRBORNE = (0.0, 0.3, 0.35, 0.35)  # FR is in the air


def rotation(q):
    return pin.Quaternion(*np.roll(q[3:7], 1)).toRotationMatrix()


def tilt(q) -> float:
    """Return the angle of the base's z axis from the vertical [deg]."""
    return math.degrees(math.acos(min(1.0, rotation(q)[2, 2])))


def feed(estimator, report, ticks: int, dt: float = DT):
    """Update the estimator `ticks` times with the same sample; return its states."""
    states = []
    for _ in range(ticks):
        assert estimator.update(report, dt) == Status.OK
        states.append(estimator.state)
    return states


def contacts(states, leg: int = 0):
    return np.array([state.contact[leg] for state in states])


def speeds(states):
    return np.array([np.linalg.norm(state.v[:3]) for state in states])


@pytest.mark.parametrize("mount", [np.array([1.0, 0, 0, 0]), MOUNT], ids=["along", "rotated"])
def test_attitude_at_rest_equals_the_imu_attitude_without_yaw(body, mount) -> None:
    body = body.with_config(quat_base_imu=mount)
    states = feed(StateEstimator(body.robot), body.resting_sample(0, TILTED), 1000)
    heading = math.atan2(TILTED[1, 0], TILTED[0, 0])
    expected = pin.rpy.rpyToMatrix(0.0, 0.0, -heading) @ TILTED
    for state in (states[0], states[-1]):
        np.testing.assert_allclose(rotation(state.q), expected, atol=1e-6)


def test_resting_robot_does_not_drift(body) -> None:
    body = body.with_config(quat_base_imu=MOUNT)
    states = feed(StateEstimator(body.robot), body.resting_sample(0, TILTED), 2500)
    positions = np.array([state.q[:3] for state in states])
    assert np.abs(positions - positions[0]).max() < 1e-6
    assert np.abs([state.v for state in states]).max() < 1e-6


def test_world_origin_is_under_the_base_at_foot_height(body) -> None:
    state = feed(StateEstimator(body.robot), body.resting_sample(0, TILTED), 1)[0]
    np.testing.assert_allclose(state.q[:2], 0.0, atol=1e-6)
    assert body.contact_points(state.q)[:, 2].mean() == pytest.approx(0.0, abs=1e-6)


def test_joints_are_reported_in_pinocchios_order(body) -> None:
    report = body.resting_sample(0)
    for i in range(12):
        report.motorState[i].q += 0.01 * i
        report.motorState[i].dq = 1.0 + i
    estimator = StateEstimator(body.robot)
    estimator.update(report, DT)
    q, v = estimator.state.q, estimator.state.v
    wanted = body.robot.config.q_standing + 0.01 * np.arange(12)
    np.testing.assert_allclose(q[list(body.robot.motor_to_q)], wanted, atol=1e-6)
    np.testing.assert_allclose(v[list(body.robot.motor_to_v)], 1.0 + np.arange(12))


@pytest.mark.parametrize("axis", range(3))
def test_gyroscope_bias_is_estimated_within_10_s(go1, axis: int) -> None:
    estimator, report = StateEstimator(go1.robot), go1.resting_sample(0)
    report.imu.gyroscope[axis] = 0.02
    states = feed(estimator, report, 5000)
    assert abs(states[0].v[3 + axis]) == pytest.approx(0.02, rel=0.01)
    assert np.abs(states[-1].v[3:6]).max() < 0.001
    assert max(tilt(state.q) for state in states) < 1.0
    assert tilt(states[-1].q) < 0.5


def test_gyroscope_bias_is_estimated_through_a_rotated_mount(go1) -> None:
    body = go1.with_config(quat_base_imu=MOUNT)
    estimator, report = StateEstimator(body.robot), body.resting_sample(0, TILTED)
    report.imu.gyroscope[0] = 0.02
    assert np.abs(feed(estimator, report, 5000)[-1].v[3:6]).max() < 0.001


def test_gyroscope_bias_is_estimated_at_a_90_deg_heading(go1) -> None:
    estimator, report = StateEstimator(go1.robot), go1.resting_sample(0, loads=(0.0,) * 4)
    feed(estimator, report, 100)
    report.imu.gyroscope[2] = math.pi  # a person turns the lifted robot
    feed(estimator, report, 250)
    report = go1.resting_sample(0)
    report.imu.gyroscope[0] = 0.02
    states = feed(estimator, report, 5000)
    assert pin.rpy.matrixToRpy(rotation(states[-1].q))[2] == pytest.approx(math.pi / 2, abs=0.1)
    assert np.abs(states[-1].v[3:6]).max() < 0.001
    assert tilt(states[-1].q) < 0.5


def moving_reports(body, seconds: float):
    """Yield samples, true q and true v of a base that rests, then sways on rolling feet."""
    q, truth = body.robot.q_standing(), []
    arm, R_base_imu = body.robot.config.p_base_imu, pin.Quaternion(*MOUNT).toRotationMatrix()
    fine = DT / SUBSTEPS
    for k in range(SUBSTEPS * round(seconds / DT)):
        ramp = min(1.0, max(0.0, k * fine - 2.0))
        phase = 2 * math.pi * k * fine * np.array([1.0, 0.7, 1.3, 0.9, 1.1, 0.6])
        # Linear velocity in world axes, at most 0.12 m/s; angular in base axes, at most 0.3 rad/s.
        twist = ramp * np.array([0.12, 0.08, 0.06, 0.3, 0.3, 0.2]) * np.cos(phase)
        twist[:3] = rotation(q).T @ twist[:3]
        J = body.contact_jacobian(q)
        v = np.concatenate([twist, -np.linalg.solve(J[:, 6:], J[:, :6] @ twist)])
        truth.append((q, v, rotation(q) @ (v[:3] + np.cross(v[3:6], arm))))
        q = pin.integrate(body.model, q, fine * v)
    for k in range(SUBSTEPS, len(truth) - 1, SUBSTEPS):
        q, v, _ = truth[k]
        force = (truth[k + 1][2] - truth[k - 1][2]) / (2 * fine) + np.array([0, 0, 9.81])
        R = rotation(q) @ R_base_imu
        report = body.resting_sample(0, rotation(q))
        report.footForceEst = np.full(4, round(0.25 * body.weight), dtype=np.int16)
        report.imu.gyroscope[:], report.imu.accelerometer[:] = R_base_imu.T @ v[3:6], R.T @ force
        for i in range(12):
            report.motorState[i].q = q[body.robot.motor_to_q[i]]
            report.motorState[i].dq = v[body.robot.motor_to_v[i]]
        yield report, q, v


def test_swaying_body_is_tracked_with_an_offset_imu(body) -> None:
    arm = np.array([-0.05, 0.06, 0.04])
    body = body.with_config(quat_base_imu=MOUNT, p_base_imu=arm)
    estimator, missed, moved = StateEstimator(body.robot), [], []
    for report, q, v in moving_reports(body, 5.0):
        assert estimator.update(report, DT) == Status.OK
        state = estimator.state
        missed.append(np.abs(state.v[:6] - v[:6]))
        moved.append((state.q[:3] - q[:3], tilt(q), tilt(state.q)))
    assert np.max([m[:3] for m in missed]) < 0.015
    assert np.max([m[3:] for m in missed]) < 0.02
    offsets = np.array([offset for offset, _, _ in moved])
    assert np.abs(offsets - offsets[0]).max() < 0.005
    assert max(true for _, true, _ in moved) > 2.0
    assert max(abs(true - ours) for _, true, ours in moved) < 0.5


def test_torque_force_matches_the_load_of_each_foot(body) -> None:
    loads = (0.1, 0.2, 0.3, 0.4)
    estimator = StateEstimator(body.robot)
    feed(estimator, body.resting_sample(0, pin.rpy.rpyToMatrix(0.05, 0.1, 0.0), loads), 100)
    np.testing.assert_allclose(estimator.normal_forces_from_torques / body.weight, loads, atol=1e-3)


def test_torques_detect_a_lifted_foot_without_foot_force(body) -> None:
    estimator = StateEstimator(body.robot)
    standing = feed(estimator, body.resting_sample(0), 100)
    lifted = feed(estimator, body.resting_sample(0, loads=AIRBORNE), 50)
    landed = feed(estimator, body.resting_sample(0), 50)
    assert not estimator.has_foot_force_est
    assert contacts(standing).min() == 1.0
    assert contacts(lifted)[0] >= 0.8
    assert contacts(lifted)[9] == 0.0  # 20 ms
    assert contacts(lifted)[-1] == 0.0
    assert contacts(landed)[-1] == 1.0
    for leg in (1, 2, 3):
        assert contacts(standing + lifted + landed, leg).min() == 1.0


def loaded(body, first: float):
    """Return a sample in which FR carries `first` newtons, by footForceEst and by torques."""
    share = first / body.weight
    rest = (1.0 - share) / 3.0
    report = body.resting_sample(0, loads=(share, rest, rest, rest))
    report.footForceEst = np.array([first, 40, 40, 40], dtype=np.int16)
    return report


def test_contact_ends_after_the_dwell_time(go1) -> None:
    estimator = StateEstimator(go1.robot)
    feed(estimator, loaded(go1, 32), 100)
    assert estimator.has_foot_force_est
    leaving = contacts(feed(estimator, loaded(go1, 0), 30))
    dwell = round(go1.robot.config.gains.contact_dwell / DT)
    steps = -np.diff(leaving, prepend=1.0)
    assert steps.max() <= 1.0 / dwell + 1e-9  # not faster than the dwell time
    assert leaving[dwell - 2] > 0.0
    assert leaving[dwell + 4 :].max() == 0.0  # after the dwell time and the filter's lag


def test_one_wrong_force_sample_reduces_contact_by_at_most_0_2(go1) -> None:
    estimator = StateEstimator(go1.robot)
    feed(estimator, loaded(go1, 32), 100)
    assert feed(estimator, loaded(go1, 0), 1)[-1].contact[0] >= 0.8
    assert feed(estimator, loaded(go1, 32), 3)[-1].contact[0] == 1.0


def test_a_load_between_the_thresholds_changes_no_contact(go1) -> None:
    gains = go1.robot.config.gains
    between = round(0.5 * (gains.contact_force_on + gains.contact_force_off) * go1.weight)
    estimator = StateEstimator(go1.robot)
    feed(estimator, loaded(go1, 32), 100)
    assert contacts(feed(estimator, loaded(go1, between), 50))[-1] == 1.0
    feed(estimator, loaded(go1, 0), 50)
    assert contacts(feed(estimator, loaded(go1, between), 50))[-1] == 0.0
    above = math.ceil((gains.contact_force_on + gains.contact_force_width) * go1.weight)
    assert contacts(feed(estimator, loaded(go1, above), 50))[-1] == 1.0


def test_dwell_time_does_not_depend_on_the_rate(go1) -> None:
    estimator = StateEstimator(go1.robot)
    feed(estimator, loaded(go1, 32), 200, dt=0.001)
    leaving = contacts(feed(estimator, loaded(go1, 0), 30, dt=0.001))
    dwell = round(go1.robot.config.gains.contact_dwell / 0.001)
    assert -np.diff(leaving, prepend=1.0).min() >= 0.0
    assert -np.diff(leaving, prepend=1.0).max() <= 1.0 / dwell + 1e-9
    assert leaving[dwell - 2] > 0.0
    assert leaving[dwell + 8 :].max() == 0.0


@pytest.mark.parametrize("count", [1, -32768, 32767])
def test_stray_count_does_not_revive_a_dead_foot_force(go1, count: int) -> None:
    estimator, stray = StateEstimator(go1.robot), go1.resting_sample(0)
    feed(estimator, go1.resting_sample(0), 100)
    stray.footForceEst[2] = count
    states = feed(estimator, stray, 20) + feed(estimator, go1.resting_sample(0), 100)
    assert not estimator.has_foot_force_est
    assert min(contacts(states, leg).min() for leg in range(4)) == 1.0


def test_zero_foot_force_under_load_is_dead(go1) -> None:
    estimator = StateEstimator(go1.robot)
    feed(estimator, loaded(go1, 32), 100)
    feed(estimator, go1.resting_sample(0), 100)
    assert not estimator.has_foot_force_est
    assert feed(estimator, go1.resting_sample(0), 50)[-1].contact.min() == 1.0


def test_zero_foot_force_in_the_air_stays_alive(go1) -> None:
    estimator = StateEstimator(go1.robot)
    feed(estimator, loaded(go1, 32), 100)
    states = feed(estimator, go1.resting_sample(0, loads=(0.0,) * 4), 200)
    assert estimator.has_foot_force_est
    assert states[-1].contact.max() == 0.0


@pytest.mark.parametrize("joint", range(3))
def test_slipping_foot_does_not_move_the_estimate(go1, joint: int) -> None:
    estimator, slipping = StateEstimator(go1.robot), go1.resting_sample(0)
    feed(estimator, go1.resting_sample(0), 500)
    slipping.motorState[joint].dq = 5.0
    states = feed(estimator, slipping, 50) + feed(estimator, go1.resting_sample(0), 250)
    assert speeds(states).max() < 0.01
    assert np.linalg.norm(states[-1].q[:3] - states[0].q[:3]) < 0.003
    assert max(tilt(state.q) for state in states) < 0.6


@pytest.mark.parametrize("joint", range(3))
def test_wrong_joint_speed_for_500_ms_does_not_tilt_the_estimate(go1, joint: int) -> None:
    estimator, slipping = StateEstimator(go1.robot), go1.resting_sample(0)
    feed(estimator, go1.resting_sample(0), 500)
    slipping.motorState[joint].dq = 5.0
    states = feed(estimator, slipping, 250) + feed(estimator, go1.resting_sample(0), 500)
    assert max(tilt(state.q) for state in states) < 0.6
    assert speeds(states).max() < 0.04


@pytest.mark.parametrize("rate", [6.0, 0.5], ids=["fast", "slow"])
def test_swinging_leg_changes_neither_pose_nor_gyroscope_bias(go1, rate: float) -> None:
    estimator, report = StateEstimator(go1.robot), go1.resting_sample(0, loads=AIRBORNE)
    feed(estimator, go1.resting_sample(0), 500)
    states = feed(estimator, report, 100)
    for k in range(200):
        report.motorState[1].q = 0.8 + rate / 20.0 * math.sin(20.0 * k * DT)
        report.motorState[1].dq = rate * math.cos(20.0 * k * DT)
        states += feed(estimator, report, 1)
    assert speeds(states).max() < 0.01
    assert np.linalg.norm(states[-1].q[:3] - states[0].q[:3]) < 0.003
    assert np.abs(states[-1].v[3:6]).max() < 1e-4


def test_gravity_corrects_a_wrong_vendor_attitude(go1) -> None:
    report = go1.resting_sample(0)
    report.imu.quaternion[:] = np.roll(pin.Quaternion(pin.rpy.rpyToMatrix(0.1, 0, 0)).coeffs(), 1)
    states = feed(StateEstimator(go1.robot), report, 5000)
    assert tilt(states[0].q) == pytest.approx(math.degrees(0.1), abs=0.1)
    assert tilt(states[-1].q) < 0.5


def test_short_acceleration_does_not_tilt_the_estimate(go1) -> None:
    estimator, accelerated_sample = StateEstimator(go1.robot), go1.resting_sample(0)
    feed(estimator, go1.resting_sample(0), 500)
    accelerated_sample.imu.accelerometer[0] = 8.0
    assert max(tilt(state.q) for state in feed(estimator, accelerated_sample, 50)) < 0.01


@pytest.mark.parametrize("loads", [(0.25,) * 4, AIRBORNE], ids=["four feet", "three feet"])
@pytest.mark.parametrize("axis", range(3))
def test_estimate_recovers_from_a_saturated_accelerometer(go1, axis: int, loads) -> None:
    estimator, saturated_sample = StateEstimator(go1.robot), go1.resting_sample(0, loads=loads)
    feed(estimator, go1.resting_sample(0, loads=loads), 500)
    saturated_sample.imu.accelerometer[axis] = 16 * 9.81
    feed(estimator, saturated_sample, 5)
    states = feed(estimator, go1.resting_sample(0, loads=loads), 500)
    assert speeds(states)[250:].max() < 0.04
    assert np.linalg.norm(states[-1].q[:3] - states[250].q[:3]) < 0.005


def assert_refused(estimator, report, status) -> None:
    before = estimator.state
    assert estimator.update(report, DT) == status
    for field in ("q", "v", "contact"):
        np.testing.assert_array_equal(getattr(estimator.state, field), getattr(before, field))


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e30])
def test_non_finite_input_is_refused_and_the_state_is_kept(go1, value: float) -> None:
    estimator = StateEstimator(go1.robot)
    feed(estimator, go1.resting_sample(0), 20)
    for field in ("quaternion", "gyroscope", "accelerometer"):
        report = go1.resting_sample(0)
        getattr(report.imu, field)[2] = value
        assert_refused(estimator, report, Status.NON_FINITE)
    for field in ("q", "dq", "tauEst"):
        report = go1.resting_sample(0)
        setattr(report.motorState[11], field, value)
        assert_refused(estimator, report, Status.NON_FINITE)
    feed(estimator, go1.resting_sample(0), 1)


@pytest.mark.parametrize("dt", [0.0, -0.002, 0.2, math.nan, math.inf])
def test_invalid_time_step_is_refused_and_the_state_is_kept(go1, dt: float) -> None:
    estimator, report = StateEstimator(go1.robot), go1.resting_sample(0)
    feed(estimator, report, 20)
    before = estimator.state
    assert estimator.update(report, dt) == Status.STALE_TICK
    np.testing.assert_array_equal(estimator.state.q, before.q)
    np.testing.assert_allclose(feed(estimator, report, 20)[-1].v, before.v, atol=1e-6)


@pytest.mark.parametrize("length", [0.0, 0.5, 0.94, 1.06, 2.0])
def test_non_unit_quaternion_is_ignored_and_reported(go1, length) -> None:
    estimator, plain = StateEstimator(go1.robot), StateEstimator(go1.robot)
    report = go1.resting_sample(0)
    feed(estimator, report, 20), feed(plain, report, 20)
    good = feed(plain, report, 100)[-1]
    report.imu.quaternion[:] *= length
    state = feed(estimator, report, 100)[-1]
    np.testing.assert_array_equal(state.q, good.q)
    wanted = SensorVerdict.IMPLAUSIBLE if length else SensorVerdict.ZERO
    assert estimator.report.quaternion == wanted


def test_accelerometer_gives_the_tilt_without_a_quaternion(go1) -> None:
    report = go1.resting_sample(0, TILTED)
    report.imu.quaternion[:] = 0.0
    state = feed(StateEstimator(go1.robot), report, 1)[0]
    assert tilt(state.q) == pytest.approx(math.degrees(math.acos(TILTED[2, 2])), abs=1e-3)


@pytest.mark.parametrize("length", [0.96, 1.04])
def test_nearly_unit_quaternion_is_normalised(go1, length: float) -> None:
    report = go1.resting_sample(0, TILTED)
    good = feed(StateEstimator(go1.robot), report, 1)[0]
    report.imu.quaternion[:] *= length
    state = feed(StateEstimator(go1.robot), report, 1)[0]
    np.testing.assert_allclose(state.q, good.q, atol=1e-6)


def test_reset_estimator_equals_a_new_one(go1) -> None:
    used, report = StateEstimator(go1.robot), loaded(go1, 0)
    report.imu.gyroscope[:] = [0.3, -0.2, 0.1]
    report.motorState[4].dq = 3.0
    feed(used, report, 100)
    used.reset()
    fresh = StateEstimator(go1.robot)
    for ours, theirs in zip(
        feed(used, go1.resting_sample(0, TILTED), 30),
        feed(fresh, go1.resting_sample(0, TILTED), 30),
        strict=True,
    ):
        np.testing.assert_array_equal(ours.q, theirs.q)
        np.testing.assert_array_equal(ours.v, theirs.v)
        np.testing.assert_array_equal(ours.contact, theirs.contact)


def test_estimator_accepts_only_low_states(go1) -> None:
    with pytest.raises(TypeError):
        StateEstimator(go1.robot).update(go1.random_state(0), DT)
    assert isinstance(StateEstimator(go1.robot).state, surefoot.RobotState)
