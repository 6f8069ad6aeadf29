import itertools
import json

import pytest
import surefoot
from surefoot.bench import BenchSettings, machine, record, timing
from surefoot.cli import main

NUMBERS = ["n", "min", "p50", "p90", "p99", "p99.9", "max"]
STAGES = ["tick_us", "estimate_us", "whole_body_us", "null_us"]


@pytest.fixture
def result(capsys):
    assert main(["bench", "--ticks", "200", "--form", "condensed", "--json", "-"]) == 0
    return json.loads(capsys.readouterr().out)


def test_a_bench_says_how_long_every_stage_took_and_of_what(result):
    assert (result["robot"], result["form"], result["ticks"]) == ("go1", "condensed", 200)
    for stage in STAGES:
        times = result[stage]
        assert list(times) == NUMBERS and times["n"] == 200
        values = [times[name] for name in NUMBERS[1:]]
        assert 0.0 < values[0] and values == sorted(values)
    assert result["null_us"]["p50"] < result["estimate_us"]["p50"] < result["tick_us"]["p50"]
    assert result["failures"] == {"tick": 0, "estimate": 0, "whole_body": 0}
    for spread in (result["iterations"]["tick"], result["iterations"]["whole_body"]):
        assert 1.0 <= spread["mean"] <= spread["max"]


def test_a_bench_says_on_what_machine_it_ran(result):
    told = result["machine"]
    assert told["cpu"] and told["cores"] >= 1 and "governor" in told
    assert told["python"].startswith("3.")
    assert set(told["versions"]) >= {"surefoot", "pin", "mujoco"}


def test_a_bench_prints_a_table_and_writes_json_beside_it(capsys, tmp_path):
    assert main(["bench", "--ticks", "100", "--json", str(tmp_path / "bench.json")]) == 0
    out = capsys.readouterr().out
    rows = {line.split()[0]: line.split() for line in out.splitlines() if line}
    written = json.loads((tmp_path / "bench.json").read_text())
    for stage in ("tick", "estimate", "whole_body", "null"):
        assert rows[stage][1:3] == ["100", f"{written[f'{stage}_us']['min']:.1f}"]
    assert "about a microsecond" in out and "FAILED" not in out


def test_what_is_replayed_is_a_standing_robot_and_then_a_pushed_one():
    recording = record(BenchSettings(ticks=300))
    assert len(recording.reports) == 300
    ticks = [report.tick for report in recording.reports]
    assert {b - a for a, b in itertools.pairwise(ticks)} == {2}
    assert recording.push.time == pytest.approx(0.3)
    turns = [max(abs(w) for w in report.imu.gyroscope) for report in recording.reports]
    assert max(turns[155:]) > 3.0 * max(turns[:150])


def test_percentiles_are_those_of_all_calls():
    times = timing.distribution(list(range(1000, 1_002_000, 1000)))
    assert times == {
        **{"n": 1001, "min": 1.0, "p50": 501.0, "p90": 901.0},
        **{"p99": 991.0, "p99.9": 1000.0, "max": 1001.0},
    }


def test_a_machine_that_says_nothing_of_itself_is_no_error(monkeypatch, tmp_path):
    monkeypatch.setattr(machine, "_GOVERNOR", tmp_path / "none")
    assert machine.describe_machine()["governor"] is None


@pytest.mark.parametrize("ticks", [0, -5, 99, 10**9])
def test_a_bench_too_short_or_long_is_refused(ticks):
    with pytest.raises(surefoot.Error, match=f"ticks: got {ticks}, expected 100 to"):
        BenchSettings(ticks=ticks)
