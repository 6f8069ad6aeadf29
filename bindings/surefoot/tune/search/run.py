"""Search loop: Optuna proposes gains, workers evaluate them, and Optuna receives the costs."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import optuna
from optuna.trial import FrozenTrial, Trial, TrialState

from surefoot._core import Error, Gains
from surefoot.robot.gain_files import gain_values
from surefoot.tune.search.final_evaluation import evaluate_gains, select_best_trial
from surefoot.tune.search.rollout import Outcome, TrialJob, broken
from surefoot.tune.search.sampling import importance, make_sampler
from surefoot.tune.search.settings import SearchSettings
from surefoot.tune.search.space import apply_parameters
from surefoot.tune.search.trial_journal import (
    START,
    open_or_create_study,
    open_trial_journal,
    requeue_interrupted_trials,
)
from surefoot.tune.search.trial_queue import TrialQueue
from surefoot.tune.search.worker_pool import WorkerPool, open_worker_pool

# Ratio of a trial's cost to the best cost above which the trial stops. Chosen: with a smaller
# ratio, one unlucky episode could stop a good trial. With a larger ratio, bad trials take longer.
STOP_COST_RATIO = 3.0

Progress = Callable[[int, int, float], None]
"""Function progress(done, total, best): finished trials, all trials, best cost so far."""


@dataclass(frozen=True)
class Candidate:
    """Set of gains and its costs.

    Attributes:
        gains: The gains.
        held_out: Outcome on the held-out episodes.
        search_costs: Costs on the search episodes; empty if no trial had these gains.
    """

    gains: Gains
    held_out: Outcome
    search_costs: tuple[float, ...] = ()


@dataclass(frozen=True)
class SearchResult:
    """Result of a search.

    Attributes:
        settings: Settings of the search.
        trials: All finished trials, in the order in which they began.
        start, own, best: Start gains, the robot's own gains, and the result of select_best_trial().
        front: Trials of the Pareto front; empty with one objective.
        importance: Importance of each parameter for the cost; empty with too few trials.
        speed: Speed of the rollouts of this process.
    """

    settings: SearchSettings
    trials: list[FrozenTrial]
    start: Candidate
    own: Candidate
    best: Candidate
    front: list[FrozenTrial]
    importance: dict[str, float]
    speed: dict[str, float]


def run_search(
    settings: SearchSettings, own: Gains, progress: Progress | None = None
) -> SearchResult:
    """Run a search to its end, or resume the search in the store.

    Args:
        settings: Settings of the search.
        own: The robot's own gains, for comparison.
        progress: Called after each trial.

    Raises:
        Error: An invalid store, cluster or setting, or an episode that cannot be run.
        OSError: The store cannot be written. The trials that are in the store stay there.
    """
    with (
        open_trial_journal(settings.store) as storage,
        open_worker_pool(settings.jobs, settings.cluster) as worker_pool,
    ):
        study = open_or_create_study(storage, settings)
        requeue_interrupted_trials(study)
        if not study.get_trials(deepcopy=False):
            values = {p.name: p.get(settings.start) for p in settings.space}
            study.enqueue_trial(values, user_attrs={START: True})
        study.sampler = make_sampler(settings, len(study.get_trials(deepcopy=False)))
        search = _Search(settings, study, worker_pool, progress)
        search.run()
        trials = study.get_trials(deepcopy=False, states=(TrialState.COMPLETE,))
        first = next((t for t in trials if t.user_attrs.get(START)), None)
        start_costs = tuple(first.values) if first is not None else ()
        best = select_best_trial(
            settings, worker_pool, trials, start_costs or tuple(trials[0].values)
        )
        chosen = [settings.start, own, apply_parameters(best.params, settings.start)]
        held_out = evaluate_gains(settings, worker_pool, chosen, settings.held_out_episodes)
        return SearchResult(
            settings,
            trials,
            Candidate(chosen[0], held_out[0], start_costs),
            Candidate(chosen[1], held_out[1]),
            Candidate(chosen[2], held_out[2], tuple(best.values)),
            list(study.best_trials) if len(settings.objectives) == 2 else [],
            importance(study, trials),
            search.speed(),
        )


class _Search:
    """Loop of one run of a search, and its speed."""

    def __init__(
        self,
        settings: SearchSettings,
        study: optuna.Study,
        worker_pool: WorkerPool,
        progress: Progress | None,
    ) -> None:
        self._settings, self._study, self._worker_pool = settings, study, worker_pool
        self._progress = progress
        self._episodes = settings.search_episodes
        self._distributions: dict[str, optuna.distributions.BaseDistribution] = {
            p.name: optuna.distributions.FloatDistribution(p.low, p.high, log=True)
            for p in settings.space
        }
        done = study.get_trials(deepcopy=False, states=(TrialState.COMPLETE,))
        self._running_trials: dict[int, Trial] = {}
        self._done = len(done)
        self._best = min((trial.values[0] for trial in done), default=float("inf"))
        self._totals, self._wall_time = Outcome(), 0.0

    def run(self) -> None:
        """Run trials until the store has settings.trials."""
        queue, begin = TrialQueue(self._worker_pool), time.monotonic()
        while self._done < self._settings.trials:
            while len(queue) < min(self._worker_pool.count, self._settings.trials - self._done):
                self._submit_next(queue)
            if len(queue):
                for number, outcome in queue.take():
                    self._record_outcome(number, outcome)
        self._wall_time = time.monotonic() - begin

    def _submit_next(self, queue: TrialQueue) -> None:
        trial = self._study.ask(self._distributions)
        self._running_trials[trial.number] = trial
        objectives = self._settings.objectives
        # With two objectives no trial stops early: the second cost may be low.
        stop_cost = STOP_COST_RATIO * self._best if len(objectives) == 1 else float("inf")
        try:
            gains = apply_parameters(trial.params, self._settings.start)
        except Error:  # the single values are valid, but their combination is not
            self._record_outcome(trial.number, broken(TrialJob({}, (), objectives)))
            return
        queue.put(trial.number, TrialJob(gain_values(gains), self._episodes, objectives, stop_cost))

    def _record_outcome(self, number: int, outcome: Outcome) -> None:
        trial = self._running_trials.pop(number)
        for name in ("falls", "stopped", "broken", "episodes", "terms"):
            trial.set_user_attr(name, getattr(outcome, name))
        self._study.tell(trial, list(outcome.costs))
        self._done += 1
        self._best = min(self._best, outcome.costs[0])
        for name in ("simulated_time", "cpu_time", "ticks", "steps"):
            total = getattr(self._totals, name) + getattr(outcome, name)
            setattr(self._totals, name, total)
        if self._progress is not None:
            self._progress(self._done, self._settings.trials, self._best)

    def speed(self) -> dict[str, float]:
        """Return the speed of this run's rollouts; rollouts of earlier runs do not count."""
        totals, seconds, wall = self._totals, self._totals.cpu_time, self._wall_time
        if seconds <= 0.0 or wall <= 0.0:
            return {}
        return {
            "workers": self._worker_pool.count,
            "wall_s": wall,
            "simulated_s": totals.simulated_time,
            "ticks_per_cpu_s": totals.ticks / seconds,
            "physics_steps_per_cpu_s": totals.steps / seconds,
            "real_time_factor_per_core": totals.simulated_time / seconds,
            "real_time_factor": totals.simulated_time / wall,
        }
