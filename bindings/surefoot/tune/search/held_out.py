"""Gains on runs that no trial has seen: who is best, and how good that is."""

from __future__ import annotations

from optuna.trial import FrozenTrial

from surefoot._core import Error, Gains
from surefoot.gain_files import gain_values
from surefoot.tune.search.episodes import Episode
from surefoot.tune.search.queue import Queue
from surefoot.tune.search.rollout import Job, Outcome
from surefoot.tune.search.sampling import ranked, relative_cost
from surefoot.tune.search.settings import SearchSettings
from surefoot.tune.search.space import apply
from surefoot.tune.search.workers import Workers

FINALISTS = 5


def finals(
    settings: SearchSettings, crew: Workers, trials: list[FrozenTrial], start: tuple[float, ...]
) -> FrozenTrial:
    """Return the best of the best trials, by their own runs and as many that they have not seen.

    The cheapest of hundreds owes some of it to luck with the runs that it was searched with.

    Raises:
        Error: No trial could be run at all.
    """
    sound = [trial for trial in trials if not trial.user_attrs.get("broken")]
    if not sound:
        raise Error(f"search: none of {len(trials)} trials could be run; give other ranges")
    cheapest = ranked(sound, start)[:FINALISTS]
    if len(cheapest) < 2:
        return cheapest[0]
    chosen = [apply(trial.params, settings.start) for trial in cheapest]
    judged = judge(settings, crew, chosen, settings.final_episodes)
    costs = [
        relative_cost(trial.values, start) + relative_cost(outcome.costs, start)
        for trial, outcome in zip(cheapest, judged, strict=True)
    ]
    return cheapest[costs.index(min(costs))]


def judge(
    settings: SearchSettings, crew: Workers, chosen: list[Gains], episodes: tuple[Episode, ...]
) -> list[Outcome]:
    """Run gains on episodes, each on its own for the workers to share them."""
    jobs = [
        Job(gain_values(gains), (episode,), settings.objectives)
        for gains in chosen
        for episode in episodes
    ]
    queue, outcomes, next_job = Queue(crew), dict[int, Outcome](), 0
    while len(outcomes) < len(jobs):
        while next_job < len(jobs) and len(queue) < crew.count:
            queue.put(next_job, jobs[next_job])
            next_job += 1
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
