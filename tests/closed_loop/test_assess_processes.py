# SPDX-License-Identifier: BSD-3-Clause
"""Controllers that take their process along, processes that cannot start, and who goes on later."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import pytest
from surefoot.assess import AssessSettings, Card, Condition, Contestant, read_card, run_assess
from surefoot.assess.crew import run_all
from surefoot.assess.films import failures
from surefoot.assess.plan import works
from surefoot.assess.push_limits import Limits
from surefoot.assess.unit import StandUnit
from surefoot.assess.worker import Work

LEVEL = Condition("level ground", quiet_s=0.1)
QUIET = {"directions": 1, "seeds": 1, "condition_seeds": 1, "faults": "none"}


def contestant(name: str) -> Contestant:
    return Contestant(f"assess_contestants:{name}")


@pytest.mark.parametrize(
    ("name", "words"),
    [("never", "never returned: no run ended in 1 s"), ("dies", "died with exit status 7")],
)
def test_a_controller_that_takes_its_process_along_is_marked_and_the_run_goes_on(
    name: str, words: str
) -> None:
    card = Card("few", directions=2, seeds=1, condition_seeds=0, faults="none")
    result = run_assess(AssessSettings("go1", contestant(name), card, deadline=1.0))
    rows = result["push"]["tables"][0]["directions"]
    assert len(rows) == 2 and all(words in row["broken"][0] for row in rows)
    assert result["push"]["survive_percent_of_limit_p5"] == 0.0


def test_a_stall_costs_a_contestant_nothing_that_has_returned_before(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("STALLS", str(tmp_path))
    card = Card("few", directions=3, seeds=1, condition_seeds=0, faults="none")
    result = run_assess(AssessSettings("go1", contestant("stalls_once"), card, deadline=2.0))
    assert result["push"]["broken"] == []
    assert len(list(tmp_path.iterdir())) == 10  # three a unit; the second unit began again


def test_a_process_that_dies_between_its_units_spoils_none() -> None:
    units = [Work(StandUnit(LEVEL, 0.0, seed), contestant("dies_idle")) for seed in range(3)]
    found = []
    for _, result in run_all(units, "go1", 1, 20.0):
        found.append(result)
        time.sleep(1.0)  # a slow disk, say: the process is dead by the time it is given more
    assert len(found) == 3 and not any("broken" in result for result in found)


def test_a_main_module_that_others_cannot_import_is_told_and_nobody_is_blamed(
    tmp_path: Path,
) -> None:
    (tmp_path / "card.toml").write_text("directions = 1\nseeds = 1\nfaults = 'none'\n")
    script = tmp_path / "unguarded.py"
    script.write_text(
        "from surefoot.assess import AssessSettings, Contestant, read_card, run_assess\n"
        "run_assess(AssessSettings('go1', Contestant('pd'), read_card('card.toml')))\n"
    )
    words = [sys.executable, str(script)]
    ended = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert ended.returncode != 0
    assert (
        "expected a main module that others can import, with all it does under if" in ended.stderr
    )


@pytest.mark.parametrize(("name", "again"), [("throws", 0), ("dies", 2)])
def test_who_goes_on_tries_what_was_lost_and_not_what_threw(
    tmp_path: Path, name: str, again: int
) -> None:
    store = tmp_path / "store"
    settings = AssessSettings("go1", contestant(name), Card("few", **QUIET), store=str(store))
    first = run_assess(settings)
    kept = store.read_text().count("\n")
    assert run_assess(settings)["push"] == first["push"]
    assert store.read_text().count("\n") == kept + again


def test_a_stand_that_fails_is_filmed_where_no_push_has_come_to_anything(tmp_path: Path) -> None:
    settings = AssessSettings("go1", contestant("dies"), Card("few", **QUIET))
    limits = Limits(settings.build())
    found = {
        work.unit.key: {"passed": False} if isinstance(work.unit, StandUnit) else {"broken": "died"}
        for work in works(settings, limits)
    }
    films = list(failures(settings, limits, found, tmp_path))
    assert [film.caption for film in films] == ["not passed: level ground, heading 0 deg, seed 0"]


def test_a_card_is_read_from_a_path_in_words(tmp_path: Path) -> None:
    file = tmp_path / "few.toml"
    file.write_text("directions = 3\n")
    assert read_card(str(file)) == read_card(file) == Card("few", directions=3)
