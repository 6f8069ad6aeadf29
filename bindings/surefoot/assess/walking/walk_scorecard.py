"""Scorecard of a walk: which velocities and pushes, under which conditions, with how many seeds."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from surefoot._core import Error
from surefoot.assess.condition import Condition
from surefoot.assess.scorecard import MAX_COUNT, MAX_SEED, NOMINAL_CONDITION
from surefoot.assess.scorecard_file import read_scorecard_file
from surefoot.robot.setting_checks import check_integer, check_number, check_numbers

Velocity = tuple[float, float, float]
"""vx, vy [m/s], yaw rate [rad/s] in the heading frame."""

_FOLDER = Path(__file__).parent
_VELOCITY_KEYS = ("velocities", "push_velocities")
# Fields of a condition that act only on standing robots.
_STAND_FIELDS = ("tilt_deg", "step_foot", "pushes")


@dataclass(frozen=True)
class WalkScorecard:
    """Velocities, pushes, conditions and seeds of an assessment of walking.

    Attributes:
        name: "full", "quick", or the file name without its extension.
        velocities: Commanded velocities, each from a stand.
        walk_s: Time for which each velocity is commanded [s].
        seeds: Number of seeds of every velocity.
        push_velocities: Velocities at which the robot is pushed.
        push_directions: Number of push directions; evenly spaced, and the first is forward.
        push_seeds: Number of seeds of every push; successive seeds push at four times that are
            0.1 s apart, so in other phases of the gait.
        condition_velocity: Velocity under each further condition.
        condition_seeds: Number of seeds under each further condition.
        first_seed: First seed; choose seeds that were not used for tuning.
        references: True: the reference controller walks as well, under the nominal condition.
        conditions: Conditions. The first is the nominal condition.
    """

    name: str
    velocities: tuple[Velocity, ...] = ((0.5, 0.0, 0.0),)
    walk_s: float = 4.0
    seeds: int = 5
    push_velocities: tuple[Velocity, ...] = ()
    push_directions: int = 8
    push_seeds: int = 4
    condition_velocity: Velocity = (0.4, 0.0, 0.0)
    condition_seeds: int = 5
    first_seed: int = 0
    references: bool = False
    conditions: tuple[Condition, ...] = (Condition(NOMINAL_CONDITION),)

    def __post_init__(self) -> None:
        if not self.velocities:
            raise Error("velocities: got none, expected at least one")
        for velocity in (*self.velocities, *self.push_velocities, self.condition_velocity):
            check_numbers("velocity", velocity, -100.0, 100.0)
            if len(velocity) != 3:
                raise Error(f"velocity: got {list(velocity)}, expected vx, vy, yaw rate")
        # Derived: SETTLING of surefoot.walk, 1 s, and some strides.
        check_number("walk_s", self.walk_s, 2.0, 60.0)
        for name in ("seeds", "push_directions", "push_seeds"):
            check_integer(name, getattr(self, name), 1, MAX_COUNT)
        check_integer("condition_seeds", self.condition_seeds, 0, MAX_COUNT)
        check_integer("first_seed", self.first_seed, 0, MAX_SEED)
        if not isinstance(self.references, bool):
            raise Error(f"references: got {self.references!r}, expected true or false")
        names = [condition.name for condition in self.conditions]
        if not names or len(set(names)) < len(names):
            raise Error(f"condition: got {', '.join(names) or 'none'}, expected names, each once")
        for condition in self.conditions:
            for name in _STAND_FIELDS:
                if getattr(condition, name):
                    raise Error(
                        f"condition '{condition.name}': {name}: got "
                        f"{getattr(condition, name)!r}, expected none: it is for robots that stand"
                    )

    def to_dict(self) -> dict[str, Any]:
        """Return all fields by name, as JSON values."""
        return asdict(self)

    def seed_range(self, count: int) -> range:
        """Return `count` seeds; the first is first_seed."""
        return range(self.first_seed, self.first_seed + count)

    @property
    def push_directions_deg(self) -> list[float]:
        """Push directions, from forward towards left [deg]."""
        return [360.0 * k / self.push_directions for k in range(self.push_directions)]


def standard_walk_scorecard(name: str) -> WalkScorecard:
    """Return the scorecard "full" or "quick" of walks."""
    return read_walk_scorecard(_FOLDER / f"{name}.toml", name)


def read_walk_scorecard(path: str | Path, name: str | None = None) -> WalkScorecard:
    """Read a scorecard of walks from a TOML file.

    Args:
        path: Path of the file.
        name: Name of the scorecard; None: the file name without its extension.

    Raises:
        Error: The file cannot be read, is not valid TOML, or has an unknown key or invalid value.
    """
    return read_scorecard_file(WalkScorecard, path, name, _make_tuples)


def _make_tuples(values: dict[str, Any]) -> None:
    for key in _VELOCITY_KEYS:
        if isinstance(values.get(key), list):
            values[key] = tuple(tuple(v) if isinstance(v, list) else v for v in values[key])
    if isinstance(values.get("condition_velocity"), list):
        values["condition_velocity"] = tuple(values["condition_velocity"])
