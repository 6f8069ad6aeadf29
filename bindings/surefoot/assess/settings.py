"""Settings of an assessment."""

from __future__ import annotations

import pickle
from dataclasses import dataclass, field
from typing import Any

from surefoot._core import Error, Robot
from surefoot.assess.controller_under_test import ControllerUnderTest, find_factory
from surefoot.assess.robot_source import describe_source, mjcf_digest
from surefoot.assess.scorecard import Scorecard, standard_scorecard
from surefoot.assess.time_limit import time_limit
from surefoot.assess.walking.walk_scorecard import WalkScorecard
from surefoot.robot.loading import build_robot, robot_identity
from surefoot.robot.setting_checks import check_integer, check_number

# Sanity limits.
MAX_JOBS = 256
MAX_DEADLINE = 86400.0  # [s] one day


@dataclass(frozen=True)
class AssessSettings:
    """Settings of an assessment: robot, controller, scorecard, processes and store.

    Attributes:
        robot: A name of surefoot.available_robots(), or the paths of a URDF and a TOML.
        controller_under_test: Controller to assess.
        card: Scorecard to fill: a WalkScorecard for a controller that walks.
        jobs: Number of worker processes. All units run in workers, so a controller that crashes
            does not stop the assessment.
        deadline: Longest wall time of one run of a few simulated seconds [s]; a worker whose run
            takes longer is killed.
        store: File that keeps the results, so that a run can be resumed; None: in memory only.
        mjcf: Path of an MJCF on which the robot is assessed too, with figures in a section of their
            own; None: no such section.
    """

    robot: str | tuple[str, str] = "go1"
    controller_under_test: ControllerUnderTest = field(default_factory=ControllerUnderTest)
    card: Scorecard | WalkScorecard = field(default_factory=lambda: standard_scorecard("quick"))
    jobs: int = 1
    # Chosen: far longer than a run of 3.5 simulated seconds takes (0.24 to 0.4 s). With a larger
    # value, a controller that never returns would block its worker for longer.
    deadline: float = 60.0
    store: str | None = None
    mjcf: str | None = None

    def __post_init__(self) -> None:
        check_integer("jobs", self.jobs, 1, MAX_JOBS)
        check_number("deadline", self.deadline, 0.1, MAX_DEADLINE)
        _check_type("controller_under_test", self.controller_under_test, ControllerUnderTest)
        kind = WalkScorecard if self.controller_under_test.walks else Scorecard
        _check_type("card", self.card, kind)
        if self.controller_under_test.factory is None:
            with time_limit(
                self.deadline, f"controller '{self.controller_under_test.name}': its import"
            ):
                find_factory(self.controller_under_test)
        try:
            pickle.dumps(self.controller_under_test)
        except (pickle.PicklingError, AttributeError, TypeError) as problem:
            raise Error(
                f"controller '{self.controller_under_test.name}': cannot be handed to another "
                f"process ({problem}); expected a function or class of a module"
            ) from None

    @property
    def stand_card(self) -> Scorecard:
        """The scorecard of a controller that stands."""
        assert isinstance(self.card, Scorecard)  # checked in __post_init__
        return self.card

    @property
    def walk_card(self) -> WalkScorecard:
        """The scorecard of a controller that walks."""
        assert isinstance(self.card, WalkScorecard)  # checked in __post_init__
        return self.card

    def build(self) -> Robot:
        """Build the model of the robot.

        Raises:
            Error: The robot is unknown, or its files are missing or invalid.
        """
        return build_robot(describe_source(self.robot))

    def to_dict(self, robot: Robot) -> dict[str, Any]:
        """Return the JSON values that identify an assessment; equal values give equal results."""
        return {
            **robot_identity(describe_source(self.robot), robot),
            "controller": self.controller_under_test.name,
            "gains": self.controller_under_test.gains,
            "walks": self.controller_under_test.walks,
            "card": self.card.to_dict(),
            **({} if self.mjcf is None else {"mjcf": mjcf_digest(self.mjcf)}),
        }


def _check_type(name: str, value: Any, kind: type) -> None:
    if not isinstance(value, kind):
        raise Error(f"{name}: got {value!r}, expected a {kind.__name__}")
