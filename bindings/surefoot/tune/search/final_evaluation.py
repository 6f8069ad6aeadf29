"""Final evaluation: choose the best trial, and evaluate gains on episodes outside the search."""

from __future__ import annotations

from optuna.trial import FrozenTrial

from surefoot._core import Error, Gains
from surefoot.robot.gain_files import gain_values
from surefoot.tune.search.episodes import Episode
from surefoot.tune.search.rollout import Outcome, TrialJob
from surefoot.tune.search.sampling import rank_trials, relative_cost
from surefoot.tune.search.settings import SearchSettings
from surefoot.tune.search.space import apply_parameters
from surefoot.tune.search.trial_queue import TrialQueue
from surefoot.tune.search.worker_pool import WorkerPool

# Number of trials with the lowest cost that are evaluated again. Chosen: each of these evaluations
# needs as many runs as a trial.
FINALIST_COUNT = 5


def select_best_trial(
    settings: SearchSettings,
    worker_pool: WorkerPool,
    trials: list[FrozenTrial],
    start: tuple[float, ...],
) -> FrozenTrial:
    """Choose the best trial from its costs on the search episodes and on as many new episodes.

    Among hundreds of trials, the lowest cost is partly due to chance. So the FINALIST_COUNT trials
    with the lowest cost are evaluated on new episodes too, and both costs are added.

    Args:
        settings: Settings of the search.
        worker_pool: Workers that run the episodes.
        trials: All finished trials.
        start: Costs of the start gains; relative costs refer to these.

    Raises:
        Error: No trial could be run.
    """
    runnable = [trial for trial in trials if not trial.user_attrs.get("broken")]
    if not runnable:
        raise Error(
            f"search: none of {len(trials)} trials could be run, expected at least one; use other "
            "ranges"
        )
    cheapest = rank_trials(runnable, start)[:FINALIST_COUNT]
    if len(cheapest) < 2:
        return cheapest[0]
    chosen = [apply_parameters(trial.params, settings.start) for trial in cheapest]
    outcomes = evaluate_gains(settings, worker_pool, chosen, settings.final_episodes)
    costs = [
        relative_cost(trial.values, start) + relative_cost(outcome.costs, start)
        for trial, outcome in zip(cheapest, outcomes, strict=True)
    ]
    return cheapest[costs.index(min(costs))]


def evaluate_gains(
    settings: SearchSettings,
    worker_pool: WorkerPool,
    chosen: list[Gains],
    episodes: tuple[Episode, ...],
) -> list[Outcome]:
    """Evaluate each set of gains on all episodes, with one job per episode to use all workers."""
    jobs = [
        TrialJob(gain_values(gains), (episode,), settings.objectives)
        for gains in chosen
        for episode in episodes
    ]
    queue, outcomes, next_job = TrialQueue(worker_pool), dict[int, Outcome](), 0
    while len(outcomes) < len(jobs):
        while next_job < len(jobs) and len(queue) < worker_pool.count:
            queue.put(next_job, jobs[next_job])
            next_job += 1
        outcomes.update(queue.take())
    return [
        _mean_outcome([outcomes[k * len(episodes) + j] for j in range(len(episodes))])
        for k in range(len(chosen))
    ]


def _mean_outcome(outcomes: list[Outcome]) -> Outcome:
    count, first = len(outcomes), outcomes[0]
    return Outcome(
        costs=tuple(sum(o.costs[k] for o in outcomes) / count for k in range(len(first.costs))),
        terms={n: sum(o.terms.get(n, 0.0) for o in outcomes) / count for n in first.terms},
        episodes=count,
        falls=sum(o.falls for o in outcomes),
    )
