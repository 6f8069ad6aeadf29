# SPDX-License-Identifier: BSD-3-Clause
"""Verdicts of surefoot estimate on logs of walking robots, with and without a sensor fault."""

from __future__ import annotations

import functools
import re
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import surefoot
from surefoot import Error
from surefoot.estimate.checks import check_log
from surefoot.estimate.checks.walking.check import find_walk
from surefoot.estimate.checks.walking.identities import (
    CALF,
    GAIN,
    GYRO_BIAS,
    feet_equations,
    force_equations,
)
from surefoot.estimate.checks.walking.imu_path import ImuIntegrals
from surefoot.stand import SensorRecorder, StandSettings, run_stand

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from sensor_faults import draw_faults, with_fault
from sensor_verdicts import VARIANTS, without
from verdict_walks import record_walk

pytestmark = pytest.mark.slow

WALKS = {"go1": 2, "b1": 5}  # a corner on level ground, an arc on a slope; foot forces in newtons
DURATION = 11.5  # [s] 10 s after the first step at the latest
FAULTS = {fault.name: fault for fault in draw_faults(np.random.default_rng(0))}


@functools.cache
def robot(name):
    return surefoot.load_robot(name)


@functools.cache
def walk(name):
    log = record_walk(name, WALKS[name])
    rows = log.time < DURATION
    columns = {column: values[rows] for column, values in log.columns.items()}
    return replace(log, columns=columns, time=log.time[rows])


def with_columns(log, **columns):
    return replace(log, columns={**log.columns, **columns})


@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize("name", WALKS)
def test_healthy_walking_log_has_no_verdict(name, variant) -> None:
    assert check_log(robot(name), without(walk(name), VARIANTS[variant])) == []


@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("name", WALKS)
def test_fault_of_a_walking_log_is_named_and_no_other(name, fault) -> None:
    log = with_fault(walk(name), FAULTS[fault], len(walk(name).time) // 3)
    try:
        found = check_log(robot(name), log)
    except Error as error:
        found = [str(error)]
    assert found and all(re.search(FAULTS[fault].verdict, text) for text in found), found


def test_verdict_states_the_size_of_the_fault() -> None:
    log = walk("go1")
    biased = with_columns(log, gyroscope=log.columns["gyroscope"] + [0.0, 0.0, 0.2])
    (text,) = check_log(robot("go1"), biased)
    values = [float(word) for word in re.findall(r"-?\d\.\d\d", text)]
    assert values == pytest.approx([0.0, 0.0, 0.2], abs=0.02)
    slow = with_columns(log, gyroscope=log.columns["gyroscope"] * [1.0, 1.0, 0.5])
    (text,) = check_log(robot("go1"), slow)
    assert float(re.findall(r"\d\.\d\d", text)[0]) == pytest.approx(0.5, abs=0.02)


def test_gyroscope_in_degrees_is_refused_in_a_walk_without_a_quaternion() -> None:
    log = without(walk("go1"), ("quaternion",))
    gyroscope = log.columns["gyroscope"] * 180.0 / np.pi
    with pytest.raises(Error, match="deg/s"):
        check_log(robot("go1"), with_columns(log, gyroscope=gyroscope))


def test_standing_robot_does_not_count_as_walking() -> None:
    recorder = SensorRecorder()
    run_stand(StandSettings(robot="go1", duration=1.5), sensors=recorder)
    assert find_walk(robot("go1"), recorder.log()) is None


@pytest.mark.parametrize("equations", [feet_equations, force_equations])
def test_coefficients_are_the_derivatives_of_the_residuals(equations) -> None:
    found = find_walk(robot("go1"), walk("go1"))
    healthy = equations(found.paths, found.stances, integrals(walk("go1"), found))
    calf = np.zeros(12)
    calf[5] = -0.01  # the parameter is the correction of the angle
    gyroscope, q = walk("go1").columns["gyroscope"], walk("go1").columns["q"]
    changes = {
        GAIN.start + 1: (-0.01, {"gyroscope": gyroscope * [1.0, 0.99, 1.0]}),
        GYRO_BIAS.start + 2: (0.01, {"gyroscope": gyroscope + 0.01 * np.eye(3)[2]}),
        CALF.start + 1: (0.01, {"q": q + calf}),
    }
    for k, (size, columns) in changes.items():
        log = with_columns(walk("go1"), **columns)
        paths = find_walk(robot("go1"), log).paths
        changed = equations(paths, found.stances, integrals(log, found))
        # Correct parameters give the residuals of the healthy log.
        wanted = changed.y - healthy.y
        expected = healthy.C[:, :, k] * (size if k < GYRO_BIAS.start else -size)
        scale = np.abs(expected).max()
        if scale > 0.0:
            np.testing.assert_allclose(wanted, expected, atol=0.03 * scale)


def integrals(log, found):
    return ImuIntegrals(robot("go1"), log, found.stances.stride).at(found.paths.time)
