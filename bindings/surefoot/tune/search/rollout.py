"""Rollouts of a trial: simulate its episodes with its gains and compute costs."""

from __future__ import annotations

import functools
import threading
import time
from dataclasses import dataclass, field

from surefoot._core import Error, Gains
from surefoot.robot.gain_files import gains_from_values
from surefoot.sim import Plant
from surefoot.tune.cost import FALL_COST, Cost
from surefoot.tune.search.episodes import Episode

# Derived: above the greatest cost of a fall, 3 FALL_COST.
BROKEN_COST = 4.0 * FALL_COST  # cost of gains that cannot be run


@dataclass(frozen=True)
class TrialJob:
    """Job for a worker, as picklable values.

    Attributes:
        gains: All gains, by name.
        episodes: Episodes to run.
        objectives: One or two objectives of the episodes.
        stop_cost: Limit of the mean cost over all episodes, for the first objective. When this mean
            must exceed the limit, the remaining episodes are skipped.
    """

    gains: dict[str, float]
    episodes: tuple[Episode, ...]
    objectives: tuple[str, ...]
    stop_cost: float = float("inf")


@dataclass
class Outcome:
    """Result of a job.

    Attributes:
        costs: Mean cost over all episodes, per objective; a skipped episode counts as 0.
        terms: Mean of each cost term over the episodes that were run.
        episodes: Number of episodes that were run.
        falls: Number of episodes with a fall.
        stopped: True if episodes were skipped because of stop_cost.
        broken: True if the gains could not be run.
        simulated_time: Simulated time [s].
        cpu_time: CPU time [s].
        ticks: Number of controller ticks.
        steps: Number of physics steps.
    """

    costs: tuple[float, ...] = ()
    terms: dict[str, float] = field(default_factory=dict)
    episodes: int = 0
    falls: int = 0
    stopped: bool = False
    broken: bool = False
    simulated_time: float = 0.0
    cpu_time: float = 0.0
    ticks: int = 0
    steps: int = 0


def evaluate_trial(job: TrialJob) -> Outcome:
    """Run the episodes of a trial and compute its costs.

    Bad gains raise no exception; they get a high cost. The trial stops as soon as its mean cost
    would exceed job.stop_cost even with a cost of 0 in all remaining episodes. The outcome then has
    this lower bound as its cost.

    Raises:
        Error: An episode cannot be run with any gains.
    """
    try:
        gains = gains_from_values(job.gains)
    except Error:
        return broken(job)
    outcome = Outcome()
    begin = time.process_time()
    sums: list[list[Cost]] = []
    for episode in job.episodes:
        sums.append(run_episode(episode, gains, job.objectives, outcome))
        if sum(costs[0].value for costs in sums) > job.stop_cost * len(job.episodes):
            outcome.stopped = len(sums) < len(job.episodes)
            break
    outcome.episodes = len(sums)
    outcome.costs = tuple(
        sum(costs[k].value for costs in sums) / len(job.episodes)
        for k in range(len(job.objectives))
    )
    terms = sums[0][0].terms
    outcome.terms = {name: sum(c[0].terms[name] for c in sums) / len(sums) for name in terms}
    outcome.cpu_time = time.process_time() - begin
    return outcome


def run_episode(
    episode: Episode, gains: Gains, objectives: tuple[str, ...], outcome: Outcome
) -> list[Cost]:
    """Run one episode, add its counts to `outcome`, and return its cost per objective."""
    plant = cached_plant(episode)
    record = episode.simulate(plant, gains)
    outcome.ticks += len(record)
    outcome.steps += len(record) * plant.settings.steps_per_tick
    outcome.simulated_time += len(record) / plant.settings.control_rate
    outcome.falls += record.fell
    return [episode.cost(record, objective) for objective in objectives]


@functools.lru_cache(maxsize=64)
def cached_plant(episode: Episode) -> Plant:
    """Return the plant of an episode from a cache.

    Building a plant takes as long as running its episode.
    """
    return episode.plant()


# A process evaluates one trial at a time, because all trials share the cached plants.
_EVALUATION_LOCK = threading.Lock()


def evaluate_exclusively(job: TrialJob) -> Outcome:
    """Run evaluate_trial() for one trial at a time per process; raises the same errors."""
    with _EVALUATION_LOCK:
        return evaluate_trial(job)


def broken(job: TrialJob) -> Outcome:
    """Return the outcome of a job whose gains cannot be run."""
    return Outcome(costs=(BROKEN_COST,) * len(job.objectives), broken=True)
