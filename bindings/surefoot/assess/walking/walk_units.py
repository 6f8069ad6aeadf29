"""Units of work of a walking scorecard: one velocity, or the pushes of one direction."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from surefoot.assess.condition import Condition
from surefoot.assess.condition_plant import loop_delay
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.push_outcome import PushOutcome
from surefoot.assess.robot_source import RobotSource
from surefoot.assess.walking.true_walk import TrueWalk
from surefoot.assess.walking.walk_figures import walk_figures
from surefoot.assess.walking.walk_rollout import Schedule, walk_out, walking_plant_of
from surefoot.assess.walking.walk_scorecard import Velocity
from surefoot.assess.work_units import Heartbeat, sweep_pushes
from surefoot.files.json_values import json_value
from surefoot.sim import Push
from surefoot.walk.push_recovery import recovered_ticks

# Protocol of docs/reference/scorecard.md, chosen.
QUIET_TIME = 0.5  # [s] standing before a velocity is commanded
STOP_TIME = 2.5  # [s] time after the velocity is 0 again: the stop, and 0.5 s of standing
SETTLED_TIME = 1.5  # [s] walking before a push
PUSH_DURATION = 0.1  # [s]
RECOVERY_TIME = 2.0  # [s] time after a push from which on the robot must follow its command
HOLD_TIME = 1.0  # [s] time for which it must follow it
PHASES, PHASE_TIME = 4, 0.1  # successive seeds push at PHASES times that are PHASE_TIME [s] apart
PUSH_STEP = 5.0  # [% of the LIP push limit] finest step of the levels


@dataclass(frozen=True)
class WalkUnit:
    """A walk with one velocity, from a stand to a stand.

    Attributes:
        condition: Condition of the walk.
        heading: Direction of steepest ascent of a slope, from forward towards left [deg].
        velocity: Commanded velocity.
        duration: Time for which the velocity is commanded [s].
        seed: Seed of sensors and motors.
    """

    condition: Condition
    heading: float
    velocity: Velocity
    duration: float
    seed: int
    deadline_factor: ClassVar[float] = 2.0  # such runs are about twice as long as a push

    @property
    def key(self) -> str:
        """Key of the unit in the store."""
        velocity = ",".join(f"{v:g}" for v in self.velocity)
        return f"walk | {self.condition.name} | {self.heading:g} deg | {velocity} | {self.seed}"

    def run(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, heartbeat: Heartbeat
    ) -> dict[str, Any]:
        """Walk, and return the figures as JSON values."""
        condition = replace(self.condition, headings_deg=(self.heading,))
        plant = walking_plant_of(source, condition)
        heartbeat()  # building the plant must not count against the deadline of a run
        plant.reseed(self.seed)
        control = controller_under_test.make_walking(plant.robot, loop_delay(plant))
        end = QUIET_TIME + self.duration
        schedule: Schedule = ((QUIET_TIME, self.velocity), (end, (0.0, 0.0, 0.0)))
        walk = walk_out(plant, condition, control, schedule, end + STOP_TIME)
        result: dict[str, Any] = json_value(walk_figures(walk, plant.robot, QUIET_TIME, end))
        return result


@dataclass(frozen=True)
class WalkPushUnit:
    """A sweep of push levels in one direction with one seed, while the robot walks.

    Attributes:
        condition: Condition of the runs.
        velocity: Commanded velocity.
        direction_deg: Direction, from the heading towards left [deg].
        seed: Seed of sensors and motors.
        phase: Number of the time of the push, 0 .. PHASES - 1.
        limit: LIP push limit [N.s]; a level of 100 % has this impulse.
        start_level: First level of the sweep [% of the LIP push limit].
    """

    condition: Condition
    velocity: Velocity
    direction_deg: float
    seed: int
    phase: int
    limit: float
    start_level: float
    deadline_factor: ClassVar[float] = 2.0

    @property
    def key(self) -> str:
        """Key of the unit in the store."""
        velocity = ",".join(f"{v:g}" for v in self.velocity)
        where = f"{velocity} | {self.direction_deg:g} deg"
        return f"walk push | {self.condition.name} | {where} | {self.seed}"

    def run(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, heartbeat: Heartbeat
    ) -> dict[str, Any]:
        """Run the sweep; return the largest level that was survived [% of the LIP push limit].

        If the controller fails during a push, the push counts as not survived, and the key "broken"
        has the text of the first failure.
        """

        def push(level: float) -> PushOutcome:
            passed = self._survives(source, controller_under_test, level)
            return PushOutcome(passed, passed, None, None, None)

        walking_plant_of(source, self.condition)
        heartbeat()  # building the plant must not count against the deadline of a run
        sweep, broken = sweep_pushes(push, self.start_level, PUSH_STEP, heartbeat)
        return {"percent_of_lip": sweep.largest_passed("survived"), **broken}

    def _survives(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, level: float
    ) -> bool:
        plant = walking_plant_of(source, self.condition)
        begin = QUIET_TIME + SETTLED_TIME + self.phase * PHASE_TIME
        impulse = level / 100.0 * self.limit
        plant.reseed(self.seed, [Push(self.direction_deg, impulse, PUSH_DURATION, begin)])
        control = controller_under_test.make_walking(plant.robot, loop_delay(plant))
        judged = begin + PUSH_DURATION + RECOVERY_TIME
        schedule: Schedule = ((QUIET_TIME, self.velocity),)
        walk = walk_out(plant, self.condition, control, schedule, judged + HOLD_TIME)
        return _follows(walk, judged)


def _follows(walk: TrueWalk, time: float) -> bool:
    """Return whether the robot follows its command from a time [s] to the end."""
    return not walk.fell and bool(np.all(recovered_ticks(walk)[round(time * walk.rate) :]))
