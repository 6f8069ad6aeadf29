"""Scorecard: which pushes, under which conditions, with how many seeds."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from surefoot._core import Error
from surefoot.assess.condition import Condition
from surefoot.assess.scorecard_file import read_scorecard_file
from surefoot.robot.setting_checks import check_integer, check_numbers, check_unique

NOMINAL_CONDITION = "level ground"
# Duration [s] and height [m] of the push that all standard scorecards contain. Chosen: longer than
# an impact, shorter than the time constant of the LIP (0.2 s).
STANDARD_PUSH = (0.1, 0.0)
# Sanity limits.
MAX_COUNT = 1000  # largest number of directions or seeds
MAX_SEED = 1_000_000  # largest first_seed
_FOLDER = Path(__file__).parent


@dataclass(frozen=True)
class Scorecard:
    """Pushes, conditions and seeds of an assessment.

    Attributes:
        name: "full", "quick", or the file name without its extension.
        directions: Number of push directions; evenly spaced, and the first is forward.
        lengths_s: Durations of pushes [s].
        heights_m: Heights of the lines of action above the centre of mass [m].
        seeds: Number of seeds of every push; the errors of sensors and motors depend on the seed.
        first_seed: First seed of pushes and stands; choose seeds that were not used for tuning.
        condition_directions: Number of directions of STANDARD_PUSH under each further condition.
        condition_seeds: Number of seeds of the pushes under further conditions, and of the quiet
            stands.
        faults: Part of the fault matrix to run: "none", "brief" or "all".
        references: True: the reference controllers are pushed as well.
        conditions: Conditions. The first is the nominal condition, under which all pushes run.
    """

    name: str
    # The numbers of directions and seeds are those of full.toml. Chosen: the full scorecard of a
    # go1 takes 2.2 h on two cores.
    directions: int = 16
    lengths_s: tuple[float, ...] = (0.1,)
    heights_m: tuple[float, ...] = (0.0,)
    seeds: int = 20
    condition_directions: int = 8
    condition_seeds: int = 10
    first_seed: int = 0
    faults: str = "brief"
    references: bool = False
    conditions: tuple[Condition, ...] = field(
        default_factory=lambda: (Condition(NOMINAL_CONDITION),)
    )

    def __post_init__(self) -> None:
        for name, low in (("directions", 1), ("seeds", 1)):
            check_integer(name, getattr(self, name), low, MAX_COUNT)
        for name in ("condition_directions", "condition_seeds"):
            check_integer(name, getattr(self, name), 0, MAX_COUNT)
        check_integer("first_seed", self.first_seed, 0, MAX_SEED)
        check_numbers("lengths_s", self.lengths_s, 0.002, 5.0)
        check_unique("lengths_s", self.lengths_s)
        check_numbers("heights_m", self.heights_m, -1.0, 1.0)
        check_unique("heights_m", self.heights_m)
        if self.faults not in ("none", "brief", "all"):
            raise Error(f"faults: got {self.faults!r}, expected none, brief or all")
        if not isinstance(self.references, bool):
            raise Error(f"references: got {self.references!r}, expected true or false")
        names = [condition.name for condition in self.conditions]
        if not names or len(set(names)) < len(names):
            raise Error(f"condition: got {', '.join(names) or 'none'}, expected names, each once")
        for condition in self.conditions[1:]:
            if condition.pushes and not (self.condition_directions and self.condition_seeds):
                raise Error(
                    f"condition '{condition.name}': pushes: got true, expected false where "
                    "condition_directions or condition_seeds is 0"
                )
        nominal = self.conditions[0]
        if nominal.slope_deg or nominal.ground_moves:
            raise Error(
                f"condition '{nominal.name}': got a slope or ground that moves, expected level "
                "ground of the first condition: all pushes run on it, and their limits are for it"
            )

    def to_dict(self) -> dict[str, Any]:
        """Return all fields by name, as JSON values."""
        return asdict(self)

    def seed_range(self, count: int) -> range:
        """Return `count` seeds; the first is first_seed."""
        return range(self.first_seed, self.first_seed + count)

    @property
    def summary_push(self) -> tuple[float, float]:
        """Duration [s] and height [m] of the pushes that the summary uses."""
        return summary_push(
            [(length, push_height) for length in self.lengths_s for push_height in self.heights_m]
        )

    @property
    def directions_deg(self) -> list[float]:
        """Push directions, from forward towards left [deg]."""
        return [360.0 * k / self.directions for k in range(self.directions)]

    @property
    def condition_directions_deg(self) -> list[float]:
        """Push directions under further conditions, from forward towards left [deg]."""
        return [360.0 * k / self.condition_directions for k in range(self.condition_directions)]


def summary_push(candidates: list[tuple[float, float]]) -> tuple[float, float]:
    """Return duration and height of the summary's pushes: STANDARD_PUSH or the first candidate."""
    return STANDARD_PUSH if STANDARD_PUSH in candidates else candidates[0]


def standard_scorecard(name: str) -> Scorecard:
    """Return the scorecard "full" or "quick".

    "quick" has all conditions of "full", but without pushes under further conditions.
    """
    card = read_scorecard(_FOLDER / f"{name}.toml", name)
    if name != "quick":
        return card
    conditions = standard_scorecard("full").conditions
    return replace(card, conditions=tuple(replace(c, pushes=False) for c in conditions))


def read_scorecard(path: str | Path, name: str | None = None) -> Scorecard:
    """Read a scorecard from a TOML file.

    Args:
        path: Path of the file.
        name: Name of the scorecard; None: the file name without its extension.

    Raises:
        Error: The file cannot be read, is not valid TOML, or has an unknown key or invalid value.
    """
    return read_scorecard_file(Scorecard, path, name, _make_tuples)


def _make_tuples(values: dict[str, Any]) -> None:
    for key in ("lengths_s", "heights_m"):
        if isinstance(values.get(key), list):
            values[key] = tuple(values[key])
