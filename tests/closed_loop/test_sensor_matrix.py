# SPDX-License-Identifier: BSD-3-Clause
"""Short form of benchmarks/sensor_matrix.py."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import sensor_matrix
from sensor_matrix import run_cell, run_healthy

# Robot, sensor, way, and the time [s] until which the sensor must be named. Pushes begin at 2 s and
# 6 s.
NAMED = [
    ("go1", "accelerometer", "no gravity", 0.2),
    ("go1", "accelerometer", "sign", 0.2),
    ("go1", "accelerometer", "g", 0.2),
    ("go1", "gyroscope", "degrees", 1.0),
    ("a1", "gyroscope", "sign", 2.5),
    ("go1", "q", "degrees", 0.1),
    ("a1", "q", "g", 0.1),
    ("go2", "q", "axes", 0.1),
    ("b1", "q", "front-rear", 1.0),
    ("go1", "q", "frozen", 2.5),
    ("a1", "dq", "degrees", 0.1),
    ("go1", "dq", "sign", 2.5),
    ("go1", "tauEst", "sign", 1.0),
    ("b1", "tauEst", "g", 1.0),
    ("go1", "all joints", "left-right", 1.0),
]
HARMLESS = [
    ("go1", "quaternion", "sign"),
    ("a1", "gyroscope", "zero"),
    ("go1", "footForce", "sign"),
]


@pytest.mark.parametrize(("robot", "sensor", "way", "latest"), NAMED)
def test_sensor_that_is_wrong_from_the_first_sample_is_named(
    robot: str, sensor: str, way: str, latest: float
) -> None:
    result = run_cell((robot, sensor, way, 0.0, 0))
    assert result.ok, result.why
    assert result.text.startswith("named")
    assert float(result.text.split()[1]) <= latest


@pytest.mark.slow
@pytest.mark.parametrize(("robot", "sensor", "way"), HARMLESS)
def test_wrong_sensor_that_is_not_named_is_harmless(robot: str, sensor: str, way: str) -> None:
    result = run_cell((robot, sensor, way, 0.0, 0))
    assert (result.ok, result.text) == (True, "harmless"), result.why


@pytest.mark.slow
@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_no_sensor_of_a_healthy_start_is_named(robot: str, seed: int) -> None:
    start = run_healthy((robot, seed))
    assert start.ok and not start.fell, start.why


def test_matrix_fails_if_a_fall_began_with_a_usable_status() -> None:
    fell = sensor_matrix.judge("q", FallenPlant(), None, [True, True], [0.0, 1.0], "OK")
    assert (fell.ok, fell.text) == (False, "FELL 0.50 s")


class FallenPlant:
    """Stand-in for a plant whose robot fell at 0.5 s."""

    time = 0.5
    fell = True

    @property
    def truth(self) -> FallenPlant:
        """The state of which judge() reads `fell`."""
        return self
