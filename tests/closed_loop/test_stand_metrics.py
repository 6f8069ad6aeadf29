"""Metrics of stand logs with known contents."""

import dataclasses
import json
import math

import numpy as np
import pinocchio
import pytest
import surefoot
from stand_log_helpers import RATE, ROBOT, TICKS, still_log, turn_base
from surefoot import FallbackLevel, LowCmd, Status
from surefoot.files.json_values import json_value
from surefoot.sim import PlantSettings, Push
from surefoot.stand import FIELDS, StandSettings, parse_push, run_stand, summarise
from surefoot.stand.foot_frame import foot_positions, pose_from_feet
from surefoot.stand.log_recorder import is_torque_mode
from surefoot.stand.settling import settle_time, settled_ticks
from surefoot.stand.summary_text import push_line


def with_push(log, time=1.0):
    push = Push("lateral", 5.0, 0.1, time)
    return dataclasses.replace(log, pushes=(push,), push_shares=(5.0 / 12.0,))


def test_a_still_robot_has_no_errors_and_is_settled():
    s = summarise(still_log())
    assert s["settled"] and not s["fell"] and s["torque_mode_only"]
    zero = "height_error_mm tilt_error_deg yaw_error_deg max_tilt_deg max_foot_travel_mm com_rms_mm"
    zero += " joint_velocity_rms torque_hf_rms peak_power_w estimator_velocity_rmse qp_failures"
    assert [s[name] for name in zero.split()] == pytest.approx([0.0] * 11, abs=1e-6)


def test_height_error_is_relative_to_the_feet():
    log = still_log()
    log.q_true[-1, 2] -= 0.003
    assert summarise(log)["height_error_mm"] == pytest.approx(3.0)
    log.feet[-1, 2] -= 0.003
    assert summarise(log)["height_error_mm"] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("leg", range(4))
def test_each_foot_contributes_a_quarter_to_height(leg):
    log = still_log()
    log.feet[-1, 2, leg] += 0.004
    assert summarise(log)["height_error_mm"] == pytest.approx(1.0)


@pytest.mark.parametrize("axis", [0, 1])
def test_tilt_error_is_reported_at_the_end_and_at_its_maximum(axis):
    log = still_log()
    log.q_true[700] = turn_base(log.q_true[700], axis, -4.0)
    log.q_true[-1] = turn_base(log.q_true[-1], axis, 1.5)
    s = summarise(log)
    assert (s["tilt_error_deg"], s["max_tilt_deg"]) == pytest.approx((1.5, 4.0))
    assert s["yaw_error_deg"] == pytest.approx(0.0, abs=1e-6)


def test_yaw_error_is_relative_to_the_heading_of_the_feet():
    log = still_log()
    log.q_true[-1] = turn_base(log.q_true[-1], 2, 3.0)
    s = summarise(log)
    assert (s["yaw_error_deg"], s["tilt_error_deg"]) == pytest.approx((3.0, 0.0), abs=1e-6)
    assert not s["settled"]
    log.feet[-1] = foot_positions(ROBOT, log.q_true[-1:])[0]
    s = summarise(log)
    assert s["yaw_error_deg"] == pytest.approx(0.0, abs=1e-6) and s["settled"]


def test_pose_relative_to_the_feet_is_invariant_to_rigid_motion():
    log = still_log()
    first = pose_from_feet(log.q_true[:1], log.feet[:1])
    q = turn_base(log.q_true[0], 2, 130.0)
    q[:3] += [3.0, -2.0, 0.1]
    moved = pose_from_feet(q[None], foot_positions(ROBOT, q[None]))
    np.testing.assert_allclose(moved.position, first.position, atol=1e-12)
    np.testing.assert_allclose(moved.rotation, first.rotation, atol=1e-12)


def test_foot_travel_is_the_maximum_over_feet_and_time():
    log = still_log()
    log.feet[900, :, 2] += [0.003, 0.0, 0.004]
    log.feet[901:, 0, 1] += 0.002
    assert summarise(log)["max_foot_travel_mm"] == pytest.approx(5.0)


def test_torque_hf_rms_is_the_rms_of_the_worst_joint():
    log = still_log()
    log.tau[:, 4] = 10.0 + 0.6 * np.sin(2 * np.pi * 50.0 * log.time)
    log.tau[:, 7] = 0.2 * np.sin(2 * np.pi * 80.0 * log.time)
    assert summarise(log)["torque_hf_rms"] == pytest.approx(0.6 / math.sqrt(2), rel=1e-3)


@pytest.mark.parametrize("frequency", [5.0, 5.3, 12.7, 25.0])
def test_torque_below_30_hz_is_excluded_from_torque_hf_rms(frequency):
    log = still_log()
    log.tau[:, 4] = 3.0 * np.sin(2 * np.pi * frequency * log.time) + 2.0 * log.time
    assert summarise(log)["torque_hf_rms"] < 3e-3


def test_white_noise_torque_counts_by_its_band_share():
    log = still_log()
    log.tau[:] = np.random.default_rng(0).normal(0.0, 0.5, log.tau.shape)
    share = math.sqrt(1.0 - 30.0 / (RATE / 2))
    assert summarise(log)["torque_hf_rms"] == pytest.approx(0.5 * share, rel=0.1)


def test_torque_hf_rms_is_null_at_50_hz():
    slow = dataclasses.replace(
        still_log(), settings=StandSettings(plant=PlantSettings(control_rate=50.0))
    )
    assert summarise(slow)["torque_hf_rms"] is None


def test_stillness_metrics_use_the_last_2_s():
    log = still_log()
    log.com[:1000, 0], log.dq[:1000], log.tau[:990, 1] = 0.5, 9.0, 30.0
    log.com[1000:, 1] = 0.002 * np.sin(2 * np.pi * 2.0 * log.time[1000:])
    log.dq[1000:] = 0.04
    s = summarise(log)
    assert s["com_rms_mm"] == pytest.approx(2.0 / math.sqrt(2), rel=1e-5)
    assert s["joint_velocity_rms"] == pytest.approx(0.04)
    assert s["torque_hf_rms"] == pytest.approx(0.0, abs=1e-9)


def test_settle_time_ends_at_the_last_unsettled_tick():
    log = with_push(still_log())
    log.q_true[510:800, 1] += 0.02
    assert settle_time(log) == pytest.approx(800 / RATE - 1.1)
    assert summarise(log)["settle_time_s"] == pytest.approx(0.5)


def test_push_without_motion_has_zero_settle_time():
    assert settle_time(with_push(still_log())) == 0.0


def test_settle_time_is_none_without_a_push_or_settling():
    assert settle_time(still_log()) is None
    assert settle_time(with_push(still_log(), time=3.95)) is None
    log = with_push(still_log())
    log.q_true[-1, 0] += 0.011
    s = summarise(log)
    assert s["settle_time_s"] is None and not s["settled"]


def test_settled_requires_small_offset_tilt_and_speed():
    log = still_log()
    log.q_true[10, 0] += 0.009
    log.q_true[20, 0] += 0.011
    log.q_true[30] = turn_base(log.q_true[30], 0, 1.9)
    log.q_true[40] = turn_base(log.q_true[40], 0, 2.1)
    log.v_true[50, 1] = 0.049
    log.v_true[60, 1] = 0.051
    assert np.flatnonzero(~settled_ticks(log)).tolist() == [20, 40, 60]


def test_fallen_robot_is_not_settled():
    s = summarise(with_push(still_log(fell=True)))
    assert s["fell"] and not s["settled"] and s["settle_time_s"] is None
    assert s["fall_time_s"] == pytest.approx(TICKS / RATE)


def test_peak_torque_and_power_are_maxima():
    log = still_log()
    log.tau[100, 2], log.dq[100, 2] = -0.5 * ROBOT.config.tau_max[2], 2.0
    log.tau[100, 3], log.dq[100, 3] = 1.0, 3.0
    s = summarise(log)
    assert s["peak_torque_ratio"] == pytest.approx(0.5)
    assert s["peak_power_w"] == pytest.approx(ROBOT.config.tau_max[2] + 3.0, rel=1e-5)


def test_estimator_metrics_ignore_yaw():
    log = still_log()
    log.v_estimated[:, :3] = [0.03, 0.0, 0.04]
    roll, yaw = (pinocchio.rpy.rpyToMatrix(*rpy) for rpy in ((0.1, 0.0, 0.0), (0.0, 0.0, 0.7)))
    log.q_true[:, 3:7] = pinocchio.Quaternion(roll).coeffs()
    log.q_estimated[:, 3:7] = pinocchio.Quaternion(yaw @ roll).coeffs()
    s = summarise(log)
    assert s["estimator_velocity_rmse"] == pytest.approx(0.05)
    assert s["estimator_tilt_rmse_deg"] == pytest.approx(0.0, abs=1e-6)
    log.q_true[:] = turn_base(log.q_true[0], 1, 0.0)
    log.q_estimated[:] = turn_base(log.q_estimated[0], 1, 0.01)
    assert summarise(log)["estimator_tilt_rmse_deg"] == pytest.approx(0.01, rel=1e-4)


def test_saturated_ticks_are_counted_separately():
    log = still_log()
    log.status[[7, 8, 9]] = Status.SATURATED.value
    s = summarise(log)
    assert (s["saturated_ticks"], s["qp_failures"], s["first_failure"]) == (3, 0, None)


def test_cold_solves_are_counted_separately():
    log = still_log()
    log.fallback_level[[3, 4]] = FallbackLevel.COLD_SOLVE.value
    log.fallback_level[5], log.status[5] = FallbackLevel.FORCES.value, Status.MAX_ITERATIONS.value
    s = summarise(log)
    assert (s["cold_solves"], s["qp_failures"]) == (2, 1)


def test_failed_ticks_are_counted_and_the_first_status_is_named():
    log = still_log()
    log.status[[5, 9]] = Status.MAX_ITERATIONS.value, Status.DAMPING.value
    log.torque_mode[9] = False
    s = summarise(log)
    assert (s["qp_failures"], s["first_failure"]) == (2, "MAX_ITERATIONS")
    assert s["torque_mode_only"] is False


def test_tick_times_are_percentiles():
    ticks = summarise(still_log())["tick_us"]
    assert ticks == pytest.approx({"p50": 50.0, "p90": 90.0, "p99": 99.0, "max": 100.0})


def test_every_metric_is_documented_once():
    names = [field.name for field in FIELDS]
    assert names == sorted(set(names), key=names.index)
    assert set(names) == set(summarise(still_log()))
    assert all(field.meaning and field.group for field in FIELDS)


def test_non_finite_metrics_become_null():
    log = still_log()
    log.v_estimated[3, 0] = math.nan
    s = summarise(log)
    assert s["estimator_velocity_rmse"] is None
    assert "NaN" not in json.dumps(s, allow_nan=False)
    assert json_value({"a": [np.float64(math.inf), np.int32(3), np.bool_(True)]}) == {
        "a": [None, 3, True]
    }


@pytest.mark.parametrize("field", ["mode", "q", "dq", "Kp", "Kd"])
@pytest.mark.parametrize("motor", [0, 11])
def test_any_other_motor_field_ends_torque_mode(field, motor):
    command = LowCmd()
    command.motorCmd[motor].tau = 3.0
    assert is_torque_mode(command)
    setattr(command.motorCmd[motor], field, 1)
    assert not is_torque_mode(command)


def test_damping_is_not_torque_mode():
    assert not is_torque_mode(surefoot.damping_low_cmd(3.0))


@pytest.mark.parametrize("damping", [0.0, 1.0])
def test_simulated_run_fills_every_row_and_reports_its_command_mode(damping):
    plant = PlantSettings(control_rate=250.0, seed=2)
    push = parse_push("lateral:10%:0.1@0.2")
    log = run_stand(StandSettings("go1", 0.5, plant=plant, pushes=(push,), motor_damping=damping))
    s = summarise(log)
    assert (s["ticks"], s["fell"], s["qp_failures"]) == (125, False, 0)
    assert s["torque_mode_only"] is (damping == 0.0)
    assert s["pushes"][0]["lip_share"] == pytest.approx(0.1)
    np.testing.assert_allclose(np.diff(log.time), 1 / 250.0)
    weight = log.forces[:, 2].sum(axis=1).mean()
    assert weight == pytest.approx(9.81 * ROBOT.mass, rel=0.03)


def test_summary_reports_the_height_of_each_push():
    low, high = Push("lateral", 5.0, 0.1, 1.0), Push("forward", 5.0, 0.1, 1.0, height=0.07)
    s = summarise(still_log(pushes=(low, high), push_shares=(0.4, 0.3)))
    assert [push["height_m"] for push in s["pushes"]] == [0.0, 0.07]
    assert "centre of mass" not in push_line(s["pushes"][0])
    assert "+0.07 m" in push_line(s["pushes"][1])


def test_a_run_ends_when_the_robot_falls():
    push = parse_push("lateral:1000%:0.1@0.1")
    log = run_stand(StandSettings("go1", 3.0, plant=PlantSettings("ideal"), pushes=(push,)))
    assert log.fell and log.time[-1] < 2.0
    assert len(log.commands) == len(log.tau) == len(log.time)
