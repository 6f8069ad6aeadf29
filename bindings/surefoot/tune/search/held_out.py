"""Gains on runs that no trial has seen."""

from __future__ import annotations

from surefoot._core import Gains
from surefoot.tune.search.queue import Queue
from surefoot.tune.search.rollout import Job, Outcome, named
from surefoot.tune.search.settings import SearchSettings
from surefoot.tune.search.workers import Workers


def judge(settings: SearchSettings, crew: Workers, chosen: list[Gains]) -> list[Outcome]:
    """Run gains on the held-out episodes, each on its own for the workers to share them."""
    episodes = settings.held_out_episodes
    jobs = [
        Job(named(gains), (episode,), settings.objectives)
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
