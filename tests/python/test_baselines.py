# SPDX-License-Identifier: BSD-3-Clause
"""Baselines beside the estimator: on motions in closed form, and in the command."""

from __future__ import annotations

import json
import sys
from dataclasses import replace

import numpy as np
import pytest
from estimate_helpers import moving_log, robot
from surefoot.cli import main
from surefoot.estimate import run_estimator, summarise, with_baselines, write_log
from surefoot.estimate.baselines import LEG_ODOMETRY, LINEAR_FILTER, BaselineInputs
from surefoot.estimate.baselines.leg_odometry import leg_odometry
from surefoot.estimate.baselines.linear_filter import linear_filter
from surefoot.estimate.baselines.stance_trust import stance_trust
from surefoot.estimate.baselines.vqf_attitude import vqf_attitude
from surefoot.estimate.foot_motion import FootMotion, foot_motion
from surefoot.estimate.strides import stride_summary
from surefoot.geometry.batch_rotations import rotations_about_z, tilt_between

PERIOD, GRAVITY = 0.002, 9.81  # [s], [m/s^2]
STRIDE, DUTY = 0.4, 0.5  # [s]
HIPS = np.array([[0.2, -0.1, 0.0], [0.2, 0.1, 0.0], [-0.2, -0.1, 0.0], [-0.2, 0.1, 0.0]])


def trot(duration: float, roll_rate: float):
    """Return inputs, rotation, feet and true position of a trot at 0.5 m/s with heading 30 deg.

    In stance, the foot turns at roll_rate [rad/s] about the base's y axis and rolls.
    """
    time = PERIOD * np.arange(round(duration / PERIOD))
    n, radius = len(time), robot().config.foot_radius
    position = np.stack([0.5 * time, 0.1 * np.sin(3.0 * time), 0.0 * time + 0.3], axis=1)
    velocity = np.stack([0.5 + 0.0 * time, 0.3 * np.cos(3.0 * time), 0.0 * time], axis=1)
    force = np.stack([0.0 * time, -0.9 * np.sin(3.0 * time), GRAVITY + 0.0 * time], axis=1)
    rotation = rotations_about_z(np.full(n, np.pi / 6))
    phase = (time[:, None] / STRIDE + np.array([0.0, 0.5, 0.5, 0.0])) % 1.0
    contact = phase < DUTY
    omega = np.where(contact[:, :, None], [0.0, roll_rate, 0.0], 0.0)
    rolling = np.einsum("nij,nfj->nfi", rotation, np.cross(omega, [0.0, 0.0, radius]))
    place = position[:, None] + HIPS @ rotation[0].T
    place[:, :, 2] = radius
    for foot in range(4):
        for k in range(1, n):
            if contact[k, foot]:
                place[k, foot] = place[k - 1, foot] + PERIOD * rolling[k, foot]
    foot_velocity = np.where(contact[:, :, None], rolling, 3.0)
    centre = np.einsum("nji,nfj->nfi", rotation, place - position[:, None])
    relative = np.einsum("nji,nfj->nfi", rotation, foot_velocity - velocity[:, None])
    accelerometer = np.einsum("nji,nj->ni", rotation, force)
    zeros = np.zeros((n, 12))
    inputs = BaselineInputs(robot(), time, np.zeros((n, 3)), accelerometer, zeros, zeros, contact)
    return inputs, rotation, FootMotion(centre, relative, omega), position


def motion_of_trot(baseline, seconds: float, roll_rate: float):
    """Return the motion that a baseline estimates of a trot, and the true position."""
    inputs, rotation, feet, position = trot(seconds, roll_rate)
    return baseline(inputs, rotation, feet, stance_trust(inputs.time, inputs.contact)), position


@pytest.mark.parametrize("roll_rate", [0.0, 2.0])
def test_linear_filter_follows_a_trot_on_fixed_or_rolling_feet(roll_rate) -> None:
    motion, position = motion_of_trot(linear_filter, 4.0, roll_rate)
    moved = motion.position[-1] - motion.position[500]
    assert moved == pytest.approx(position[-1] - position[500], abs=0.03 * 0.5 * 3.0)
    assert np.abs(motion.velocity[500:, 0] - 0.5).max() < 0.05
    assert motion.position[500:, 2] == pytest.approx(0.3, abs=2e-3)


@pytest.mark.parametrize("roll_rate", [0.0, 2.0])
def test_leg_odometry_integrates_the_velocity_of_the_stance_feet(roll_rate) -> None:
    motion, position = motion_of_trot(leg_odometry, 2.0, roll_rate)
    moved = motion.position[-1] - motion.position[0]
    assert moved == pytest.approx(position[-1] - position[0], abs=2e-3)


def test_vqf_attitude_follows_tilt_and_turn() -> None:
    time = PERIOD * np.arange(4000)
    roll, rate = 0.2 * np.sin(4.0 * time), 0.8 * np.cos(4.0 * time)
    c, s, o = np.cos(roll), np.sin(roll), np.zeros_like(roll)
    about_x = np.moveaxis(np.array([[o + 1.0, o, o], [o, c, -s], [o, s, c]]), 2, 0)
    true = rotations_about_z(0.5 * time) @ about_x
    gyroscope = np.stack([rate, 0.5 * s, 0.5 * c], axis=1)
    accelerometer = GRAVITY * true[:, 2]
    unused = np.zeros((len(time), 12))
    inputs = BaselineInputs(
        robot(), time, gyroscope, accelerometer, unused, unused, np.ones((len(time), 4), bool)
    )
    rotation = vqf_attitude(inputs)
    assert np.degrees(tilt_between(rotation, true)).max() < 0.5
    yaw = np.unwrap(np.arctan2(rotation[:, 1, 0], rotation[:, 0, 0]))
    assert yaw[-1] - yaw[0] == pytest.approx(0.5 * time[-1], abs=0.02)


def test_trust_rises_and_falls_over_a_fifth_of_a_stance() -> None:
    time = PERIOD * np.arange(1000)
    contact = np.zeros((1000, 4), bool)
    contact[100:200] = contact[300:400] = contact[500:600] = contact[800:] = True
    contact[310:320, 1] = False  # a bounce
    trust = stance_trust(time, contact)
    assert trust[[99, 100, 110, 150, 189, 199, 200], 0] == pytest.approx(
        [0.0, 0.0, 0.505, 1.0, 0.505, 0.0, 0.0], abs=0.01
    )
    assert trust[-1, 0] == 1.0  # the robot still stands when the log ends
    np.testing.assert_array_equal(trust[:, 1], trust[:, 0])


def test_foot_velocity_is_the_derivative_of_the_foot_position() -> None:
    log = moving_log()
    q = np.array([0.1, 0.8, -1.6] * 4) + 1e-6 * np.arange(3)[:, None]
    feet = foot_motion(robot(), q, np.full((3, 12), 1.0))
    slope = (feet.centre[2] - feet.centre[0]) / 2e-6
    assert feet.velocity[1] == pytest.approx(slope, abs=1e-5)
    standing = foot_motion(robot(), log.columns["q"][:1], log.columns["dq"][:1]).centre[0]
    assert np.all(np.sign(standing[:, :2]) == [[1, -1], [1, 1], [-1, -1], [-1, 1]])


@pytest.fixture(scope="module")
def estimate():
    return with_baselines(run_estimator(robot(), moving_log()))


def test_strides_have_time_duty_and_length(estimate) -> None:
    phase = (estimate.time[:, None] / STRIDE + np.array([0.0, 0.5, 0.5, 0.0])) % 1.0
    stepping = replace(estimate, contact=(phase < 0.6).astype(float))
    strides = stride_summary(stepping)
    assert strides["FL"]["strides"] == 2
    for foot in strides.values():
        assert foot["stride_time_s"] == pytest.approx(STRIDE, abs=PERIOD)
        assert foot["duty"] == pytest.approx(0.6, abs=0.01)
        assert foot["step_length_m"] < 0.01  # the robot of the log moves over standing feet
    assert stride_summary(estimate)["FR"] == {
        **dict.fromkeys(("stride_time_s", "duty", "step_length_m")),
        "strides": 0,
    }


def test_baselines_of_a_standing_robot_agree_with_the_estimator(estimate) -> None:
    figures = summarise(estimate)["baselines"]
    assert list(figures) == ["surefoot", LINEAR_FILTER, LEG_ODOMETRY]
    for figure in figures.values():
        assert figure["velocity_difference"] < 0.05 and figure["tilt_difference_deg"] < 1.5
        assert figure["velocity_error"] < 0.05 and abs(figure["height_drift"]) < 0.01
    start = np.flatnonzero(estimate.valid)[0]
    for motion in estimate.baselines.values():
        assert motion.position[start] == pytest.approx(estimate.q[start, :3])


def test_command_runs_the_baselines_and_names_the_missing_package(
    tmp_path, capsys, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    write_log("log.npz", moving_log())
    words = ["estimate", "log.npz", "--baseline", "--json", "out.json", "--report", "page"]
    assert main(words) == 0
    assert "linear kalman filter: closure" in capsys.readouterr().out
    assert set(json.loads((tmp_path / "out.json").read_text())["baselines"]) > {LINEAR_FILTER}
    assert "linear_kalman_filter" in (tmp_path / "page" / "index.html").read_text()
    monkeypatch.setitem(sys.modules, "vqf", None)
    assert main(words) == 2
    assert "pip install 'surefoot[baselines]'" in capsys.readouterr().err
    assert main(["estimate", "log.npz", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["baselines"] is None
