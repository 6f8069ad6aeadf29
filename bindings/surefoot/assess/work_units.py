"""Units of work: one worker runs a unit from start to end, and the store keeps its result."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from typing import Any, ClassVar, Protocol

from surefoot._core import Error
from surefoot.assess.checked_controller import ControllerFailure
from surefoot.assess.condition import Condition
from surefoot.assess.condition_plant import ground_motion_time, loop_delay, plant_of
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.push_outcome import FAILED_OUTCOME, PushOutcome, judge_push, run_duration
from surefoot.assess.robot_source import RobotSource
from surefoot.assess.rollout import TickCallback, TrueTrajectory, roll_out
from surefoot.assess.stand_outcome import HOLD_TIME, judge_stand
from surefoot.assess.sweep import FINEST_STEP, MIN_LEVEL, Sweep, outcome_rows, run_sweep
from surefoot.files.json_values import json_value
from surefoot.sim import Push

Heartbeat = Callable[[], None]
"""Function that a unit calls before its first run and after every run, to show its progress."""


def sweep_pushes(
    push: Callable[[float], PushOutcome],
    start_level: float,
    finest_step: float,
    heartbeat: Heartbeat,
) -> tuple[Sweep, dict[str, str]]:
    """Run a sweep in which the controller may fail.

    Args:
        push: Function that pushes with a level; a ControllerFailure counts as not survived.
        start_level: First level of the sweep [% of the push limit].
        finest_step: Smallest step of the sweep [% of the push limit].
        heartbeat: Function that is called after every push.

    Returns:
        The sweep, and {"broken": text of the first failure}; empty if there was none.
    """
    broken: dict[str, str] = {}

    def checked_push(level: float) -> PushOutcome:
        try:
            return push(level)
        except ControllerFailure as problem:
            broken.setdefault("broken", str(problem))
            return FAILED_OUTCOME
        finally:
            heartbeat()

    return run_sweep(checked_push, start_level, finest_step), broken


@dataclass(frozen=True)
class PushUnit:
    """A sweep of push levels in one direction with one seed.

    Attributes:
        condition: Condition of the runs.
        direction_deg: Direction, from forward towards left [deg].
        duration: Duration of every push [s].
        push_height: Height of the line of action above the centre of mass [m].
        seed: Seed of sensors and motors.
        limit: Push limit [N.s]; a level of 100 % has this impulse.
        start_level: First level of the sweep [% of the push limit].
        finest_step: Smallest step of the sweep [% of the push limit].
    """

    condition: Condition
    direction_deg: float
    duration: float
    push_height: float
    seed: int
    limit: float
    start_level: float = MIN_LEVEL
    finest_step: float = FINEST_STEP
    deadline_factor: ClassVar[float] = 1.0

    @property
    def key(self) -> str:
        """Key of the unit in the store."""
        where = f"{self.direction_deg:g} deg, {self.duration:g} s, {self.push_height:+g} m"
        return f"push | {self.condition.name} | {where} | {self.seed}"

    def run(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, heartbeat: Heartbeat
    ) -> dict[str, Any]:
        """Run the sweep and return its rows as JSON values.

        If the controller fails during a push, the push counts as not survived, and the key "broken"
        has the text of the first failure.
        """

        def push(level: float) -> PushOutcome:
            trajectory = self.simulate(source, controller_under_test, level)
            return judge_push(trajectory, self.condition.quiet_s, self.duration)

        plant_of(source, self.condition)
        heartbeat()  # building the plant must not count against the deadline of a run
        sweep, broken = sweep_pushes(push, self.start_level, self.finest_step, heartbeat)
        return {"rows": outcome_rows(sweep), **broken}

    def simulate(
        self,
        source: RobotSource,
        controller_under_test: ControllerUnderTest,
        level: float,
        on_tick: TickCallback | None = None,
    ) -> TrueTrajectory:
        """Run one push and return the true motion.

        Args:
            source: The robot.
            controller_under_test: Controller for the run.
            level: Impulse of the push [% of the push limit].
            on_tick: Function that is called in every tick.

        Raises:
            ControllerFailure: The controller failed; see the class.
            Error: The robot or the condition is invalid.
        """
        begin, plant = self.condition.quiet_s, plant_of(source, self.condition)
        impulse = level / 100.0 * self.limit
        plant.reseed(
            self.seed, [Push(self.direction_deg, impulse, self.duration, begin, self.push_height)]
        )
        control = controller_under_test.make(plant.robot, loop_delay(plant))
        run_time = run_duration(begin, self.duration)
        return roll_out(plant, self.condition, control, run_time, on_tick)


@dataclass(frozen=True)
class StandUnit:
    """A quiet stand with one heading and one seed.

    Attributes:
        condition: Condition of the run.
        heading: Direction of steepest ascent of slope or platform, from forward towards left [deg].
        seed: Seed of sensors and motors.
    """

    condition: Condition
    heading: float
    seed: int
    deadline_factor: ClassVar[float] = 1.0

    @property
    def key(self) -> str:
        """Key of the unit in the store."""
        return f"stand | {self.condition.name} | {self.heading:g} deg | {self.seed}"

    def run(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, heartbeat: Heartbeat
    ) -> dict[str, Any]:
        """Run the stand and return its outcome as JSON values."""
        plant_of(source, self._one_heading_condition)
        heartbeat()  # building the plant must not count against the deadline of a run
        stood = judge_stand(self.simulate(source, controller_under_test), self.condition)
        result: dict[str, Any] = json_value(
            {**asdict(stood), "passed": stood.passes(self.condition)}
        )
        return result

    def simulate(
        self,
        source: RobotSource,
        controller_under_test: ControllerUnderTest,
        on_tick: TickCallback | None = None,
    ) -> TrueTrajectory:
        """Run the stand and return the true motion.

        Raises:
            ControllerFailure: The controller failed; see the class.
            Error: The robot or the condition is invalid.
        """
        condition = self._one_heading_condition
        plant = plant_of(source, condition)
        plant.reseed(self.seed)
        run_time = condition.quiet_s + ground_motion_time(condition) + HOLD_TIME
        control = controller_under_test.make(plant.robot, loop_delay(plant))
        return roll_out(plant, condition, control, run_time, on_tick)

    @property
    def _one_heading_condition(self) -> Condition:
        return replace(self.condition, headings_deg=(self.heading,))


class WorkUnit(Protocol):
    """Unit of work that one worker runs from start to end.

    Attributes:
        deadline_factor: Time allowed between two heartbeats, as a multiple of the deadline.
    """

    deadline_factor: ClassVar[float]

    @property
    def key(self) -> str:
        """Key of the unit in the store."""

    def run(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, heartbeat: Heartbeat
    ) -> dict[str, Any]:
        """Run the unit and return its result as JSON values.

        Raises:
            ControllerFailure: The controller failed; see the class.
            Error: The robot or the condition is invalid.
        """


def run_unit(
    unit: WorkUnit,
    source: RobotSource,
    controller_under_test: ControllerUnderTest,
    heartbeat: Heartbeat = lambda: None,
) -> dict[str, Any]:
    """Run a unit.

    Returns:
        The result of the unit, or {"broken": reason} if the controller failed or the plant is
        invalid.
    """
    try:
        return unit.run(source, controller_under_test, heartbeat)
    except (ControllerFailure, Error) as problem:
        return {"broken": str(problem)}
