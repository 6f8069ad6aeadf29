"""One trial's runs: gains in, costs out, and how long it took."""

from __future__ import annotations

import functools
import threading
import time
from dataclasses import dataclass, field

from surefoot._core import Error, Gains, StandController, set_gain
from surefoot.sim import Plant
from surefoot.tune.cost import FALL, Cost, cost
from surefoot.tune.search.episodes import LENGTH, Episode
from surefoot.tune.trace import Trace

BROKEN = 3.0 * FALL  # cost of gains with which nothing can be computed


@dataclass(frozen=True)
class Job:
    """What a worker is given: plain data, so that it travels.

    Attributes:
        gains: Every gain by name.
        episodes: The runs.
        objectives: One or two of cost.OBJECTIVES.
        hopeless: Mean cost of the first objective beyond which the rest is not run.
    """

    gains: dict[str, float]
    episodes: tuple[Episode, ...]
    objectives: tuple[str, ...]
    hopeless: float = float("inf")


@dataclass
class Outcome:
    """What comes back.

    Attributes:
        costs: Mean over the episodes that were run, per objective.
        terms: Mean of every term, the same.
        episodes: How many were run.
        falls: In how many of them the robot fell.
        stopped: Whether the rest was hopeless.
        simulated: Time that was simulated [s].
        seconds: CPU time that it took [s].
        ticks: Of the controller.
        steps: Of the physics.
    """

    costs: tuple[float, ...] = ()
    terms: dict[str, float] = field(default_factory=dict)
    episodes: int = 0
    falls: int = 0
    stopped: bool = False
    simulated: float = 0.0
    seconds: float = 0.0
    ticks: int = 0
    steps: int = 0


def evaluate(job: Job) -> Outcome:
    """Run a trial; never raises for what its gains do: that is a cost.

    A trial whose costs, should all that is left be free, exceed `hopeless` is stopped: its mean is
    that of what was run, which is finite and at least as bad.
    """
    gains, outcome = Gains(), Outcome()
    for name, value in job.gains.items():
        set_gain(gains, name, value)
    begin = time.process_time()
    sums: list[list[Cost]] = []
    for episode in job.episodes:
        sums.append(run_episode(episode, gains, job.objectives, outcome))
        if sum(costs[0].value for costs in sums) > job.hopeless * len(job.episodes):
            outcome.stopped = len(sums) < len(job.episodes)
            break
    outcome.episodes = len(sums)
    outcome.costs = tuple(
        sum(costs[k].value for costs in sums) / len(sums) for k in range(len(job.objectives))
    )
    terms = sums[0][0].terms
    outcome.terms = {name: sum(c[0].terms[name] for c in sums) / len(sums) for name in terms}
    outcome.seconds = time.process_time() - begin
    return outcome


def run_episode(
    episode: Episode, gains: Gains, objectives: tuple[str, ...], outcome: Outcome
) -> list[Cost]:
    """Run one episode and count what it took into outcome; return its cost per objective."""
    plant = plant_of(episode)
    period = 1.0 / plant.settings.control_rate
    ticks = round(LENGTH / period)
    trace = Trace(plant, ticks)
    controller = StandController(plant.robot, gains)
    state = plant.reset()
    for _ in range(ticks):
        state = plant.step(controller.update(state))
        trace.record()
        if trace.fell:
            break
    outcome.ticks += len(trace)
    outcome.steps += len(trace) * plant.settings.steps_per_tick
    outcome.simulated += len(trace) * period
    outcome.falls += trace.fell
    return [cost(trace, objective, ticks) for objective in objectives]


@functools.lru_cache(maxsize=64)
def plant_of(episode: Episode) -> Plant:
    """Return an episode's plant; building one takes as long as running it, so it is kept."""
    return episode.plant()


_ALONE = threading.Lock()  # plants are kept and shared: one trial at a time in a process


def judged(job: Job) -> Outcome:
    """Return evaluate(), with what cannot be run at all as a finite cost."""
    try:
        with _ALONE:
            return evaluate(job)
    except Error:
        return Outcome(costs=(BROKEN,) * len(job.objectives), episodes=0)
