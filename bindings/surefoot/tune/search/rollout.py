"""One trial's runs: gains in, costs out, and how long it took."""

from __future__ import annotations

import functools
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from surefoot._core import Error, Gains, StandController
from surefoot.gain_files import gains_of
from surefoot.sim import Plant
from surefoot.tune.cost import FALL, Cost, cost
from surefoot.tune.search.episodes import LENGTH, Episode
from surefoot.tune.trace import Trace

BROKEN = 4.0 * FALL  # cost of gains with which nothing can be computed


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
        costs: Mean over the episodes per objective; what a stopped trial did not run cost nothing.
        terms: Mean of every term over what was run.
        episodes: How many were run.
        falls: In how many of them the robot fell.
        stopped: Whether the rest was hopeless.
        broken: Whether it could not be run at all.
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
    broken: bool = False
    simulated: float = 0.0
    seconds: float = 0.0
    ticks: int = 0
    steps: int = 0


def evaluate(job: Job) -> Outcome:
    """Run a trial; never raises for what its gains do: that is a cost.

    A trial whose costs, should all that is left be free, exceed `hopeless` is stopped, and has just
    that cost: no more than it would have come to, and more than what makes it hopeless.

    Raises:
        Error: An episode that cannot be run whatever the gains.
    """
    try:
        gains = gains_of(job.gains)
    except Error:
        return broken(job)
    outcome = Outcome()
    begin = time.process_time()
    sums: list[list[Cost]] = []
    for episode in job.episodes:
        sums.append(run_episode(episode, gains, job.objectives, outcome))
        if sum(costs[0].value for costs in sums) > job.hopeless * len(job.episodes):
            outcome.stopped = len(sums) < len(job.episodes)
            break
    outcome.episodes = len(sums)
    outcome.costs = tuple(
        sum(costs[k].value for costs in sums) / len(job.episodes)
        for k in range(len(job.objectives))
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
    period, ticks = 1.0 / plant.settings.control_rate, ticks_of(plant)
    trace = play(plant, gains)
    outcome.ticks += len(trace)
    outcome.steps += len(trace) * plant.settings.steps_per_tick
    outcome.simulated += len(trace) * period
    outcome.falls += trace.fell
    return [cost(trace, objective, ticks) for objective in objectives]


def play(plant: Plant, gains: Gains, watch: Callable[[int], None] | None = None) -> Trace:
    """Run an episode on its plant, until the robot falls.

    Args:
        plant: Of Episode.plant(); begins anew.
        gains: Of the controller.
        watch: Is given the number of every tick that is over, those after a fall too.
    """
    trace = Trace(plant, ticks_of(plant))
    controller = StandController(plant.robot, gains)
    state = plant.reset()
    for k in range(ticks_of(plant)):
        state = plant.step(controller.update(state))
        trace.record()
        if watch is not None:
            watch(k)
        elif trace.fell:
            break
    return trace


def ticks_of(plant: Plant) -> int:
    """Return how many ticks an episode has on its plant."""
    return round(LENGTH * plant.settings.control_rate)


@functools.lru_cache(maxsize=64)
def plant_of(episode: Episode) -> Plant:
    """Return an episode's plant; building one takes as long as running it, so it is kept."""
    return episode.plant()


_ALONE = threading.Lock()  # plants are kept and shared: one trial at a time in a process


def judged(job: Job) -> Outcome:
    """Return evaluate(), one at a time in a process; raises Error."""
    with _ALONE:
        return evaluate(job)


def broken(job: Job) -> Outcome:
    """Return the outcome of a job whose gains cannot be tried."""
    return Outcome(costs=(BROKEN,) * len(job.objectives), broken=True)
