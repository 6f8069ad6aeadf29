# SPDX-License-Identifier: BSD-3-Clause
"""The gait walk, and height and attitude while walking, with the sensor errors of a walk."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import surefoot
from surefoot import Gait
from surefoot.sim import Plant
from surefoot.stand import parse_push, parse_reference
from surefoot.walk import WalkLog, WalkSettings, parse_velocity, run_walk, summarise
from surefoot.walk.settings import walking_plant
from surefoot.walk.steps import LOADED

pytestmark = pytest.mark.slow


def walk(gait: Gait, velocities: list[str], *references: str, duration: float) -> WalkLog:
    return run_walk(
        WalkSettings(
            duration=duration,
            velocities=tuple(map(parse_velocity, velocities)),
            references=tuple(map(parse_reference, references)),
            gait=gait,
        )
    )


@pytest.fixture(scope="module")
def walked() -> dict:
    """A walk forwards, to the left, on the spot to the right, and a stop."""
    velocities = ["0.25,0,0@0.5", "0,0.25,0@3.5", "0,0,-0.5@6.5", "0,0,0@9"]
    return summarise(walk(Gait.WALK, velocities, duration=12.5))


def test_go1_walks_with_three_loaded_feet_in_every_direction(walked) -> None:
    assert not walked["fell"]
    assert (walked["failed_ticks"], walked["leg_contacts"]) == (0, 0)
    assert walked["torque_mode_only"]
    assert walked["three_or_more_loaded"] >= 0.95
    assert np.all(np.array(walked["velocity_mean_error"]) <= 0.02)
    # The body sways: its velocity differs from the command within a period.
    assert np.all(np.array(walked["velocity_rmse"]) <= [0.05, 0.05, 0.1])
    assert np.all(np.array(walked["roll_pitch_rms_deg"]) <= [1.0, 1.0])


def test_pushed_go1_trots_and_walks_again_while_its_direction_changes() -> None:
    directions = (
        "0.2,0.2,0.2 -0.2,0.2,0.2 0,-0.2,-0.5 0.25,0,0 -0.1,-0.2,0.3 0,0,-0.6 0.2,-0.1,0 0,0,0"
    )
    velocities = [f"{v}@{0.5 + 2.5 * k}" for k, v in enumerate(directions.split())]
    pushes = [parse_push(f"{90 * k + 30}:100%:0.1@{4.0 + 4.3 * k}") for k in range(4)]
    plant = replace(walking_plant(), foot_force="raw", soft_ground_sink=0.005)
    log = run_walk(
        WalkSettings(
            duration=21.0,
            velocities=tuple(map(parse_velocity, velocities)),
            gait=Gait.WALK,
            plant=plant,
            pushes=tuple(pushes),
        )
    )
    summary = summarise(log)
    assert not summary["fell"] and summary["stands_at_end"]
    trots = (log.planned_loads > 0.0).sum(axis=1) <= 2
    # With six seeds the robot walks again within 2.6 s of each push. (A seventh falls at 100 %.)
    times = [[round((push.time + after) * log.rate) for after in (0, 3, 4)] for push in log.pushes]
    # A walk trots only if it must: its stance feet brake one of the pushes.
    assert sum(bool(trots[begin:calm].any()) for begin, calm, _ in times) >= 3
    assert not any(trots[calm:end].any() for _, calm, end in times)


def test_go1_stands_after_a_walk(walked) -> None:
    assert walked["stands_at_end"]
    assert walked["stance_error_mm"] <= 20.0


@pytest.mark.parametrize(("height", "pitch"), [(-0.04, 10.0), (0.04, -10.0)])
def test_go1_trots_at_the_requested_height_and_pitch(height, pitch) -> None:
    reference = f"height={height},pitch={pitch}@0.5"
    log = walk(Gait.AUTO, ["0.5,0,0@2", "0,0,0@5"], reference, duration=7.5)
    summary = summarise(log)
    assert not summary["fell"]
    assert summary["reference_limit"] == "none"
    assert np.all(np.array(summary["roll_pitch_rms_deg"]) <= 1.0)
    assert np.all(np.array(summary["velocity_mean_error"]) <= 0.02)
    assert np.all(np.array(summary["velocity_rmse"]) <= [0.05, 0.05, 0.1])
    trotting = slice(round(3.0 * log.rate), round(5.0 * log.rate))
    assert log.walking[trotting].all()
    standing_height = log.q_true[round(0.4 * log.rate), 2]
    assert log.q_true[trotting, 2].mean() - standing_height == pytest.approx(height, abs=0.01)
    # The stand keeps the reference in which the walk ends.
    assert summary["stands_at_end"]
    assert log.q_true[-1, 2] - standing_height == pytest.approx(height, abs=0.01)
    assert np.abs(np.diff(log.body_reference[round(2.0 * log.rate) :], axis=0)).max() < 1e-3


def test_gait_changes_while_go1_walks() -> None:
    plant = Plant("go1", walking_plant())
    controller = surefoot.WalkController(plant.robot)
    state = plant.reset()
    weight = 9.81 * plant.model.body_subtreemass[plant.handles.root]
    loaded: dict[Gait, list[int]] = {Gait.WALK: [], Gait.AUTO: []}
    for k in range(4000):
        gait = (Gait.WALK, Gait.AUTO)[k // 1000 % 2]
        controller.gait = gait
        controller.set_velocity(surefoot.WalkVelocity(0.2, 0.0, 0.0))
        state = plant.step(controller.update(state))
        if k >= 1000 and k % 1000 >= 500:
            loaded[gait].append(int(np.sum(plant.truth.foot_forces[2] > LOADED * weight)))
    assert not plant.truth.fell
    assert np.mean(np.array(loaded[Gait.WALK]) >= 3) >= 0.9
    assert np.mean(np.array(loaded[Gait.AUTO]) <= 2) >= 0.5
