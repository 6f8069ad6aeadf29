# SPDX-License-Identifier: BSD-3-Clause
"""The search for gains: what it finds, and what happens when workers, stores and disks fail."""

from __future__ import annotations

import json
import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from surefoot import Error, Gains, get_gain, load_gains, load_robot
from surefoot.sim import PlantSettings
from surefoot.tune.search.episodes import Episode
from surefoot.tune.search.rollout import BROKEN, Job, judged
from surefoot.tune.search.run import named, run_search
from surefoot.tune.search.settings import SearchSettings
from surefoot.tune.search.space import apply, default_space, parse_parameter
from surefoot.tune.search.store import open_store
from surefoot.tune.search.summary import summarise
from surefoot.tune.search.workers import Cluster, Processes, Queue

OWN = load_robot("go1").config.gains
ALL = {p.name: p.get(OWN) for p in default_space()}
POOR = apply({k: 0.5 * v if k.endswith("frequency") else 0.3 for k, v in ALL.items()}, OWN)
EPISODE = Episode("go1", 1, PlantSettings())
SHORT = ("--trials", "6", "--episodes", "1", "--held-out", "1", "--jobs", "1")


def search(*words: str, **more) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command(*words), capture_output=True, text=True, timeout=240, **more)


def command(*words: str) -> list[str]:
    return [sys.executable, "-m", "surefoot.cli", "tune", "search", *words]


def finished(store: Path) -> int:
    """Trials that a journal says are done: entries of operation 6 with state COMPLETE (1)."""
    if not store.exists():
        return 0
    lines = [line for line in store.read_text().splitlines() if line.endswith("}")]
    entries = [json.loads(line) for line in lines]
    return sum(1 for e in entries if e["op_code"] == 6 and e.get("state") == 1)


def test_frequencies_and_damping_are_stiffness_and_damping_seen_otherwise() -> None:
    again = apply(ALL, Gains())
    for name in ("com_kp_horizontal", "base_kd_tilt", "foot_kp", "com_kd_vertical"):
        assert get_gain(again, name) == pytest.approx(get_gain(OWN, name), rel=1e-12)
    only = apply({"sway_frequency": 2.0 * ALL["sway_frequency"]}, OWN)
    assert only.com_kp_horizontal == pytest.approx(4.0 * OWN.com_kp_horizontal)
    assert only.com_kd_horizontal == pytest.approx(2.0 * OWN.com_kd_horizontal)
    assert only.base_kp_tilt == OWN.base_kp_tilt


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("sway_frequncy", "did you mean 'sway_frequency'?"),
        ("weight_force=1", "expected weight_force=LOW:HIGH"),
        ("weight_force=0:1", "expected 0 < LOW < HIGH within 1e-06 .. 100"),
        ("weight_force=0.1:1000", "within 1e-06 .. 100"),
        ("sway_damping=1:0.5", "expected 0 < LOW < HIGH within 0.2 .. 2.5"),
    ],
)
def test_what_cannot_be_searched_is_refused_by_name(text: str, words: str) -> None:
    with pytest.raises(Error) as caught:
        parse_parameter(text)
    assert words in str(caught.value)


def test_an_episode_is_the_same_every_time_and_another_with_another_seed() -> None:
    job = Job(named(OWN), (EPISODE,), ("balance",))
    first, again = judged(job), judged(job)
    assert first.costs == again.costs and first.terms == again.terms
    assert first.ticks == 3300 and first.steps == 6600 and first.falls == 0
    other = judged(Job(named(OWN), (Episode("go1", 2, PlantSettings()),), ("balance",)))
    assert other.costs != first.costs


def test_a_fall_costs_more_than_anything_else_and_is_finite() -> None:
    limp = OWN.__copy__()
    limp.com_kp_horizontal = limp.com_kd_horizontal = 0.0
    limp.base_kp_tilt = limp.base_kd_tilt = 0.0
    limp.fall_tilt = 0.1
    fallen = judged(Job(named(limp), (EPISODE,), ("balance",)))
    stood = judged(Job(named(POOR), (EPISODE,), ("balance",)))
    assert fallen.falls == 1 and 100.0 < fallen.costs[0] < BROKEN
    assert stood.falls == 0 and stood.costs[0] < 50.0


def test_a_hopeless_trial_is_not_run_to_its_end() -> None:
    episodes = tuple(Episode("go1", seed, PlantSettings()) for seed in range(1, 4))
    outcome = judged(Job(named(POOR), episodes, ("balance",), hopeless=1.0))
    assert outcome.stopped and outcome.episodes == 1
    assert outcome.costs[0] > 1.0


def test_a_search_from_poor_gains_finds_better_ones_and_says_so() -> None:
    settings = SearchSettings("go1", POOR, trials=24, episodes=1, held_out=1)
    summary = summarise(run_search(settings, OWN))
    assert summary["trials"] == 24
    assert summary["best"] < 0.75 * summary["start"]
    assert summary["best_on_held_seeds"] < summary["start_on_held_seeds"]
    assert summary["rollouts"]["ticks_per_cpu_s"] > 0.0
    assert set(summary["importance"]) == set(ALL)
    json.dumps(summary, allow_nan=False)


def test_two_objectives_make_a_front_that_nothing_is_better_than() -> None:
    settings = SearchSettings(
        "go1", POOR, trials=8, episodes=1, held_out=1, objectives=("balance", "power")
    )
    result = run_search(settings, OWN)
    costs = [tuple(trial.values) for trial in result.trials]
    front = [tuple(trial.values) for trial in result.front]
    assert front
    for point in front:
        assert not any(c[0] <= point[0] and c[1] <= point[1] and c != point for c in costs)


def test_a_worker_that_is_killed_takes_no_trial_with_it() -> None:
    crew = Processes(2)
    try:
        queue = Queue(crew)
        for number in range(6):
            queue.put(number, Job(named(OWN), (EPISODE,), ("balance",)))
        done = queue.take()
        victim = next(iter(crew._pool._processes))  # type: ignore[union-attr]
        os.kill(victim, signal.SIGKILL)
        while len(queue):
            done += queue.take()
    finally:
        crew.close()
    assert sorted(number for number, _ in done) == list(range(6))
    assert len({outcome.costs for _, outcome in done}) == 1
    assert done[0][1].costs[0] < BROKEN


def test_a_search_that_is_killed_goes_on_with_every_trial_it_had(tmp_path: Path) -> None:
    store, gains = tmp_path / "trials.log", tmp_path / "best.toml"
    words = ("--trials", "12", *SHORT[2:], "--store", str(store), "--toml", str(gains))
    running = subprocess.Popen(command(*words), start_new_session=True)
    deadline = time.monotonic() + 120.0
    while finished(store) < 3 and time.monotonic() < deadline:
        time.sleep(0.05)
    os.killpg(running.pid, signal.SIGKILL)
    running.wait()
    before = finished(store)
    assert 3 <= before < 12
    with store.open("a") as handle:
        handle.write('{"op_code": 6, "worker')  # killed while it wrote
    again = search(*words, "--json", "-")
    assert again.returncode == 0, again.stderr
    summary = json.loads(again.stdout)
    assert summary["trials"] == 12 == finished(store)
    assert named(load_gains(gains)) == summary["gains"]


@pytest.mark.parametrize("content", ["no journal\n", "{}\n", "[1, 2]\n", "garbage without an end"])
def test_a_corrupt_store_is_refused_and_left_alone(tmp_path: Path, content: str) -> None:
    store = tmp_path / "trials.log"
    store.write_text(content)
    run = search(*SHORT, "--store", str(store))
    assert run.returncode == 2
    assert run.stderr.count("\n") == 1
    assert f"store '{store}': line 1 is no journal entry" in run.stderr
    assert store.read_text() == content
    assert list(tmp_path.iterdir()) == [store]


def test_a_store_that_another_search_is_at_work_in_is_refused(tmp_path: Path) -> None:
    store = str(tmp_path / "trials.log")
    with open_store(store):
        run = search(*SHORT, "--store", store)
    assert run.returncode == 2
    assert f"store '{store}': another search is at work in it" in run.stderr


def test_a_store_of_another_search_is_refused(tmp_path: Path) -> None:
    store = str(tmp_path / "trials.log")
    settings = {"trials": 1, "episodes": 1, "held_out": 1, "store": store}
    run_search(SearchSettings("go1", OWN, **settings), OWN)
    with pytest.raises(Error, match="holds another search, which differs in start, seed"):
        run_search(SearchSettings("go1", POOR, seed=3, **settings), OWN)


def test_a_full_disk_ends_the_search_in_one_line_with_its_trials_kept(tmp_path: Path) -> None:
    store = tmp_path / "trials.log"

    def little_space() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))

    run = search("--trials", "50", *SHORT[2:], "--store", str(store), preexec_fn=little_space)
    assert run.returncode == 1
    assert run.stderr.count("\n") == 1 and "File too large" in run.stderr
    kept = finished(store)
    assert kept >= 3
    more = search("--trials", str(kept + 1), *SHORT[2:], "--store", str(store), "--json", "-")
    assert more.returncode == 0, more.stderr
    assert json.loads(more.stdout)["trials"] == kept + 1


def test_a_scheduler_that_is_not_there_is_named(monkeypatch) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("surefoot.tune.search.workers.CLUSTER_TIMEOUT", 1.0)
    with pytest.raises(Error, match=r"cluster 'tcp://127\.0\.0\.1:1': no scheduler there"):
        Cluster("tcp://127.0.0.1:1")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--objective", "balanse"), "objective: got 'balanse', expected one of balance, quiet"),
        (("--objective", "quiet,quiet"), "expected one, or two that differ"),
        (("--trials", "0"), "trials: got 0, expected a whole number 1 .. "),
        (("--sampler", "gp"), "sampler: got 'gp', expected one of cmaes, tpe, nsga2, random"),
        (("--gain", "foot_kpp"), "did you mean 'foot_kp'?"),
        (("--from", "/no/such.toml"), "cannot read '/no/such.toml'"),
        (("--store", "/no/such/folder/x"), "--store: got '/no/such/folder/x'"),
    ],
)
def test_a_wrong_option_is_one_line(words: tuple[str, ...], message: str) -> None:
    run = search(*SHORT, *words)
    assert run.returncode == 2
    assert run.stderr.count("\n") == 1
    assert message in run.stderr
