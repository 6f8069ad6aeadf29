"""One trial's runs: gains in, costs out, and how long it took."""

from __future__ import annotations

import functools
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from surefoot._core import Error, Gains, StandController
from surefoot.robot.gain_files import gains_from_values
from surefoot.sim import Plant
from surefoot.tune.cost import FALL_COST, Cost, cost
from surefoot.tune.search.episodes import EPISODE_TIME, Episode
from surefoot.tune.trace import Trace

BROKEN_COST = 4.0 * FALL_COST  # cost of gains with which nothing can be computed


@dataclass(frozen=True)
class TrialJob:
    """What a worker is given: plain data, so that it travels.

    Attributes:
        gains: Every gain by name.
        episodes: The runs.
        objectives: One or two of cost.OBJECTIVES.
        stop_cost: Mean cost of the first objective beyond which the rest is not run.
    """

    gains: dict[str, float]
    episodes: tuple[Episode, ...]
    objectives: tuple[str, ...]
    stop_cost: float = float("inf")


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
        simulated_time: Time that was simulated [s].
        cpu_time: CPU time that it took [s].
        ticks: Of the controller.
        steps: Of the physics.
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
    """Run a trial; never raises for what its gains do: that is a cost.

    A trial whose costs, should all that is left be free, exceed `stop_cost` is stopped, and has just
    that cost: no more than it would have come to, and more than what makes it hopeless.

    Raises:
        Error: An episode that cannot be run whatever the gains.
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
    """Run one episode and count what it took into outcome; return its cost per objective."""
    plant = cached_plant(episode)
    period, ticks = 1.0 / plant.settings.control_rate, episode_ticks(plant)
    trace = simulate_episode(plant, gains)
    outcome.ticks += len(trace)
    outcome.steps += len(trace) * plant.settings.steps_per_tick
    outcome.simulated_time += len(trace) * period
    outcome.falls += trace.fell
    return [cost(trace, objective, ticks) for objective in objectives]


def simulate_episode(
    plant: Plant, gains: Gains, on_tick: Callable[[int], None] | None = None
) -> Trace:
    """Run an episode on its plant, until the robot falls.

    Args:
        plant: Of Episode.plant(); begins anew.
        gains: Of the controller.
        on_tick: Is given the number of every tick that is over, those after a fall too.
    """
    trace = Trace(plant, episode_ticks(plant))
    controller = StandController(plant.robot, gains)
    state = plant.reset()
    for k in range(episode_ticks(plant)):
        state = plant.step(controller.update(state))
        trace.record()
        if on_tick is not None:
            on_tick(k)
        elif trace.fell:
            break
    return trace


def episode_ticks(plant: Plant) -> int:
    """Return how many ticks an episode has on its plant."""
    return round(EPISODE_TIME * plant.settings.control_rate)


@functools.lru_cache(maxsize=64)
def cached_plant(episode: Episode) -> Plant:
    """Return an episode's plant; building one takes as long as running it, so it is kept."""
    return episode.plant()


_EVALUATION_LOCK = threading.Lock()  # plants are kept and shared: one trial at a time in a process


def evaluate_exclusively(job: TrialJob) -> Outcome:
    """Return evaluate_trial(), one at a time in a process; raises Error."""
    with _EVALUATION_LOCK:
        return evaluate_trial(job)


def broken(job: TrialJob) -> Outcome:
    """Return the outcome of a job whose gains cannot be tried."""
    return Outcome(costs=(BROKEN_COST,) * len(job.objectives), broken=True)
