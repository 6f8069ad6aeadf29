"""The search: ask for gains, have them tried, tell what they cost."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import optuna
from optuna.samplers import BaseSampler, CmaEsSampler, NSGAIISampler, RandomSampler, TPESampler
from optuna.trial import FrozenTrial, TrialState

from surefoot._core import Gains, gain_table, get_gain
from surefoot.tune.search.episodes import Episode
from surefoot.tune.search.rollout import Job, Outcome
from surefoot.tune.search.settings import SearchSettings
from surefoot.tune.search.space import apply
from surefoot.tune.search.store import open_store, open_study, reclaim
from surefoot.tune.search.workers import Queue, Workers, workers

HOPELESS = 3.0  # times the best: what is worse is not run to its end
SIGMA = 0.25  # of the logarithmic range: the first step of CMA-ES

Progress = Callable[[int, int, float], None]
"""Called with how many trials are done, how many there will be, and the best cost so far."""


@dataclass(frozen=True)
class Candidate:
    """Gains, and what they cost on held-out episodes.

    Attributes:
        gains: The gains.
        held: Outcome on the held-out episodes.
        searched: Costs on the searched ones; empty if they were not a trial.
    """

    gains: Gains
    held: Outcome
    searched: tuple[float, ...] = ()


@dataclass(frozen=True)
class SearchResult:
    """What came of a search.

    Attributes:
        settings: What was asked.
        trials: Every finished trial, in order.
        start, own, best: The start, the robot's own gains, the best trial.
        front: Trials of the Pareto front, with two objectives.
        importance: Share of each parameter in what trials cost, if there were enough of them.
        speed: Rollout figures of this process's run.
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
    """Run a search to its end, or go on with the one in the store.

    Args:
        settings: What to do.
        own: The robot's own gains, to compare with.
        progress: Told how far it is.

    Raises:
        Error: A store, cluster or setting that does not do.
        OSError: The store cannot be written; the trials in it are safe.
    """
    path = settings.store
    with open_store(path) as storage, workers(settings.jobs, settings.cluster) as crew:
        sampler = _sampler(settings)
        study = open_study(storage, sampler, len(settings.objectives), settings.described(), path)
        reclaim(study)
        if not study.get_trials(deepcopy=False):
            study.enqueue_trial({p.name: p.get(settings.start) for p in settings.space})
        search = _Search(settings, study, crew, progress)
        search.run()
        trials = study.get_trials(deepcopy=False, states=(TrialState.COMPLETE,))
        best = _best(trials, len(settings.objectives))
        chosen = [settings.start, own, apply(best.params, settings.start)]
        held = _judge(settings, crew, chosen)
        return SearchResult(
            settings,
            trials,
            Candidate(chosen[0], held[0], tuple(trials[0].values)),
            Candidate(chosen[1], held[1]),
            Candidate(chosen[2], held[2], tuple(best.values)),
            list(study.best_trials) if len(settings.objectives) == 2 else [],
            _importance(study, trials),
            search.speed(),
        )


class _Search:
    """The loop of one run, and its figures."""

    def __init__(
        self,
        settings: SearchSettings,
        study: optuna.Study,
        crew: Workers,
        progress: Progress | None,
    ) -> None:
        self._settings, self._study, self._crew = settings, study, crew
        self._progress = progress
        self._episodes = settings.search_episodes
        self._distributions: dict[str, optuna.distributions.BaseDistribution] = {
            p.name: optuna.distributions.FloatDistribution(p.low, p.high, log=True)
            for p in settings.space
        }
        done = study.get_trials(deepcopy=False, states=(TrialState.COMPLETE,))
        self._done = len(done)
        self._best = min((trial.values[0] for trial in done), default=float("inf"))
        self._totals = Outcome()
        self._wall = 0.0

    def run(self) -> None:
        """Have trials run until there are enough."""
        settings, queue = self._settings, Queue(self._crew)
        begin = time.monotonic()
        while self._done < settings.trials:
            while len(queue) < min(self._crew.count, settings.trials - self._done):
                trial = self._study.ask(self._distributions)
                queue.put(trial.number, self._job(trial.params))
            for number, outcome in queue.take():
                self._tell(number, outcome)
        self._wall = time.monotonic() - begin

    def _job(self, values: dict[str, Any]) -> Job:
        # With two objectives a trial that is bad at one may be good at the other.
        alone = len(self._settings.objectives) == 1
        hopeless = HOPELESS * self._best if alone else float("inf")
        gains = apply(values, self._settings.start)
        return Job(named(gains), self._episodes, self._settings.objectives, hopeless)

    def _tell(self, number: int, outcome: Outcome) -> None:
        trial_id = self._study.get_trials(deepcopy=False)[number]._trial_id
        for name in ("falls", "stopped", "episodes", "terms"):
            self._study._storage.set_trial_user_attr(trial_id, name, getattr(outcome, name))
        self._study.tell(number, list(outcome.costs))
        self._done += 1
        self._best = min(self._best, outcome.costs[0])
        for name in ("simulated", "seconds", "ticks", "steps"):
            total = getattr(self._totals, name) + getattr(outcome, name)
            setattr(self._totals, name, total)
        if self._progress is not None:
            self._progress(self._done, self._settings.trials, self._best)

    def speed(self) -> dict[str, float]:
        """Return how fast rollouts were, of this run alone."""
        totals, seconds, wall = self._totals, self._totals.seconds, self._wall
        if seconds <= 0.0 or wall <= 0.0:
            return {}
        return {
            "workers": self._crew.count,
            "wall_s": wall,
            "simulated_s": totals.simulated,
            "ticks_per_cpu_s": totals.ticks / seconds,
            "physics_steps_per_cpu_s": totals.steps / seconds,
            "real_time_factor_per_core": totals.simulated / seconds,
            "real_time_factor": totals.simulated / wall,
        }


def named(gains: Gains) -> dict[str, float]:
    """Return every gain by name."""
    return {info.name: get_gain(gains, info.name) for info in gain_table()}


def _sampler(settings: SearchSettings) -> BaseSampler:
    kind = settings.sampler or ("cmaes" if len(settings.objectives) == 1 else "nsga2")
    if kind == "cmaes":
        x0 = {p.name: p.get(settings.start) for p in settings.space}
        return CmaEsSampler(x0=x0, sigma0=SIGMA, seed=settings.seed)
    if kind == "tpe":
        return TPESampler(seed=settings.seed, multivariate=True, constant_liar=True)
    if kind == "nsga2":
        return NSGAIISampler(population_size=20, seed=settings.seed)
    return RandomSampler(seed=settings.seed)


def _best(trials: list[FrozenTrial], objectives: int) -> FrozenTrial:
    """Return the cheapest; of two objectives that of the least sum, each relative to the start."""
    start = [max(value, 1e-9) for value in trials[0].values]
    return min(trials, key=lambda t: sum(t.values[k] / start[k] for k in range(objectives)))


def _importance(study: optuna.Study, trials: list[FrozenTrial]) -> dict[str, float]:
    if len(trials) < 20:
        return {}
    evaluator = optuna.importance.PedAnovaImportanceEvaluator()
    found = optuna.importance.get_param_importances(
        study, evaluator=evaluator, target=lambda trial: trial.values[0]
    )
    return {name: float(share) for name, share in found.items()}


def _judge(settings: SearchSettings, crew: Workers, chosen: list[Gains]) -> list[Outcome]:
    """Run gains on the held-out episodes, each on its own for the workers to share them."""
    queue, outcomes = Queue(crew), dict[int, Outcome]()
    episodes: list[Episode] = list(settings.held_out_episodes)
    for k, gains in enumerate(chosen):
        for j, episode in enumerate(episodes):
            queue.put(k * len(episodes) + j, Job(named(gains), (episode,), settings.objectives))
    while len(queue):
        outcomes.update(queue.take())
    return [
        _merged([outcomes[k * len(episodes) + j] for j in range(len(episodes))])
        for k in range(len(chosen))
    ]


def _merged(outcomes: list[Outcome]) -> Outcome:
    count, first = len(outcomes), outcomes[0]
    return Outcome(
        costs=tuple(sum(o.costs[k] for o in outcomes) / count for k in range(len(first.costs))),
        terms={n: sum(o.terms.get(n, 0.0) for o in outcomes) / count for n in first.terms},
        episodes=count,
        falls=sum(o.falls for o in outcomes),
    )
