# SPDX-License-Identifier: BSD-3-Clause
"""The runs of the long benchmarks: kept, gone on with, said."""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import pytest
import surefoot

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from seed_runs import Job, Outcome, add_seed_options, run_seeds, seeds_of


def play(job: Job) -> Outcome:
    """Odd seeds fail."""
    ok = int(job[-1]) % 2 == 0
    return Outcome(ok, "" if ok else f"odd on {job[0]}")


def refuse(job: Job) -> Outcome:
    """Nobody is to be run again."""
    raise AssertionError(f"{job} was run")


def stall(job: Job) -> Outcome:
    """The first one ends badly, the others not soon."""
    if job[-1] == 0:
        raise ValueError("broken")
    time.sleep(60.0)
    return Outcome(True, "")


def options_of(*words: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    add_seed_options(parser, 4)
    return parser.parse_args(words)


def jobs_of(options: argparse.Namespace) -> list[Job]:
    return [("go1", seed) for seed in seeds_of(options)]


def test_results_come_in_their_order_and_are_kept(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = options_of("--jobs", "2", "--first", "3", "--store", str(tmp_path / "store"))
    first = run_seeds(play, Outcome, jobs_of(options), options)
    assert [outcome.ok for outcome in first] == [False, True, False, True]
    said = capsys.readouterr().out
    assert sorted(said.splitlines()) == ["go1 seed 3: odd on go1", "go1 seed 5: odd on go1"]
    again = run_seeds(refuse, Outcome, jobs_of(options), options)
    assert again == first
    assert sorted(capsys.readouterr().out.splitlines()) == sorted(said.splitlines())


def test_an_error_ends_all_of_it_at_once() -> None:
    options, begin = options_of("--jobs", "2"), time.monotonic()
    with pytest.raises(ValueError, match="broken"):
        run_seeds(stall, Outcome, jobs_of(options), options)
    assert time.monotonic() - begin < 50.0


@pytest.mark.parametrize(
    "words", [("--count", "0"), ("--first", "-1"), ("--jobs", "x"), ("--jobs", "0")]
)
def test_numbers_that_cannot_be_are_refused(words: tuple[str, str]) -> None:
    with pytest.raises(SystemExit) as ended:
        options_of(*words)
    assert ended.value.code == 2


@pytest.mark.parametrize("option", ["--store", "--json"])
def test_a_file_that_cannot_be_is_refused_before_anything_runs(
    option: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = options_of(option, str(tmp_path / "none" / "file"))
    with pytest.raises(SystemExit) as ended:
        run_seeds(refuse, Outcome, jobs_of(options), options)
    assert ended.value.code == 2
    assert f"{option}: got" in capsys.readouterr().err


def test_the_build_tells_installed_code_apart() -> None:
    from surefoot.robots import build, describe_robot, identity

    robot = surefoot.load_robot("go1")
    named = identity(describe_robot("go1"), robot)
    assert named["build"] == build() and len(build()) == 16
    assert named != identity(describe_robot("a1"), surefoot.load_robot("a1"))
