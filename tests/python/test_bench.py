# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import itertools
import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import surefoot
from surefoot.bench import BenchSettings, record, tick_program, timing_statistics
from surefoot.bench.problems import SCENARIOS
from surefoot.cli import main
from surefoot.system import machine

pytestmark = pytest.mark.slow

NUMBERS = ["n", "min", "p50", "p90", "p99", "p99.9", "max"]
WHOLE = ["tick", "state_to_torque", "null"]
STAGES = ["estimate", "dynamics", "reference", "tasks", "condense", "program", "solve", "check"]
SHORT = ["bench", "--ticks", "200", "--scenario", "quiet"]


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    path = tmp_path_factory.mktemp("bench") / "bench.json"
    words = ["bench", "--ticks", "7000", "--scenario", "push80", "--form", "condensed"]
    assert main([*words, "--json", str(path)]) == 0
    return json.loads(path.read_text())


def test_bench_reports_time_statistics_of_every_part(result):
    assert (result["robot"], result["form"]) == ("go1", "condensed")
    scenario = result["scenarios"]["push80"]
    assert scenario["reports"] == 3500 and not scenario["fell"]
    for name in WHOLE:
        for clock in ("wall_us", "cpu_us"):
            times = scenario[name][clock]
            assert list(times) == NUMBERS and times["n"] == 7000
            values = [times[k] for k in NUMBERS[1:]]
            assert 0.0 < values[0] and values == sorted(values)
        assert sum(scenario[name]["histogram_us"]) == 7000
    assert list(scenario["stages_wall_us"]) == [*STAGES, "safety"]
    # Compare minima, not medians: another process can slow down a whole pass over the recording.
    assert scenario["state_to_torque"]["wall_us"]["min"] < scenario["tick"]["wall_us"]["min"]


def test_ticks_have_no_allocations_page_faults_or_failures(result):
    tick = result["scenarios"]["push80"]["tick"]
    assert (tick["allocations"], tick["page_faults"], tick["failures"]) == (0, 0, 0)
    counts = {int(k): n for k, n in tick["iterations"].items()}
    assert sum(counts.values()) == 7000
    assert sum(k * n for k, n in counts.items()) / 7000 < 1.3
    assert max(counts) <= 30
    assert tick["first_pass"]["allocations"] == 0


def test_ticks_are_also_timed_at_the_sample_rate(result):
    paced = result["scenarios"]["push80"]["paced"]
    assert (paced["wall_us"]["n"], paced["allocations"], paced["failures"]) == (500, 0, 0)


def test_bench_reports_machine_and_compiler_flags(result):
    told = result["machine"]
    assert told["cpu"] and told["cores"] >= 1 and "governor" in told
    assert "-O3" in told["build"]
    assert set(told["versions"]) >= {"surefoot", "pin", "mujoco"}


def test_peer_ratios_are_null_with_a_reason_without_peers(result):
    names = ["state_to_torque_over_tsid", "tick_over_tsid", "state_to_torque_over_placo"]
    assert [result[f"ratio_{name}"] for name in names] == [None] * 3
    assert "--peers" in result["ratio_reason"]


def test_a_bench_prints_a_table_and_writes_a_report(capsys, tmp_path):
    assert main([*SHORT, "--report", str(tmp_path)]) == 0
    out = capsys.readouterr().out
    rows = {line.split()[0]: line.split() for line in out.splitlines() if line.strip()}
    written = json.loads((tmp_path / "bench.json").read_text())
    for name in WHOLE:
        wall = written["scenarios"]["quiet"][name]["wall_us"]
        assert rows[name][1:3] == [str(wall["n"]), f"{wall['min']:.1f}"]
    assert "FAILED" not in out
    assert (tmp_path / "quiet.png").stat().st_size > 10_000
    assert "quiet.png" in (tmp_path / "index.html").read_text()


def test_recording_contains_standing_and_then_a_push():
    recording = record(BenchSettings(), "push50")
    ticks = [report.tick for report in recording.low_states]
    assert len(ticks) == 3500 and {b - a for a, b in itertools.pairwise(ticks)} == {2}
    turns = [max(abs(w) for w in report.imu.gyroscope) for report in recording.low_states]
    assert max(turns[500:600]) > 3.0 * max(turns[:500])


def test_recorded_body_references_are_replayed():
    # A reference that the recorded robot did not have costs iterations of the active set.
    recording = record(BenchSettings(), "motion")
    assert len(recording.references) == len(recording.low_states)
    other = replace(recording, references=recording.references[:1] * len(recording.references))
    iterations = [
        tick_program.run_tick_program(replayed, surefoot.QpForm.AUTO, 100)[0]["tick"].iterations
        for replayed in (recording, other)
    ]
    assert iterations[0].sum() < 1.1 * iterations[0].size < iterations[1].sum()
    short = replace(recording, references=recording.references[1:])
    with pytest.raises(
        surefoot.Error, match="references: got 4999, expected one per LowState: 5000"
    ):
        tick_program.run_tick_program(short, surefoot.QpForm.AUTO, 100)


@pytest.mark.parametrize(("scenario", "duration"), [("trot", 3.5), ("walk", 1.5)])
def test_recorded_walk_is_replayed_step_by_step(monkeypatch, scenario, duration):
    monkeypatch.setitem(SCENARIOS, scenario, replace(SCENARIOS[scenario], duration=duration))
    recording = record(BenchSettings(), scenario)
    assert not recording.fell and recording.walking_ticks > 0.8 * len(recording.low_states)
    series, _ = tick_program.run_tick_program(
        recording, surefoot.QpForm.AUTO, 2 * len(recording.low_states)
    )
    for name in ("tick", "state_to_torque"):
        assert series[name].walking == 2 * recording.walking_ticks
        assert (series[name].failures, series[name].allocations) == (0, 0)
    short = replace(recording, velocities=recording.velocities[1:])
    with pytest.raises(surefoot.Error, match=r"--velocities: got \d+, expected one per LowState"):
        tick_program.run_tick_program(short, surefoot.QpForm.AUTO, 100)


def test_bench_compares_walking_ticks_with_standing_ones(monkeypatch, capsys, tmp_path):
    for scenario in ("quiet", "walk"):
        monkeypatch.setitem(SCENARIOS, scenario, replace(SCENARIOS[scenario], duration=1.0))
    path = tmp_path / "bench.json"
    assert main([*SHORT, "--scenario", "walk", "--json", str(path)]) == 0
    assert "the robot steps in" in capsys.readouterr().out
    scenarios = json.loads(path.read_text())["scenarios"]
    p50 = {name: scenarios[name]["tick"]["cpu_us"]["p50"] for name in scenarios}
    assert scenarios["walk"]["tick_over_quiet"] == pytest.approx(p50["walk"] / p50["quiet"])
    assert scenarios["quiet"]["tick_over_quiet"] == 1.0
    assert scenarios["quiet"]["tick"]["walking"] == 0 < scenarios["walk"]["tick"]["walking"]


def test_percentiles_use_all_calls():
    times = timing_statistics.distribution(np.arange(1.0, 1002.0))
    assert times == {
        **{"n": 1001, "min": 1.0, "p50": 501.0, "p90": 901.0},
        **{"p99": 991.0, "p99.9": 1000.0, "max": 1001.0},
    }
    assert timing_statistics.histogram([0.2, 1.7, 1.1, 9e9])[:2] == [1, 2]
    assert len(timing_statistics.histogram([9e9])) == timing_statistics.HISTOGRAM_END + 1


def test_missing_machine_information_is_none(monkeypatch, tmp_path):
    monkeypatch.setattr(machine, "_GOVERNOR", tmp_path / "none")
    assert machine.describe_machine()["governor"] is None


@pytest.mark.parametrize("ticks", [0, -5, 99, 10**9])
def test_tick_count_out_of_range_is_refused(ticks):
    with pytest.raises(surefoot.Error, match=f"ticks: got {ticks}, expected 100 to"):
        BenchSettings(ticks=ticks)


def test_invalid_bench_gives_one_error_line(capsys, monkeypatch, tmp_path):
    assert main(["bench", "--scenario", "dance"]) == 2
    assert "got 'dance', expected one of quiet" in capsys.readouterr().err
    monkeypatch.setattr(tick_program, "PROGRAM", tmp_path / "gone")
    assert main(SHORT) == 2
    error = capsys.readouterr().err
    assert "gone" in error and "Traceback" not in error


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--solvers", "--ticks", "500"], "--ticks: has no effect with --solvers"),
        (["--solvers", "--peers"], "--peers: has no effect with --solvers"),
        (["--solvers", "--report", "out"], "--report: has no effect with --solvers"),
        (["--solvers", "--urdf", "a.urdf"], "--urdf: has no effect with --solvers"),
        (["--solvers", "--export", "out"], "--solvers: has no effect with --export"),
        (
            ["--solvers", "a.npz", "--scenario", "quiet"],
            "--scenario: has no effect with --solvers F",
        ),
        (["--solvers", "a.npz", "--form", "general"], "--form: has no effect with --solvers FILE"),
        (["--solvers", "--scenario", "dance"], "got 'dance', expected one of quiet"),
        (["--export", "out", "--ticks", "500"], "--ticks: has no effect with --export"),
        (["--export", "out", "--json", "-"], "--json: has no effect with --export"),
        (["--export", "out", "--form", "dense"], "--form: got 'dense'"),
        (["--qpbenchmark"], "--qpbenchmark: has no effect with bench alone"),
    ],
)
def test_option_without_effect_is_refused(capsys, words, said):
    assert main(["bench", *words]) == 2
    assert said in capsys.readouterr().err


def test_growth_table_includes_arm_and_humanoid_without_failures():
    script = Path(__file__).parents[2] / "benchmarks" / "problem_size.py"
    words = [sys.executable, str(script), "--ticks", "20"]
    out = subprocess.run(words, capture_output=True, text=True, check=True).stdout
    assert len(out.splitlines()) == 13 and "failed" not in out
    assert "| b1-z1 | 25 |" in out and "| g1 | 35 |" in out
