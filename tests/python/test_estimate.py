# SPDX-License-Identifier: BSD-3-Clause
"""The estimator on recorded logs: inputs, results and refused logs."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from estimate_helpers import DEG_PER_RAD, moving_log, reorder_legs, robot, small_csv, with_columns
from surefoot import Error, Gains, LowState, StateEstimator, Status
from surefoot.cli import main
from surefoot.estimate import (
    FIELDS,
    read_log,
    run_estimator,
    summarise,
    write_log,
    write_report,
    write_trajectory,
)
from surefoot.estimate.checks import check_log
from surefoot.estimate.joint_velocities import CUTOFF_HZ, HOLD_TIME, derive_velocities
from surefoot.estimate.low_states import low_state_blocks
from surefoot.stand import SensorRecorder, StandSettings, run_stand


@pytest.fixture(scope="module")
def estimate():
    return run_estimator(robot(), moving_log())


def test_estimator_receives_each_log_row_as_a_low_state(estimate) -> None:
    log = moving_log()
    alone, steps = StateEstimator(robot()), np.diff(log.time, prepend=log.time[0] - log.period)
    for k, row in enumerate(np.concatenate(list(low_state_blocks(log, log.sensor("dq"))))):
        assert alone.update(LowState.from_bytes(row.tobytes()), steps[k]) == Status.OK
        for name in ("q", "v", "contact"):
            one = getattr(alone.state, name)
            np.testing.assert_allclose(getattr(estimate, name)[k], one, rtol=0, atol=1e-12)
    assert estimate.payload[-1] == pytest.approx(alone.report.payload, abs=1e-9)


def test_truth_never_reaches_the_estimator(estimate) -> None:
    names = [name for name in moving_log().columns if name.startswith("truth_")]
    assert len(names) == 6
    blind = run_estimator(robot(), with_columns(**dict.fromkeys(names)))
    np.testing.assert_array_equal(blind.q, estimate.q)
    summary = summarise(blind)
    assert summary["velocity_rmse"] is summary["contact_delays"] is None


def test_a_summary_has_every_field_and_is_near_the_truth(estimate) -> None:
    summary = summarise(estimate)
    assert list(summary) == [field.name for field in FIELDS]
    json.dumps(summary, allow_nan=False)
    assert summary["statuses"] == {"OK": moving_log().rows}
    assert summary["rate"] == pytest.approx(500.0) and summary["clock"] == "tick"
    assert 0.0 < summary["velocity_rmse"] < 0.05
    assert max(summary["roll_pitch_rmse_deg"]) < 1.0
    low, high = summary["height_error_range"]
    assert -0.01 < low <= 0.0 <= high < 0.01
    assert list(summary["verdicts"])[:4] == [
        *("gyroscope", "accelerometer", "quaternion", "footForceEst[FR]")
    ]
    assert len(summary["verdicts"]) == 15
    for verdict in summary["verdicts"].values():
        assert sum(verdict["share"].values()) == pytest.approx(1.0, abs=1e-4)


def test_contact_transitions_are_reported_and_compared_with_truth(estimate) -> None:
    contact, truth = np.ones_like(estimate.contact), np.ones((moving_log().rows, 4))
    truth[100:200, 1] = 0.0
    contact[105:203, 1] = 0.0
    contact[400:, 2] = 0.2
    made = replace(estimate, log=with_columns(truth_contact=truth), contact=contact)
    summary = summarise(made)
    assert summary["contact_transitions"] == [
        {"time": 0.21, "foot": "FL", "contact": False},
        {"time": 0.406, "foot": "FL", "contact": True},
        {"time": 0.8, "foot": "RR", "contact": False},
    ]
    assert summary["contact"]["RR"]["share"] == pytest.approx(0.5)
    assert summary["contact_delays"]["FL"] == {
        **{"true": 2, "missed": 0, "false": 0},
        **{"mean_s": pytest.approx(0.008), "max_s": pytest.approx(0.01)},
    }
    assert summary["contact_delays"]["RR"]["false"] == 1


def test_slip_events_have_start_and_duration(estimate) -> None:
    slip = np.zeros_like(estimate.slip)
    slip[50:150, 3] = 0.9
    slip[700:, 0] = 0.9
    assert summarise(replace(estimate, slip=slip))["slip_events"] == [
        {"time": 0.1, "foot": "RL", "duration_s": 0.2},
        {"time": 1.4, "foot": "FR", "duration_s": pytest.approx(0.198)},
    ]


def test_non_finite_rows_are_refused_and_their_time_is_kept(estimate) -> None:
    gyroscope, force = (moving_log().sensor(n).copy() for n in ("gyroscope", "footForce"))
    gyroscope[300:303, 1] = math.nan
    force[500, 0] = math.inf
    made = run_estimator(robot(), with_columns(gyroscope=gyroscope, footForce=force))
    summary = summarise(made)
    assert summary["non_finite_rows"] == {"gyroscope": 3, "footForce": 1}
    assert summary["statuses"] == {"OK": moving_log().rows - 4, "NON_FINITE": 4}
    np.testing.assert_array_equal(made.q[302], made.q[299])
    np.testing.assert_allclose(made.q[-1], estimate.q[-1], atol=2e-3)


def test_repeated_rows_are_skipped_and_gaps_are_reported(estimate) -> None:
    columns = {name: np.repeat(v, 2, axis=0) for name, v in moving_log().columns.items()}
    twice = run_estimator(robot(), with_columns(**columns))
    np.testing.assert_array_equal(twice.q, estimate.q)
    assert summarise(twice)["duplicate_rows"] == moving_log().rows
    tick = moving_log().columns["tick"].copy()
    tick[600:] += 500.0
    summary = summarise(run_estimator(robot(), with_columns(tick=tick)))
    assert (summary["gaps"], summary["longest_gap_s"]) == (1, pytest.approx(0.502))
    assert summary["statuses"] == {"OK": moving_log().rows}


def test_missing_columns_are_zero_and_named() -> None:
    log = with_columns(quaternion=None, tauEst=None, footForce=None, footForceEst=None)
    frame = next(low_state_blocks(log, log.sensor("dq")))[7]
    state = LowState.from_bytes(frame.tobytes())
    assert not np.any(state.imu.quaternion) and not np.any(state.footForceEst)
    assert state.motorState[3].q == np.float32(log.columns["q"][7, 3])
    summary = summarise(run_estimator(robot(), log))
    assert summary["columns_missing"] == ["quaternion", "tauEst", "footForce", "footForceEst"]
    assert set(summary["statuses"]) <= {"OK", "BAD_QUATERNION"}


def test_missing_velocities_are_derived_and_reported(estimate) -> None:
    made = run_estimator(robot(), with_columns(dq=None))
    assert f"{CUTOFF_HZ:g} Hz" in summarise(made)["columns_derived"]["dq"]
    assert np.sqrt(np.mean((made.v[:, 6:] - estimate.v[:, 6:]) ** 2)) < 0.1
    assert summarise(made)["velocity_rmse"] < 0.05


def test_derived_velocities_are_causal_and_accurate() -> None:
    rng = np.random.default_rng(3)
    time = np.cumsum(rng.uniform(0.001, 0.003, 1000))
    q = np.repeat(np.sin(6.0 * time)[:, None], 12, axis=1)
    dq = derive_velocities(time, q)
    late = 6.0 * np.cos(6.0 * (time - 1.0 / (2.0 * math.pi * CUTOFF_HZ)))
    assert np.abs(dq[100:, 0] - late[100:]).max() < 0.15
    spoiled = q.copy()
    spoiled[500:] = 7.0
    np.testing.assert_array_equal(derive_velocities(time, spoiled)[:500], dq[:500])


def test_repeated_angles_hold_the_derived_velocity_then_decay_to_zero() -> None:
    time = 0.001 * np.arange(400)
    angle = 2.0 * np.floor(time / 0.004) * 0.004  # the encoders sample at a quarter of the log rate
    angle[200:] = angle[200]
    angle[50] = math.nan
    dq = derive_velocities(time, np.repeat(angle[:, None], 12, axis=1))[:, 0]
    np.testing.assert_allclose(dq[100:200], 2.0, rtol=1e-3)
    assert dq[200 + round(1000 * HOLD_TIME) - 4] > 1.9 and abs(dq[-1]) < 0.01
    assert np.isfinite(dq).all()


S = np.tile([-1.0, 1.0, 1.0], 4)
CONTRADICTIONS = {
    "angles in degrees": (lambda c: {"q": c["q"] * DEG_PER_RAD}, "'q'", "in degrees"),
    "velocities in degrees": (lambda c: {"dq": c["dq"] * DEG_PER_RAD}, "'dq'", "deg/s"),
    "velocities of the other sign": (lambda c: {"dq": -c["dq"]}, "'dq'", "expected the same sign"),
    "gyroscope in degrees": (
        lambda c: {"gyroscope": c["gyroscope"] * DEG_PER_RAD},
        *("'gyroscope'", "deg/s"),
    ),
    "gyroscope in degrees, no quaternion": (
        lambda c: {"gyroscope": c["gyroscope"] * DEG_PER_RAD, "quaternion": None},
        *("'gyroscope'", "deg/s"),
    ),
    "accelerometer in g": (
        lambda c: {"accelerometer": c["accelerometer"] / 9.81},
        *("'accelerometer'", "in g"),
    ),
    "quaternion x y z w": (
        lambda c: {"quaternion": np.roll(c["quaternion"], -1, axis=1)},
        *("'quaternion'", "x y z w"),
    ),
    "quaternion inverted": (
        lambda c: {"quaternion": c["quaternion"] * [1.0, -1.0, -1.0, -1.0]},
        *("'quaternion'", "world to IMU"),
    ),
    "left and right exchanged": (
        lambda c: {n: reorder_legs([1, 0, 3, 2], c[n]) for n in ("q", "dq")},
        *("'q'", "FL FR RL RR"),
    ),
    "front and rear exchanged": (
        lambda c: {n: reorder_legs([2, 3, 0, 1], c[n]) for n in ("q", "dq")},
        *("'q'", "RR RL FR FL"),
    ),
    "hips mirrored": (lambda c: {"q": S * c["q"], "dq": S * c["dq"]}, "'q'", "all hips mirrored"),
    "feet at the places of other feet": (
        lambda c: {"q": c["q"] + np.tile([0.8, 0.0, 0.0, -0.8, 0.0, 0.0], 2), "dq": None},
        *("'q'", "foot FR at x ="),
    ),
    "joints by kind": (
        lambda c: {"q": c["q"].reshape(-1, 4, 3).swapaxes(1, 2).reshape(-1, 12), "dq": None},
        *("'q_", "order FR FL RR RL"),
    ),
    "velocities of exchanged legs": (
        lambda c: {"dq": reorder_legs([1, 0, 2, 3], c["dq"])},
        *("'dq'", "FL FR RR RL"),
    ),
    "accelerometer of the other sign": (
        lambda c: {"accelerometer": -c["accelerometer"]},
        *("'accelerometer'", "upwards at rest"),
    ),
    "torques of the other sign": (
        lambda c: {"tauEst": -c["tauEst"]},
        *("'tauEst'", "expected the same sign"),
    ),
}


@pytest.mark.parametrize(
    ("change", "column", "word"), CONTRADICTIONS.values(), ids=CONTRADICTIONS.keys()
)
def test_inconsistent_log_is_refused(change, column, word) -> None:
    with pytest.raises(Error) as refused:
        run_estimator(robot(), with_columns(**change(moving_log().columns)))
    for text in (column, word, "got", "expected"):
        assert text in str(refused.value)


def test_valid_log_has_no_warnings(estimate) -> None:
    assert estimate.warnings == ()


def test_tilted_rest_reveals_the_quaternion_order() -> None:
    rows, half = 600, math.radians(15.0)
    tilted = np.tile([math.cos(half), math.sin(half), 0.0, 0.0], (rows, 1))
    felt = np.tile(9.81 * np.array([0.0, math.sin(2 * half), math.cos(2 * half)]), (rows, 1))
    still = {n: np.tile(v[0], (rows, 1)) for n, v in moving_log().columns.items() if n != "tick"}
    still |= {"tick": 2.0 * np.arange(rows)[:, None], "gyroscope": np.zeros((rows, 3))}
    log = with_columns(**{**still, "accelerometer": felt, "quaternion": tilted, "dq": None})
    assert check_log(robot(), log) == []
    with pytest.raises(Error, match=r"vertical 30 deg.*x y z w"):
        check_log(robot(), with_columns(log, quaternion=np.roll(tilted, -1, axis=1)))


def test_ambiguous_inconsistencies_are_warnings() -> None:
    columns = moving_log().columns
    torques = columns["tauEst"] * np.where(np.arange(12) == 5, -1.0, 1.0)
    assert "tauEst of FL" in check_log(robot(), with_columns(tauEst=torques))[0]
    heavy = check_log(robot(), with_columns(accelerometer=2.0 * columns["accelerometer"]))
    assert "median size of 19.6" in heavy[0]
    down = with_columns(accelerometer=-columns["accelerometer"], quaternion=None)
    assert "lies on its back" in check_log(robot(), down)[0]
    lone = reorder_legs([1, 0, 3, 2], columns["q"])
    doubts = check_log(robot(), with_columns(q=lone, dq=None, tauEst=None))
    assert "or do they hang?" in doubts[0]


def test_gains_reach_the_estimator() -> None:
    wrong = Gains()
    wrong.com_kp_vertical = -1.0
    with pytest.raises(Error, match="com_kp_vertical"):
        run_estimator(robot(), moving_log(), wrong)


@pytest.mark.parametrize("suffix", ["csv", "npz"])
def test_trajectory_is_written_as_csv_and_npz(estimate, tmp_path, suffix) -> None:
    path = tmp_path / f"way.{suffix}"
    write_trajectory(path, estimate)
    if suffix == "npz":
        way = np.load(path)
        np.testing.assert_array_equal(way["p"], estimate.q[:, :3])
        assert set(way["status"]) == {"OK"}
    else:
        way = np.genfromtxt(path, delimiter=",", names=True, dtype=None, encoding="utf-8")
        np.testing.assert_array_equal(way["p_2"], estimate.q[:, 2])
        np.testing.assert_array_equal(way["contact_3"], estimate.contact[:, 3])


def test_estimate_report_folder_contains_all_files_of_its_page(estimate, tmp_path) -> None:
    summary = summarise(estimate)
    page = write_report(estimate, summary, tmp_path / "new", ["surefoot", "estimate", "a b.csv"])
    text = page.read_text()
    for file in re.findall(r'(?:src|href)="([^"]+)"', text):
        assert (page.parent / file).stat().st_size > 0
    assert text.count("<img") == 8 and "&#x27;a b.csv&#x27;" in text
    assert all(f"<code>{name}</code>" in text for name in summary)
    assert json.loads((page.parent / "summary.json").read_text()) == summary


def test_report_is_written_when_all_rows_are_refused(tmp_path) -> None:
    gyroscope = moving_log().sensor("gyroscope").copy()
    gyroscope[:, 0] = 1e5 * np.sign(gyroscope[:, 0])
    log = with_columns(gyroscope=gyroscope)
    with pytest.raises(Error, match="deg/s"):
        run_estimator(robot(), log)
    spoiled = with_columns(tauEst=np.where(np.arange(12) == 4, 1e5, moving_log().sensor("tauEst")))
    made = run_estimator(robot(), spoiled)
    summary = summarise(made)
    assert summary["position"] == [None] * 3 and "accepted no row" in summary["warnings"][-1]
    assert write_report(made, summary, tmp_path).exists()


def test_estimate_command_writes_json_trajectory_and_report(tmp_path, capsys, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    write_log("log.csv", moving_log())
    words = "estimate log.csv --robot go1 --json out.json --trajectory way.npz --report page"
    assert main(words.split()) == 0
    out, err = capsys.readouterr()
    assert out.startswith("go1: 800 of 800 rows estimated over 1.6 s.") and err == ""
    assert json.loads((tmp_path / "out.json").read_text())["file"] == "log.csv"
    assert (tmp_path / "way.npz").exists() and (tmp_path / "page" / "index.html").exists()
    assert main(["estimate", "log.csv", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["rows"] == read_log("log.csv").rows


BAD = {
    "no log": "estimate",
    "missing log": "estimate nowhere.csv",
    "log with an unknown suffix": "estimate log.txt",
    "unknown robot": "estimate small.csv --robot go7",
    "json in a missing folder": "estimate small.csv --json no/such/out.json",
    "trajectory with an unknown suffix": "estimate small.csv --trajectory way.txt",
    "trajectory in a missing folder": "estimate small.csv --trajectory no/such/way.csv",
    "report under a file": "estimate small.csv --report small.csv/page",
    "missing gains": "estimate small.csv --gains nowhere.toml",
    "stand log with an unknown suffix": "stand --duration 0.1 --log out.txt",
    "stand log in a missing folder": "stand --duration 0.1 --log no/such/out.csv",
}


@pytest.mark.parametrize("words", BAD.values(), ids=BAD.keys())
def test_invalid_estimate_argument_gives_one_error_line_and_status_2(
    words, tmp_path, capsys, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    small_csv(tmp_path / "small.csv")
    assert main(words.split()) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.count("\n") == 1 and err.startswith("surefoot")


def test_write_failure_exits_with_status_1(tmp_path, capsys) -> None:
    write_log(tmp_path / "log.npz", moving_log())
    (tmp_path / "page").mkdir()
    (tmp_path / "page" / "summary.json").mkdir()
    words = ["estimate", str(tmp_path / "log.npz"), "--report", str(tmp_path / "page")]
    assert main(words) == 1
    assert capsys.readouterr().err.count("\n") == 1


def test_help_names_every_column_and_the_exit_status(capsys) -> None:
    assert main(["estimate", "--help"]) == 0
    text = capsys.readouterr().out
    for word in ("*gyroscope (3)", "truth_foot_forces (12)", "v_world_std", "exit status"):
        assert word in text


def test_velocities_in_degrees_at_standstill_cause_a_warning() -> None:
    recorder = SensorRecorder()
    run_stand(StandSettings(duration=1.5), sensors=recorder)
    still = recorder.log("still")
    assert not [doubt for doubt in check_log(robot(), still) if doubt.startswith("dq")]
    doubts = check_log(robot(), with_columns(still, dq=DEG_PER_RAD * still.columns["dq"]))
    assert [doubt for doubt in doubts if doubt.startswith("dq moves joints") and "deg/s" in doubt]
