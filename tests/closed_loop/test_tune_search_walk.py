# SPDX-License-Identifier: BSD-3-Clause
"""surefoot tune search --walk: its runs, its cost, and its search space."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
import surefoot
from matplotlib.figure import Figure
from surefoot import Error, cli
from surefoot.robot.gain_files import gain_values
from surefoot.sim import PlantSettings
from surefoot.stand.push_request import PushRequest
from surefoot.tune.cost import FALL_COST
from surefoot.tune.search.rollout import TrialJob, evaluate_exclusively
from surefoot.tune.search.settings import SearchSettings
from surefoot.tune.search.space import parse_parameter, walk_space
from surefoot.tune.search.walk_episode import WalkEpisode, speed_limits
from surefoot.tune.search.walk_plot import draw_walk
from surefoot.tune.walk_cost import WALK_OBJECTIVES, WALK_TERMS, walk_cost
from surefoot.walk import VelocityRequest, WalkLog, WalkSettings, run_walk
from surefoot.walk.push_recovery import recovery_times
from surefoot.walk.settings import walking_plant

pytestmark = pytest.mark.slow

ROBOT = surefoot.load_robot("go1")
OWN = ROBOT.config.gains
EPISODE = WalkEpisode("go1", 1, PlantSettings())


def pushed_walk(percent: float, gains: surefoot.Gains = OWN) -> WalkLog:
    settings = WalkSettings(
        "go1",
        4.0,
        plant=replace(walking_plant(), physics_dt=0.001),
        velocities=(VelocityRequest(0.4, 0.0, 0.0, 0.3), VelocityRequest(0.0, 0.0, 0.0, 3.5)),
        pushes=(PushRequest(90.0, percent, True, 0.1, 1.5),),
        gains=gains,
    )
    return run_walk(settings)


def test_walk_episode_is_repeatable() -> None:
    job = TrialJob(gain_values(OWN), (EPISODE,), ("walk",))
    first, again = evaluate_exclusively(job), evaluate_exclusively(job)
    assert first.costs == again.costs and first.terms == again.terms
    assert set(first.terms) == {*WALK_TERMS, "fall"} and first.falls == 0
    assert first.ticks == EPISODE.walk_settings().ticks


def test_episodes_differ_in_robot_ground_and_commands_and_stay_within_the_speed_limits() -> None:
    limits = speed_limits(ROBOT)
    seen = [WalkEpisode("go1", seed, PlantSettings()).walk_settings() for seed in range(8)]
    for name in ("friction", "payload_kg", "motor_lag", "armature_scale", "flaws", "seed"):
        assert len({str(getattr(settings.plant, name)) for settings in seen}) == len(seen)
    assert {settings.plant.soft_soles for settings in seen} == {True, False}
    assert min(s.plant.soft_ground_sink for s in seen) == 0.0 < seen[0].plant.soft_ground_sink
    assert all(settings.plant.walking_sensors for settings in seen)
    for settings in seen:
        turn, sideways, forward, _, stop = settings.velocities
        assert 0.0 < forward.vx < limits.vx and 0.0 < abs(sideways.vy) < limits.vy
        assert 0.0 < abs(turn.yaw_rate) < limits.yaw_rate
        assert (stop.vx, stop.vy, stop.yaw_rate) == (0.0, 0.0, 0.0)
        assert len({push.time for push in settings.pushes}) == 2
    assert len({settings.velocities[2].vx for settings in seen}) == len(seen)


def test_stronger_push_takes_longer_to_recover_and_costs_more() -> None:
    weak, strong = pushed_walk(20.0), pushed_walk(110.0)
    times = [recovery_times(log) for log in (weak, strong)]
    assert 0.0 <= times[0][0] < times[1][0] <= 1.9  # [s] until the next command
    costs = [walk_cost(log, "pushes") for log in (weak, strong)]
    assert costs[0].value < costs[1].value < FALL_COST
    assert costs[1].terms["recovery"] == times[1][0] / 0.5


def test_a_fall_costs_more_than_every_walk_without() -> None:
    fallen = pushed_walk(400.0)
    assert fallen.fell
    for objective in WALK_OBJECTIVES:
        assert FALL_COST < walk_cost(fallen, objective).value <= 3.0 * FALL_COST


def test_walk_has_its_own_objectives_and_space() -> None:
    settings = SearchSettings("go1", OWN, walk=True)
    assert settings.objectives == ("walk",)
    assert [p.name for p in settings.space] == [p.name for p in walk_space()]
    for parameter in settings.space:
        assert parameter.low < parameter.get(OWN) < parameter.high
    assert all(isinstance(episode, WalkEpisode) for episode in settings.search_episodes)
    with pytest.raises(Error, match="got 'balance', expected one of walk, pushes, transport"):
        SearchSettings("go1", OWN, walk=True, objectives=("balance",))
    with pytest.raises(Error, match="got 'walk', expected one of balance"):
        SearchSettings("go1", OWN, objectives=("walk",))
    assert parse_parameter("swing_height").high == 0.3
    assert settings.identity() != SearchSettings("go1", OWN, objectives=("power",)).identity()


def test_plot_has_velocity_and_tilt_of_each_log() -> None:
    figure = draw_walk(
        {"start": pushed_walk(20.0), "best": pushed_walk(60.0)}, {"start": "red", "best": "blue"}
    )
    assert isinstance(figure, Figure)
    assert [len(ax.lines) for ax in figure.axes] == [3, 3, 3, 2]  # the command is a line too


def test_walk_search_command_writes_its_result(tmp_path: Path) -> None:
    path, gains = tmp_path / "walk.json", tmp_path / "walk.toml"
    words = ["tune", "search", "--walk", "--robot", "go1", "--trials", "1", "--episodes", "1"]
    words += [
        "--held-out",
        "1",
        "--jobs",
        "1",
        "--seed",
        "1",
        "--json",
        str(path),
        "--toml",
        str(gains),
    ]
    assert cli.main(words) == 0
    summary = json.loads(path.read_text())
    assert summary["walk"] and summary["objective"] == ["walk"] and summary["failures"] == 0
    assert set(summary["parameters"]) == {p.name for p in walk_space()}
    assert "--walk" in gains.read_text()
    assert surefoot.load_gains(gains).swing_height == pytest.approx(OWN.swing_height)
