# SPDX-License-Identifier: BSD-3-Clause
"""Runs of the long benchmarks: stored, resumed and reported."""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import pytest
import surefoot

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from seed_runs import Job, RunOutcome, add_seed_options, run_seeds, seeds_of


def play(job: Job) -> RunOutcome:
    """Return an outcome that fails for odd seeds."""
    ok = int(job[-1]) % 2 == 0
    return RunOutcome(ok, "" if ok else f"odd on {job[0]}")


def refuse(job: Job) -> RunOutcome:
    """Fail: no job may run again."""
    raise AssertionError(f"{job} was run")


def stall(job: Job) -> RunOutcome:
    """Raise an exception for seed 0; take 60 s for other seeds."""
    if job[-1] == 0:
        raise ValueError("broken")
    time.sleep(60.0)
    return RunOutcome(True, "")


def options_of(*words: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    add_seed_options(parser, 4)
    return parser.parse_args(words)


def jobs_of(options: argparse.Namespace) -> list[Job]:
    return [("go1", seed) for seed in seeds_of(options)]


def test_results_keep_seed_order_and_are_stored(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = options_of("--jobs", "2", "--first", "3", "--store", str(tmp_path / "store"))
    first = run_seeds(play, RunOutcome, jobs_of(options), options)
    assert [outcome.ok for outcome in first] == [False, True, False, True]
    said = capsys.readouterr().out
    assert sorted(said.splitlines()) == ["go1 seed 3: odd on go1", "go1 seed 5: odd on go1"]
    again = run_seeds(refuse, RunOutcome, jobs_of(options), options)
    assert again == first
    assert sorted(capsys.readouterr().out.splitlines()) == sorted(said.splitlines())


def test_exception_ends_the_run_at_once() -> None:
    options, begin = options_of("--jobs", "2"), time.monotonic()
    with pytest.raises(ValueError, match="broken"):
        run_seeds(stall, RunOutcome, jobs_of(options), options)
    assert time.monotonic() - begin < 50.0


@pytest.mark.parametrize(
    "words", [("--count", "0"), ("--first", "-1"), ("--jobs", "x"), ("--jobs", "0")]
)
def test_invalid_seed_options_are_refused(words: tuple[str, str]) -> None:
    with pytest.raises(SystemExit) as ended:
        options_of(*words)
    assert ended.value.code == 2


@pytest.mark.parametrize("option", ["--store", "--json"])
def test_unwritable_output_is_refused_before_the_run(
    option: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = options_of(option, str(tmp_path / "none" / "file"))
    with pytest.raises(SystemExit) as ended:
        run_seeds(refuse, RunOutcome, jobs_of(options), options)
    assert ended.value.code == 2
    assert f"{option}: got" in capsys.readouterr().err


def test_identity_contains_the_build_and_differs_by_robot() -> None:
    from surefoot.robot.loading import describe_robot, package_digest, robot_identity

    robot = surefoot.load_robot("go1")
    named = robot_identity(describe_robot("go1"), robot)
    assert named["build"] == package_digest() and len(package_digest()) == 16
    assert named != robot_identity(describe_robot("a1"), surefoot.load_robot("a1"))
