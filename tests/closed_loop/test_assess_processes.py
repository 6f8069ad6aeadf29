# SPDX-License-Identifier: BSD-3-Clause
"""surefoot assess: controllers that end their process, failed starts, resumed runs."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import pytest
from surefoot.assess import (
    AssessSettings,
    Condition,
    ControllerUnderTest,
    Scorecard,
    read_scorecard,
    run_assess,
)
from surefoot.assess.failure_films import films_of_failures
from surefoot.assess.plan import planned_work
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.work_units import StandUnit
from surefoot.assess.worker import WorkItem
from surefoot.assess.worker_pool import run_work

pytestmark = pytest.mark.slow

LEVEL_GROUND = Condition("level ground", quiet_s=0.1)
QUIET = {"directions": 1, "seeds": 1, "condition_seeds": 1, "faults": "none"}


def controller_under_test(name: str) -> ControllerUnderTest:
    return ControllerUnderTest(f"assess_controllers:{name}")


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("never_returns", "never returned: no run ended in 1 s"),
        ("kills_process", "died with exit status 7"),
    ],
)
def test_controller_that_hangs_or_kills_its_process_is_recorded_and_the_run_continues(
    name: str, words: str
) -> None:
    card = Scorecard("few", directions=2, seeds=1, condition_seeds=0, faults="none")
    result = run_assess(AssessSettings("go1", controller_under_test(name), card, deadline=1.0))
    rows = result["push"]["tables"][0]["directions"]
    assert len(rows) == 2 and all(words in row["broken"][0] for row in rows)
    assert result["push"]["survive_percent_of_limit_p5"] == 0.0


def test_single_stall_of_a_working_controller_is_retried(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("STALLS", str(tmp_path))
    card = Scorecard("few", directions=3, seeds=1, condition_seeds=0, faults="none")
    result = run_assess(
        AssessSettings("go1", controller_under_test("stalls_once"), card, deadline=2.0)
    )
    assert result["push"]["broken"] == []
    assert len(list(tmp_path.iterdir())) == 10  # three per unit, and the one that stalled


def test_worker_that_dies_between_units_affects_no_result() -> None:
    units = [
        WorkItem(StandUnit(LEVEL_GROUND, 0.0, seed), controller_under_test("dies_between_runs"))
        for seed in range(3)
    ]
    found = []
    for _, result in run_work(units, "go1", 1, 20.0):
        found.append(result)
        time.sleep(1.0)  # as with a slow disk: the process has ended before it gets the next unit
    assert len(found) == 3 and not any("broken" in result for result in found)


def test_unguarded_main_module_is_reported_without_blaming_the_controller(
    tmp_path: Path,
) -> None:
    (tmp_path / "card.toml").write_text("directions = 1\nseeds = 1\nfaults = 'none'\n")
    script = tmp_path / "unguarded.py"
    script.write_text(
        "from surefoot.assess import AssessSettings, ControllerUnderTest, "
        "read_scorecard, run_assess\n"
        "run_assess(AssessSettings('go1', ControllerUnderTest('pd'), "
        "read_scorecard('card.toml')))\n"
    )
    words = [sys.executable, str(script)]
    ended = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert ended.returncode != 0
    assert "expected a main module that can be imported, with its code under if" in ended.stderr


@pytest.mark.parametrize(("name", "again"), [("throws", 0), ("kills_process", 2)])
def test_resumed_run_retries_lost_units_but_not_exceptions(
    tmp_path: Path, name: str, again: int
) -> None:
    store = tmp_path / "store"
    settings = AssessSettings(
        "go1", controller_under_test(name), Scorecard("few", **QUIET), store=str(store)
    )
    first = run_assess(settings)
    kept = store.read_text().count("\n")
    assert run_assess(settings)["push"] == first["push"]
    assert store.read_text().count("\n") == kept + again


def test_failed_stand_is_filmed_when_no_push_has_a_result(tmp_path: Path) -> None:
    settings = AssessSettings(
        "go1", controller_under_test("kills_process"), Scorecard("few", **QUIET)
    )
    limits = PushLimits(settings.build())
    found = {
        work.unit.key: {"passed": False} if isinstance(work.unit, StandUnit) else {"broken": "died"}
        for work in planned_work(settings, limits)
    }
    films = list(films_of_failures(settings, limits, found, tmp_path))
    assert [film.caption for film in films] == ["failed stand: level ground, heading 0 deg, seed 0"]


def test_scorecard_is_read_from_a_string_path(tmp_path: Path) -> None:
    file = tmp_path / "few.toml"
    file.write_text("directions = 3\n")
    assert read_scorecard(str(file)) == read_scorecard(file) == Scorecard("few", directions=3)
