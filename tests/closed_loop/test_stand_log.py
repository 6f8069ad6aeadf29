# SPDX-License-Identifier: BSD-3-Clause
"""surefoot stand --log: the controller's samples, and the truth at the same times."""

from __future__ import annotations

import numpy as np
import pytest
import surefoot
from surefoot.cli import main
from surefoot.estimate import read_log, run_estimator, summarise
from surefoot.sim import PlantSettings
from surefoot.stand import SensorRecorder, StandSettings, parse_push, run_stand

PUSH = parse_push("lateral:30%:0.1@0.2")


def run(sensors: str):
    recorder = SensorRecorder()
    plant = PlantSettings(sensors=sensors, seed=2)
    log = run_stand(StandSettings(duration=0.6, plant=plant, pushes=(PUSH,)), sensors=recorder)
    return log, recorder.log()


@pytest.mark.parametrize(("sensors", "age"), [("real", 1), ("ideal", 0)])
def test_truth_has_the_time_of_its_sample(sensors, age) -> None:
    log, recorded = run(sensors)
    assert recorded.rows == len(log.time)
    columns, n = recorded.columns, recorded.rows
    # Row k has the time of the controller's tick; its sample is `age` periods older.
    np.testing.assert_array_equal(columns["truth_p"][age:], log.q_true[: n - age, :3])
    np.testing.assert_array_equal(columns["truth_com"][age:], log.com[: n - age])
    forces = log.forces.transpose(0, 2, 1).reshape(-1, 12)
    np.testing.assert_array_equal(columns["truth_foot_forces"][age:], forces[: n - age])
    # Encoders agree with the true joint angles of these rows and of no other rows.
    motors = list(log.robot.motor_to_q)
    true = log.q_true[:, motors]
    errors = [np.abs(columns["q"][shift:] - true[: n - shift]).max() for shift in range(3)]
    assert int(np.argmin(errors)) == age and errors[age] < 5e-5


def test_first_sample_has_its_own_truth() -> None:
    log, recorded = run("real")
    first = recorded.columns["truth_p"][0]
    assert 0.0 < np.linalg.norm(first - log.q_true[0, :3]) < 1e-4


def test_true_velocities_are_the_derivative_of_true_positions() -> None:
    recorded = run("real")[1]
    p, v = recorded.columns["truth_p"], recorded.columns["truth_v"]
    slope = (p[2:] - p[:-2]) / 0.004
    assert np.abs(slope - v[1:-1]).max() < 0.03 < np.abs(v).max()


@pytest.mark.parametrize("suffix", ["csv", "npz"])
def test_stand_command_writes_a_log_for_estimate(tmp_path, capsys, suffix) -> None:
    path = tmp_path / f"log.{suffix}"
    words = ["stand", "--duration", "0.6", "--push", str(PUSH), "--seed", "2", "--log", str(path)]
    assert main(words) == 0
    estimate = run_estimator(surefoot.load_robot("go1"), read_log(path))
    log = run("real")[0]
    # The controller also gives its estimator the planned motion, so both differ slightly.
    np.testing.assert_allclose(estimate.q[:, 3:7], log.q_estimated[:, 3:7], atol=5e-3)
    assert np.abs(estimate.v_world - read_log(path).columns["truth_v"]).max() < 0.1
    assert summarise(estimate)["velocity_rmse"] < 0.03


def test_log_of_a_fall_ends_at_the_fall() -> None:
    recorder = SensorRecorder()
    push = parse_push("lateral:1000%:0.1@0.1")
    log = run_stand(
        StandSettings(duration=1.0, pushes=(push,)),
        sensors=recorder,
    )
    assert log.fell and recorder.log().rows == len(log.time)
