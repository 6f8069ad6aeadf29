# SPDX-License-Identifier: BSD-3-Clause
"""Logs of robots at rest: what torques and gravity alone show to be wrong."""

from __future__ import annotations

import functools

import numpy as np
import pytest
import surefoot
from estimate_helpers import reorder_legs, with_columns
from surefoot import Error
from surefoot.estimate import run_estimator, summarise
from surefoot.estimate.checks import check_log
from surefoot.stand import SensorRecorder, StandSettings, run_stand

ROBOTS = ("a1", "b1", "go1", "go2")
LEFT_RIGHT = [1, 0, 3, 2]


@functools.cache
def robot(name):
    return surefoot.load_robot(name)


@functools.cache
def quiet_log(name):
    recorder = SensorRecorder()
    run_stand(StandSettings(robot=name, duration=1.2), sensors=recorder)
    return recorder.log(name)


def exchanged(name, order, *columns):
    log = quiet_log(name)
    return with_columns(log, **{n: reorder_legs(order, log.columns[n]) for n in columns})


@pytest.mark.parametrize("name", ROBOTS)
def test_quiet_log_with_exchanged_sides_is_refused_by_its_hip_torques(name) -> None:
    assert check_log(robot(name), quiet_log(name)) == []
    words = r"'q' and 'tauEst': got hip torques of FR, FL, RR, RL with -\d"
    with pytest.raises(Error, match=words):
        check_log(robot(name), exchanged(name, LEFT_RIGHT, "q", "dq", "tauEst"))
    with pytest.raises(Error, match=words):
        check_log(robot(name), exchanged(name, LEFT_RIGHT, "tauEst"))


@pytest.mark.parametrize(
    ("order", "legs"),
    [([1, 0, 2, 3], "FR, FL"), ([0, 1, 3, 2], "RR, RL"), ([1, 3, 2, 0], "FR, RL")],
)
def test_exchanged_legs_are_named(order, legs) -> None:
    with pytest.raises(Error, match=f"hip torques of {legs} with"):
        check_log(robot("go1"), exchanged("go1", order, "q", "dq", "tauEst"))


def test_one_hip_of_the_wrong_sign_is_a_doubt() -> None:
    torques = quiet_log("go1").columns["tauEst"] * np.where(np.arange(12) == 3, -1.0, 1.0)
    doubts = check_log(robot("go1"), with_columns(quiet_log("go1"), tauEst=torques))
    assert doubts == ["tauEst: the hip of FL carries the robot as a leg of the other side would"]


def test_hip_torques_of_unloaded_legs_prove_nothing() -> None:
    torques = quiet_log("go1").columns["tauEst"].copy()
    torques[:, 0::3] *= -1.0
    torques[:, 2::3] *= 0.1
    assert check_log(robot("go1"), with_columns(quiet_log("go1"), tauEst=torques)) == []


def without_gravity(log):
    force = log.columns["accelerometer"]
    return with_columns(log, accelerometer=force - np.median(force, axis=0))


@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("missing", [(), ("tauEst", "dq", "quaternion")], ids=["full", "bare"])
def test_accelerometer_without_gravity_is_refused(name, missing) -> None:
    log = without_gravity(with_columns(quiet_log(name), **dict.fromkeys(missing)))
    with pytest.raises(Error, match=r"'accelerometer': got a median size of .* lack gravity"):
        check_log(robot(name), log)


def test_short_free_fall_is_a_doubt_and_loaded_feet_exclude_it() -> None:
    log = without_gravity(quiet_log("go1"))
    short = {name: values[:300] for name, values in log.columns.items()}
    falling = with_columns(log, **{**short, "tauEst": None})
    assert any("median size" in doubt for doubt in check_log(robot("go1"), falling))
    with pytest.raises(Error, match="lack gravity"):
        check_log(robot("go1"), with_columns(log, **short))


@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("missing", ["tauEst", "dq", "quaternion"])
def test_quiet_log_without_a_column_is_accepted(name, missing) -> None:
    log = with_columns(quiet_log(name), **{missing: None})
    assert check_log(robot(name), log) == []
    made = run_estimator(robot(name), log)
    assert summarise(made)["statuses"]["OK"] > 0.9 * log.rows
