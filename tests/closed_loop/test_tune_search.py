# SPDX-License-Identifier: BSD-3-Clause
"""surefoot tune search: its results, and failures of workers, stores and disks."""

from __future__ import annotations

import json
import math
import os
import resource
import signal
import subprocess
import sys
import time
from concurrent.futures import BrokenExecutor, Future
from pathlib import Path

import optuna
import pytest
from surefoot import Error, Gains, get_gain, load_gains, load_robot
from surefoot.cli import main
from surefoot.robot.gain_files import gain_values
from surefoot.sim import PlantSettings
from surefoot.tune.search.final_evaluation import select_best_trial
from surefoot.tune.search.rollout import BROKEN_COST, Outcome, TrialJob, evaluate_exclusively
from surefoot.tune.search.run import run_search
from surefoot.tune.search.settings import SearchSettings
from surefoot.tune.search.space import apply_parameters, default_space, parse_parameter
from surefoot.tune.search.stand_episode import StandEpisode
from surefoot.tune.search.summary import summarise
from surefoot.tune.search.trial_journal import open_trial_journal
from surefoot.tune.search.trial_queue import TrialQueue
from surefoot.tune.search.worker_pool import DaskCluster, ProcessPool

pytestmark = pytest.mark.slow

OWN = load_robot("go1").config.gains
ALL = {p.name: p.get(OWN) for p in default_space()}
POOR = apply_parameters(
    {k: 0.5 * v if k.endswith("frequency") else 0.3 for k, v in ALL.items()}, OWN
)
EPISODE = StandEpisode("go1", 1, PlantSettings())
SHORT_SEARCH = ("--trials", "6", "--episodes", "1", "--held-out", "1", "--jobs", "1")


def search(*words: str, **more) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command(*words), capture_output=True, text=True, timeout=240, **more)


def refusal(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    """Return the error line of a search that is refused; it runs in this process."""
    assert main(["tune", "search", *words]) == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    return error


def command(*words: str) -> list[str]:
    return [sys.executable, "-m", "surefoot.cli", "tune", "search", *words]


def finished(store: Path) -> int:
    """Count the finished trials of a journal: entries of operation 6 with state COMPLETE (1)."""
    if not store.exists():
        return 0
    lines = [line for line in store.read_text().splitlines() if line.endswith("}")]
    entries = [json.loads(line) for line in lines]
    return sum(1 for e in entries if e["op_code"] == 6 and e.get("state") == 1)


def test_frequency_and_damping_parameters_convert_to_kp_and_kd() -> None:
    again = apply_parameters(ALL, Gains())
    for name in ("com_kp_horizontal", "base_kd_tilt", "foot_kp", "com_kd_vertical"):
        assert get_gain(again, name) == pytest.approx(get_gain(OWN, name), rel=1e-12)
    only = apply_parameters({"sway_frequency": 2.0 * ALL["sway_frequency"]}, OWN)
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
def test_invalid_search_parameter_is_refused(text: str, words: str) -> None:
    with pytest.raises(Error) as caught:
        parse_parameter(text)
    assert words in str(caught.value)


def test_episode_is_repeatable_and_depends_on_the_seed() -> None:
    job = TrialJob(gain_values(OWN), (EPISODE,), ("balance",))
    first, again = evaluate_exclusively(job), evaluate_exclusively(job)
    assert first.costs == again.costs and first.terms == again.terms
    assert first.ticks == 3300 and first.steps == 6600 and first.falls == 0
    other = evaluate_exclusively(
        TrialJob(gain_values(OWN), (StandEpisode("go1", 2, PlantSettings()),), ("balance",))
    )
    assert other.costs != first.costs


def test_hopeless_trial_is_stopped_early() -> None:
    episodes = tuple(StandEpisode("go1", seed, PlantSettings()) for seed in range(1, 4))
    outcome = evaluate_exclusively(
        TrialJob(gain_values(POOR), episodes, ("balance",), stop_cost=1.0)
    )
    assert outcome.stopped and outcome.episodes == 1
    assert outcome.costs[0] > 1.0


def test_search_from_poor_gains_finds_better_gains() -> None:
    settings = SearchSettings("go1", POOR, trials=24, episodes=1, held_out=1)
    summary = summarise(run_search(settings, OWN))
    assert summary["trials"] == 24
    assert summary["best"] < 0.75 * summary["start"]
    assert summary["best_on_held_seeds"] < summary["start_on_held_seeds"]
    assert summary["rollouts"]["ticks_per_cpu_s"] > 0.0
    assert set(summary["importance"]) == set(ALL)
    json.dumps(summary, allow_nan=False)


def test_two_objectives_give_a_pareto_front() -> None:
    settings = SearchSettings(
        "go1", POOR, trials=8, episodes=1, held_out=1, objectives=("balance", "power")
    )
    result = run_search(settings, OWN)
    costs = [tuple(trial.values) for trial in result.trials]
    front = [tuple(trial.values) for trial in result.front]
    assert front
    for point in front:
        assert not any(c[0] <= point[0] and c[1] <= point[1] and c != point for c in costs)


def test_killed_worker_loses_no_trial() -> None:
    worker_pool = ProcessPool(2)
    try:
        queue = TrialQueue(worker_pool)
        for number in range(6):
            queue.put(number, TrialJob(gain_values(OWN), (EPISODE,), ("balance",)))
        done = queue.take()
        victim = next(iter(worker_pool._pool._processes))
        os.kill(victim, signal.SIGKILL)
        while len(queue):
            done += queue.take()
    finally:
        worker_pool.close()
    assert sorted(number for number, _ in done) == list(range(6))
    assert len({outcome.costs for _, outcome in done}) == 1
    assert done[0][1].costs[0] < BROKEN_COST


def test_killed_search_resumes_with_all_its_trials(tmp_path: Path) -> None:
    store, gains = tmp_path / "trials.log", tmp_path / "best.toml"
    words = ("--trials", "12", *SHORT_SEARCH[2:], "--store", str(store), "--toml", str(gains))
    running = subprocess.Popen(command(*words), start_new_session=True)
    deadline = time.monotonic() + 120.0
    while finished(store) < 3 and time.monotonic() < deadline:
        time.sleep(0.05)
    os.killpg(running.pid, signal.SIGKILL)
    running.wait()
    before = finished(store)
    assert 3 <= before < 12
    with store.open("a") as handle:
        handle.write('{"op_code": 6, "worker')  # as if killed during a write
    again = search(*words, "--json", "-")
    assert again.returncode == 0, again.stderr
    summary = json.loads(again.stdout)
    assert summary["trials"] == 12 == finished(store)
    assert gain_values(load_gains(gains)) == summary["gains"]


@pytest.mark.parametrize("content", ["no journal\n", "{}\n", "[1, 2]\n", "garbage without an end"])
def test_corrupt_store_is_refused_and_unchanged(
    tmp_path: Path, content: str, capsys: pytest.CaptureFixture[str]
) -> None:
    store = tmp_path / "trials.log"
    store.write_text(content)
    error = refusal(capsys, *SHORT_SEARCH, "--store", str(store))
    assert f"store '{store}': line 1 is not a journal entry" in error
    assert store.read_text() == content
    assert list(tmp_path.iterdir()) == [store]


def test_store_in_use_by_another_search_is_refused(tmp_path: Path) -> None:
    store = str(tmp_path / "trials.log")
    with open_trial_journal(store):
        run = search(*SHORT_SEARCH, "--store", store)
    assert run.returncode == 2
    assert f"store '{store}': another search uses it" in run.stderr


def test_a_store_of_another_search_is_refused(tmp_path: Path) -> None:
    store = str(tmp_path / "trials.log")
    settings = {"trials": 1, "episodes": 1, "held_out": 1, "store": store}
    run_search(SearchSettings("go1", OWN, **settings), OWN)
    with pytest.raises(Error, match="holds another search, which differs in start, seed"):
        run_search(SearchSettings("go1", POOR, seed=3, **settings), OWN)


def test_full_disk_ends_the_search_and_keeps_its_trials(tmp_path: Path) -> None:
    store = tmp_path / "trials.log"

    def limit_file_size() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))

    run = search(
        "--trials", "50", *SHORT_SEARCH[2:], "--store", str(store), preexec_fn=limit_file_size
    )
    assert run.returncode == 1
    assert run.stderr.count("\n") == 1 and "File too large" in run.stderr
    kept = finished(store)
    assert kept >= 3
    more = search(
        "--trials", str(kept + 1), *SHORT_SEARCH[2:], "--store", str(store), "--json", "-"
    )
    assert more.returncode == 0, more.stderr
    assert json.loads(more.stdout)["trials"] == kept + 1


def test_missing_scheduler_is_named(monkeypatch) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("surefoot.tune.search.worker_pool.CLUSTER_TIMEOUT", 1.0)
    with pytest.raises(Error, match=r"cluster 'tcp://127\.0\.0\.1:1': no scheduler answers"):
        DaskCluster("tcp://127.0.0.1:1")


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
def test_invalid_search_option_gives_one_error_line(
    words: tuple[str, ...], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert message in refusal(capsys, *SHORT_SEARCH, *words)


class FakeWorkerPool:
    """A fake pool: `answers` returns the outcome or the exception of each job."""

    count = 2
    worker_death_errors = (BrokenExecutor,)

    def __init__(self, answers) -> None:
        self.answers, self.renewed, self.gone = answers, 0, False

    def submit(self, job: TrialJob) -> Future:
        future: Future = Future()
        answer = self.answers(job)
        if isinstance(answer, BaseException):
            future.set_exception(answer)
        else:
            future.set_result(answer)
        return future

    def restart_workers(self) -> None:
        self.renewed += 1

    def check(self) -> None:
        if self.gone:
            raise Error("the scheduler is gone")


def job_of(cost: float) -> TrialJob:
    return TrialJob({"foot_kp": cost}, (EPISODE,), ("balance",))


def test_only_the_trial_that_kills_its_workers_is_broken() -> None:
    def answer(job: TrialJob):
        kills_worker = job.gains["foot_kp"] == 2.0
        return BrokenExecutor("died") if kills_worker else Outcome(costs=(job.gains["foot_kp"],))

    worker_pool = FakeWorkerPool(answer)
    queue = TrialQueue(worker_pool)
    for number in range(5):
        queue.put(number, job_of(float(number)))
    done = {}
    while len(queue):
        done.update(queue.take())
    assert {n: o.costs[0] for n, o in done.items()} == {
        0: 0.0,
        1: 1.0,
        2: BROKEN_COST,
        3: 3.0,
        4: 4.0,
    }
    assert [n for n, o in done.items() if o.broken] == [2]


def test_a_worker_that_cannot_run_trials_ends_the_search_with_its_reason() -> None:
    queue = TrialQueue(
        FakeWorkerPool(lambda job: ModuleNotFoundError("No module named 'surefoot'"))
    )
    queue.put(0, job_of(1.0))
    with pytest.raises(Error, match="cannot run trials: ModuleNotFoundError: No module named"):
        queue.take()


def test_lost_scheduler_ends_the_search(monkeypatch) -> None:
    monkeypatch.setattr("surefoot.tune.search.trial_queue.POLL_PERIOD", 0.01)
    worker_pool = FakeWorkerPool(lambda job: Outcome(costs=(1.0,)))
    worker_pool.submit = lambda job: Future()  # type: ignore[method-assign] # no answer arrives
    worker_pool.gone = True
    queue = TrialQueue(worker_pool)
    queue.put(0, job_of(1.0))
    with pytest.raises(Error, match="the scheduler is gone"):
        queue.take()


def test_job_lost_with_a_broken_pool_is_run_again(monkeypatch) -> None:
    monkeypatch.setattr("surefoot.tune.search.trial_queue.POLL_PERIOD", 0.01)
    worker_pool = FakeWorkerPool(lambda job: Outcome(costs=(1.0,)))
    answer, worker_pool.submit = worker_pool.submit, lambda job: Future()  # type: ignore[method-assign]
    queue = TrialQueue(worker_pool)
    queue.put(0, job_of(1.0))

    def look() -> None:
        worker_pool.submit = answer  # type: ignore[method-assign]
        raise BrokenExecutor

    monkeypatch.setattr(worker_pool, "check", look)
    assert [(number, outcome.costs) for number, outcome in queue.take()] == [(0, (1.0,))]


def test_pool_broken_between_trials_is_replaced() -> None:
    worker_pool = ProcessPool(1)
    try:
        queue = TrialQueue(worker_pool)
        for number in range(2):
            queue.put(number, TrialJob(gain_values(OWN), (EPISODE,), ("balance",)))
            outcomes = queue.take()
            assert outcomes[0][1].costs[0] < BROKEN_COST
            victim = next(iter(worker_pool._pool._processes))
            os.kill(victim, signal.SIGKILL)
            time.sleep(0.5)  # the pool detects it in this time
    finally:
        worker_pool.close()


def test_workers_end_when_the_search_is_killed(tmp_path: Path) -> None:
    running = subprocess.Popen(command("--trials", "500", *SHORT_SEARCH[2:]))
    children: list[int] = []
    deadline = time.monotonic() + 60.0
    while not children and time.monotonic() < deadline:
        path = Path(f"/proc/{running.pid}/task/{running.pid}/children")
        children = [int(pid) for pid in path.read_text().split()]
        time.sleep(0.1)
    time.sleep(3.0)
    running.kill()
    running.wait()
    while any(Path(f"/proc/{pid}").exists() for pid in children):
        assert time.monotonic() < deadline + 30.0
        time.sleep(0.1)


def test_gain_and_its_frequency_parameter_cannot_be_searched_together() -> None:
    space = tuple(parse_parameter(name) for name in ("sway_frequency", "com_kp_horizontal"))
    with pytest.raises(Error, match="got sway_frequency and com_kp_horizontal, expected one"):
        SearchSettings("go1", OWN, space=space)


def test_foot_gains_are_searched_by_their_own_name() -> None:
    assert parse_parameter("foot_kp").get(OWN) == OWN.foot_kp
    assert parse_parameter("foot_kd").get(OWN) == OWN.foot_kd


def test_search_range_includes_the_start_and_refuses_a_start_of_0() -> None:
    slow = apply_parameters({"sway_frequency": 0.3, "sway_damping": 0.25}, OWN)
    slow.com_kp_horizontal = 0.5
    settings = SearchSettings("go1", slow)
    sway = next(p for p in settings.space if p.name == "sway_frequency")
    assert sway.low == pytest.approx(math.sqrt(0.5) / (2.0 * math.pi))
    with pytest.raises(Error, match="got start value 0 of weight_momentum, expected above 0"):
        SearchSettings("go1", OWN, space=(parse_parameter("weight_momentum"),))


def test_inconsistent_gains_are_a_failed_trial_and_the_search_continues() -> None:
    names = ("contact_force_on", "contact_force_off")
    space = tuple(parse_parameter(name) for name in names)
    settings = SearchSettings(
        "go1", OWN, trials=8, episodes=1, held_out=1, space=space, sampler="random"
    )
    summary = summarise(run_search(settings, OWN))
    assert summary["trials"] == 8
    assert 1 <= summary["failures"] < 8


def test_resumed_search_draws_new_parameters(tmp_path: Path) -> None:
    settings = {"episodes": 1, "held_out": 1, "sampler": "tpe", "store": str(tmp_path / "x")}
    run_search(SearchSettings("go1", OWN, trials=2, **settings), OWN)
    result = run_search(SearchSettings("go1", OWN, trials=5, **settings), OWN)
    drawn = {tuple(trial.params.values()) for trial in result.trials}
    assert len(result.trials) == len(drawn) == 5


def test_truncated_or_foreign_search_store_is_refused(tmp_path: Path) -> None:
    store = tmp_path / "trials.log"
    run_search(SearchSettings("go1", OWN, trials=2, episodes=1, held_out=1, store=str(store)), OWN)
    lines = store.read_text().splitlines(keepends=True)
    for text, words in (
        ("".join(lines[1:]), "its beginning is missing"),
        ('{"op_code": 99}\n', "not a journal of trials"),
        (lines[0].replace('"surefoot"', '"theirs"'), "holds theirs, expected a search"),
        ("".join(lines[:3]) + "rubbish\n" + "".join(lines[3:]), "line 4 is not a journal entry"),
    ):
        store.write_text(text)
        run = search(*SHORT_SEARCH, "--store", str(store))
        assert run.returncode == 2, text[:100]
        assert words in run.stderr
        assert store.read_text() == text


@pytest.mark.parametrize("objective", ["balance", "quiet", "power"])
def test_standing_costs_less_than_a_fall(objective: str) -> None:
    stiff = apply_parameters({"sway_frequency": 6.0, "sway_damping": 2.5}, OWN)
    weak = OWN.__copy__()
    weak.fall_tilt = 0.1
    weak.com_kp_horizontal = weak.com_kd_horizontal = 0.0
    weak.base_kp_tilt = weak.base_kd_tilt = 0.0
    stood, fallen = (
        evaluate_exclusively(TrialJob(gain_values(g), (EPISODE,), (objective,)))
        for g in (stiff, weak)
    )
    assert (stood.falls, fallen.falls) == (0, 1)
    assert stood.costs[0] <= 100.0 < fallen.costs[0] <= 300.0 < BROKEN_COST


def test_lucky_trial_loses_the_final_evaluation() -> None:
    settings = SearchSettings("go1", OWN, space=(parse_parameter("sway_frequency"),))
    scale = optuna.distributions.FloatDistribution(0.3, 6.0, log=True)
    trials = [
        optuna.create_trial(
            params={"sway_frequency": f}, distributions={"sway_frequency": scale}, value=cost
        )
        for f, cost in ((1.0, 3.0), (1.5, 3.2), (2.0, 9.0))
    ]

    def answer(job: TrialJob):
        lucky = job.gains["com_kp_horizontal"] < 50.0  # 1 Hz
        return Outcome(costs=(5.0 if lucky else 3.2,), episodes=1)

    best = select_best_trial(settings, FakeWorkerPool(answer), trials, (9.0,))
    assert best.params == {"sway_frequency": 1.5}
