# SPDX-License-Identifier: BSD-3-Clause
"""The command surefoot walk: velocities as text, options, JSON, text, report and exit status."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from PIL import Image
from surefoot import Error, Gait
from surefoot.cli import arguments, main
from surefoot.cli.walk import read_settings
from surefoot.sim import Terrain
from surefoot.stand import film
from surefoot.walk import FIELDS, WalkSettings, parse_velocity, run_walk, summarise
from surefoot.walk.report import write_report
from surefoot.walk.velocity_request import velocity_ticks


def settings_of(words: str) -> WalkSettings:
    """Return the settings of `surefoot walk` with these words."""
    return read_settings(arguments.parse_arguments(["walk", *words.split()]))


@pytest.mark.parametrize("text", ["0.5,0.0,0.0@1.0", "-0.25,0.1,-1.5@0.0"])
def test_velocity_text_survives_a_round_trip(text) -> None:
    assert str(parse_velocity(text)) == text


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1@2", r"got '1@2', expected VX,VY,YAW_RATE@TIME, such as 0.5,0,0@1"),
        ("1,2,3", r"got '1,2,3', expected VX,VY,YAW_RATE@TIME"),
        ("1,2,3,4@5", r"expected VX,VY,YAW_RATE@TIME"),
        ("1,left,0@1", r"velocity '1,left,0@1': VY: got 'left', expected a finite number"),
        ("nan,0,0@1", r"VX: got 'nan', expected a finite number"),
        ("0,0,-inf@1", r"YAW_RATE: got '-inf', expected a finite number"),
        ("0,0,0@soon", r"TIME: got 'soon', expected a finite number"),
        ("0,0,0@-1", r"velocity: time \[s\]: got -1"),
        ("1e6,0,0@1", r"velocity: vx \[m/s\]: got 1000000"),
    ],
)
def test_wrong_velocity_is_refused_by_name(text, message) -> None:
    with pytest.raises(Error, match=message):
        parse_velocity(text)


def test_velocities_apply_by_time_in_any_order() -> None:
    requests = [parse_velocity("0,0,0@2"), parse_velocity("0.5,0,0@1")]
    assert [(k, r.vx) for k, r in velocity_ticks(requests, 500.0)] == [(500, 0.5), (1000, 0.0)]


def test_two_velocities_for_one_time_are_refused() -> None:
    with pytest.raises(Error, match=r"got another velocity for 1 s, expected one for each time"):
        settings_of("--velocity 1,0,0@1 --velocity 0,1,0@1")


def test_walk_without_options_has_the_plant_of_a_walk() -> None:
    assert settings_of("") == WalkSettings(robot=settings_of("").robot)


def test_options_reach_the_settings_in_si_units() -> None:
    words = "--velocity -0.5,0,0.1@1 --gait trot --delay-ms 3 --predict-ms 4 --slope 5 "
    words += "--slope-heading 90 --rigid-soles --payload 1:0:0:0.1 --seed 7 --foot-force raw"
    settings = settings_of(words)
    plant = settings.plant
    assert [str(velocity) for velocity in settings.velocities] == ["-0.5,0.0,0.1@1.0"]
    assert (settings.gait, settings.walk_options.tick.delay) == (Gait.TROT, 0.004)
    assert (plant.extra_delay, plant.slope_deg, plant.slope_heading_deg) == (0.003, 5.0, 90.0)
    assert (plant.soft_soles, plant.walking_sensors, plant.leg_collisions) == (False, True, True)
    assert (plant.payload_kg, plant.seed, plant.foot_force) == (1.0, 7, "raw")


def test_gait_walk_and_references_reach_the_settings() -> None:
    settings = settings_of("--gait walk --reference height=-0.02,pitch=5@1")
    assert settings.gait == Gait.WALK
    assert [request.offsets for request in settings.references] == [{"height": -0.02, "pitch": 5.0}]


@pytest.mark.parametrize(
    ("words", "terrain"),
    [
        ("--step 0.08:30", Terrain(step_height=0.08, step_heading_deg=30.0, seed=2)),
        ("--stairs 0.05:0.3", Terrain(stairs_height=0.05, stairs_tread=0.3, seed=2)),
        ("--blocks 0.03", Terrain(block_height=0.03, seed=2)),
        ("", Terrain()),
    ],
)
def test_terrain_options_reach_the_plant(words, terrain) -> None:
    assert settings_of(f"{words} --seed 2").plant.terrain == terrain


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--step high", r"--step: got 'high', expected HEIGHT\[:HEADING\]"),
        ("--step -0.1", r"terrain: step_height: got -0.1"),
        ("--stairs 0.05", r"--stairs: got '0.05', expected HEIGHT:TREAD"),
        ("--blocks nan", r"terrain: block_height: got nan"),
        ("--step 0.1 --blocks 0.1", r"got step_height and block_height, expected one of them"),
        ("--step 0.1 --slope 5", r"terrain: got it together with a slope"),
        ("--lost-frames -1", r"lost_frames: got -1"),
    ],
)
def test_wrong_ground_is_refused_by_name(words, message) -> None:
    with pytest.raises(Error, match=message):
        settings_of(words)


def test_lost_frames_keep_the_command_before() -> None:
    log = run_walk(settings_of("--duration 0.6 --lost-frames 20"))
    repeated = (np.diff(log.commands.astype(int), axis=0) == 0).all(axis=1).mean()
    assert 0.15 < repeated < 0.5
    assert not log.fell


def test_json_has_every_field_and_the_limit_of_a_clamped_velocity(capsys, tmp_path) -> None:
    words = "walk --duration 1.3 --velocity 9,0,0@0.1 --velocity 0,0,0.1@0.2 --json"
    assert main([*words.split(), str(tmp_path / "out.json")]) == 0
    summary = json.loads((tmp_path / "out.json").read_text())
    assert list(summary) == [field.name for field in FIELDS]
    clamped, turning = summary["commands"]
    assert (clamped["velocity"], clamped["limit"]) == ([9.0, 0.0, 0.0], "forward")
    assert 0.5 < clamped["commanded_velocity"][0] < 5.0
    assert clamped["velocity_rmse"] is None  # the next command follows within a second
    assert turning["limit"] == "none" and turning["cost_of_transport"] is None
    assert summary["velocity_rmse"] == turning["velocity_rmse"]
    assert set(summary["tick_us"]) == {"p50", "p90", "p99", "p99.9", "max"}
    out, err = capsys.readouterr()
    assert "9, 0 m/s, 0 rad/s at 0.1 s, limited (forward) to" in out and err == ""


def test_walk_without_a_velocity_stands(capsys) -> None:
    assert main("walk --duration 0.6 --json -".split()) == 0
    summary = json.loads(capsys.readouterr().out)
    assert summary["commands"] == [] and summary["velocity_rmse"] is None
    assert (summary["steps"], summary["slip_mm_per_step"]) == (0, None)
    assert summary["stands_at_end"]
    assert main("walk --duration 0.1".split()) == 0
    assert "no steps, 0 leg contacts" in capsys.readouterr().out


def test_fall_exits_with_status_3_and_a_summary(capsys) -> None:
    words = "walk --duration 2 --push lateral:1000%:0.1@0.1 --velocity 0.5,0,0@0.1 --json -"
    assert main(words.split()) == 3
    summary = json.loads(capsys.readouterr().out)
    assert summary["fell"] and not summary["stands_at_end"]
    assert summary["fall_time_s"] == summary["duration"] < 2.0


def test_walk_report_folder_contains_all_files_of_its_page(tmp_path, monkeypatch) -> None:
    # This test does not check the pictures, and drawing them needs a graphics library.
    blank = Image.new("RGB", (film.WIDTH, film.HEIGHT))
    monkeypatch.setattr(film, "_frames", lambda log, ticks: (blank for _ in ticks))
    log = run_walk(WalkSettings(duration=0.8, velocities=(parse_velocity("0.5,0,0@0.1"),)))
    summary = summarise(log)
    page = write_report(log, summary, tmp_path, ["surefoot", "walk"]).read_text()
    for file in re.findall(r'(?:src|href)="([^"]+)"', page):
        assert (tmp_path / file).stat().st_size > 0
    assert "Velocity: 0.5, 0 m/s, 0 rad/s at 0.1 s" in page and "film.webp" in page
    assert all(f"<code>{name}</code>" in page for name in summary)
    assert json.loads((tmp_path / "summary.json").read_text()) == summary


def test_film_replay_matches_the_walk() -> None:
    log = run_walk(WalkSettings(duration=0.6, velocities=(parse_velocity("0.5,0,0@0.1"),)))
    assert log.walking.any()
    for k, plant in film.replay_run(log):
        np.testing.assert_array_equal(plant.truth.q, log.q_true[k])
