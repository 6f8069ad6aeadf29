"""Settings of a search."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from surefoot._core import Error, Gains
from surefoot.robot.gain_files import gain_values
from surefoot.robot.setting_checks import check_integer
from surefoot.sim import PlantSettings
from surefoot.tune.cost import OBJECTIVES, objective_weights
from surefoot.tune.search.episodes import FINAL_SEED, HELD_OUT_SEED, Episode
from surefoot.tune.search.space import (
    Parameter,
    default_space,
    include_start,
    task_gains,
    walk_space,
)
from surefoot.tune.search.stand_episode import StandEpisode
from surefoot.tune.search.walk_episode import WalkEpisode
from surefoot.tune.walk_cost import WALK_OBJECTIVES

SAMPLERS = ("cmaes", "tpe", "nsga2", "random")
# Chosen: more than the cores of a machine; a typing error must not start thousands.
MAX_JOBS = 256


@dataclass(frozen=True)
class SearchSettings:
    """Settings of a search, checked on construction.

    Attributes:
        robot: A name of surefoot.available_robots(), or the paths of a URDF and a TOML.
        start: Start gains.
        trials: Total number of trials at the end, including the trials in the store.
        jobs: Number of processes.
        cluster: Address of a Dask scheduler. None: local processes run the trials.
        walk: Whether the episodes are walks; otherwise they are stands.
        objectives: One name in cost.OBJECTIVES or walk_cost.WALK_OBJECTIVES, or two names for a
            Pareto front. Empty: the first one.
        space: Parameters that the search varies. Empty: default_space() or walk_space().
        episodes: Number of episodes on which each trial is evaluated.
        held_out: Number of episodes with other seeds, on which the result is evaluated.
        sampler: One of SAMPLERS. None: cmaes for one objective, nsga2 for two.
        seed: Seed of the sampler and of the first episode.
        plant: Ground, rates and sensors of the episodes.
        store: Journal file. None: the trials are kept in memory.
    """

    robot: str | tuple[str, str]
    start: Gains
    trials: int = 200
    jobs: int = 1
    cluster: str | None = None
    walk: bool = False
    objectives: tuple[str, ...] = ()
    space: tuple[Parameter, ...] = ()
    episodes: int = 6
    held_out: int = 10
    sampler: str | None = None
    seed: int = 0
    plant: PlantSettings = field(default_factory=PlantSettings)
    store: str | None = None

    def __post_init__(self) -> None:
        valid = WALK_OBJECTIVES if self.walk else OBJECTIVES
        if not self.objectives:
            object.__setattr__(self, "objectives", (next(iter(valid)),))
        if not self.space:
            space = walk_space() if self.walk else default_space()
            object.__setattr__(self, "space", tuple(space))
        for objective in self.objectives:
            objective_weights(objective, valid)
        if len(set(self.objectives)) != len(self.objectives) or len(self.objectives) not in (1, 2):
            got = ",".join(self.objectives)
            raise Error(f"objective: got '{got}', expected one, or two that differ")
        counts = (("trials", 1, 1_000_000), ("jobs", 1, MAX_JOBS), ("episodes", 1, 1000))
        for name, low, high in (*counts, ("held_out", 1, 1000), ("seed", 0, FINAL_SEED - 1000)):
            check_integer(name, getattr(self, name), low, high)
        if self.sampler is not None and self.sampler not in SAMPLERS:
            raise Error(f"sampler: got '{self.sampler}', expected one of {', '.join(SAMPLERS)}")
        if len(self.objectives) == 2 and self.sampler == "cmaes":
            raise Error("sampler: got 'cmaes' for two objectives, expected nsga2, tpe or random")
        self._check_space()

    def _check_space(self) -> None:
        names = [parameter.name for parameter in self.space]
        if not names or len(set(names)) < len(names):
            raise Error(f"gain: got {', '.join(names) or 'none'}, expected some, each once")
        for name in names:
            both = [gain for gain in task_gains(name) or () if gain in names]
            if both:
                raise Error(f"gain: got {name} and {both[0]}, expected one: the first sets both")
        space = tuple(include_start(parameter, self.start) for parameter in self.space)
        object.__setattr__(self, "space", space)

    @property
    def search_episodes(self) -> tuple[Episode, ...]:
        """Episodes on which each trial is evaluated."""
        return self._episodes(self.seed, self.episodes)

    @property
    def final_episodes(self) -> tuple[Episode, ...]:
        """Episodes that choose between the best trials."""
        return self._episodes(FINAL_SEED + self.seed, self.episodes)

    @property
    def held_out_episodes(self) -> tuple[Episode, ...]:
        """Episodes that only evaluate the result."""
        return self._episodes(HELD_OUT_SEED + self.seed, self.held_out)

    def _episodes(self, first_seed: int, count: int) -> tuple[Episode, ...]:
        kind = WalkEpisode if self.walk else StandEpisode
        return tuple(kind(self.robot, first_seed + k, self.plant) for k in range(count))

    def identity(self) -> dict[str, Any]:
        """Return the settings that must be equal for a search to resume, as JSON values."""
        return {
            "robot": self.robot if isinstance(self.robot, str) else list(self.robot),
            "start": gain_values(self.start),
            "walk": self.walk,
            "objectives": list(self.objectives),
            "space": [[p.name, p.low, p.high] for p in self.space],
            "episodes": self.episodes,
            "seed": self.seed,
            "plant": repr(self.plant),
        }
