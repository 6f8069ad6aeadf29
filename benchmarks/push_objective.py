# SPDX-License-Identifier: BSD-3-Clause
"""Objective of the weight search: pushes that the robot survives, and how far its feet move."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from surefoot import Robot, StandController, load_robot
from surefoot.assess import Condition, ControllerUnderTest
from surefoot.assess.controller_under_test import make_stand_controller
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_outcome import PushOutcome, judge_push, run_duration
from surefoot.assess.work_units import PushUnit
from surefoot.robot.gain_files import gain_values
from surefoot.robot.loading import build_robot, describe_robot

LEVEL_GROUND = Condition("level ground")
LATENCY_20_MS = Condition("latency 20 ms", latency_ms=20.0)
RANGES = {  # smallest and largest value of each parameter, on a logarithmic scale
    "weight_com_horizontal": (0.2, 4.0),
    "weight_com_vertical": (0.05, 10.0),
    "weight_base_tilt": (1.5, 30.0),
    "weight_base_yaw": (0.1, 3.0),
    "weight_force": (0.02, 2.0),
    "penalty_hold_down": (0.05, 3.0),
    "edge_margin": (0.02, 0.3),
    "edge_tilt": (0.01, 0.5),
    "edge_height": (0.01, 1.0),
    "edge_load": (0.02, 0.7),
    "push_time": (0.008, 0.02),
    "edge_rise": (0.3, 100.0),  # 100 disables the limit
    "friction": (0.6, 0.8),  # assumed by the controller: `friction` in the TOML section `robot`
}
HEADINGS = tuple(22.5 * k for k in range(9))  # [deg] only to the left, because robots are symmetric
MAX_FALLS = 3  # number of falls per heading after which harder pushes are skipped
MAX_PENALTY = 9.0  # foot displacement penalty above which survival is not evaluated


@dataclass(frozen=True)
class PushSet:
    """Pushes with which a set of values is evaluated.

    Attributes:
        levels: Rising levels of pushes on level ground [% of the push limit].
        latency_levels: Rising levels of pushes with 20 ms of latency [% of the push limit].
        in_place_level: Level on level ground at which no foot may move by more than 1 cm [%].
        seeds: Seeds of sensors and motors.
    """

    levels: Sequence[float]
    latency_levels: Sequence[float]
    in_place_level: float
    seeds: Sequence[int] = (0,)


def default_values(robot: str) -> dict[str, float]:
    """Return the robot's values of the searched parameters, clipped to RANGES."""
    config = load_robot(robot).config
    values = {**gain_values(config.gains), "friction": config.friction}
    return {name: float(np.clip(values[name], *RANGES[name])) for name in RANGES}


def controller_under_test(robot: str, values: dict[str, float]) -> ControllerUnderTest:
    """Return the controller with the given values; the floor of the plant does not change."""
    description = describe_robot(robot)
    rows = {**description.table["robot"], "friction": values["friction"]}
    changed_robot = build_robot(replace(description, table={**description.table, "robot": rows}))
    changed = {name: value for name, value in values.items() if name != "friction"}
    gains = {**gain_values(changed_robot.config.gains), **changed}

    def make(_: Robot, delay: float) -> StandController:
        return make_stand_controller(changed_robot, delay, gains)

    return ControllerUnderTest("searched", factory=make)


class PushedRobot:
    """Robot with a set of values, for push tests.

    Args:
        robot: Name of the robot.
        values: Values of the searched parameters.
    """

    def __init__(self, robot: str, values: dict[str, float]) -> None:
        self._robot, self._limits = robot, PushLimits(load_robot(robot))
        self._controller = controller_under_test(robot, values)

    def foot_displacement_penalty(self, heading: float, seed: int, level: float) -> float:
        """Return the penalty of a push that is not in place, 0 .. 2.

        The penalty is (foot displacement - 10 mm) / 10 mm, clipped to 0.5 .. 2. It is 2 after a
        fall, and 0 if the push is in place.
        """
        outcome, _ = self.push(LEVEL_GROUND, heading, seed, level)
        if outcome.in_place:
            return 0.0
        return float(np.clip(0.1 * outcome.foot_mm - 1.0, 0.5, 2.0)) if outcome.survived else 2.0

    def survived_levels(
        self, condition: Condition, heading: float, seed: int, levels: Sequence[float]
    ) -> float:
        """Return the number of levels survived.

        A level with a fall counts as half the share of the run in which the robot is upright. After
        MAX_FALLS falls no further level is run.
        """
        count, falls = 0.0, 0
        for level in levels:
            outcome, upright = self.push(condition, heading, seed, level)
            count += 1.0 if outcome.survived else 0.5 * upright
            falls += not outcome.survived
            if falls == MAX_FALLS:
                break
        return count

    def push(
        self, condition: Condition, heading: float, seed: int, level: float
    ) -> tuple[PushOutcome, float]:
        """Push once; return the outcome, and the share of the run in which the robot is upright."""
        limit = self._limits.push_limit(LEVEL_GROUND, heading, 0.1, 0.0).limit
        unit = PushUnit(condition, heading, 0.1, 0.0, seed, limit)
        trajectory = unit.simulate(self._robot, self._controller, level)
        upright = (len(trajectory.base) - 1) / (
            trajectory.rate * run_duration(condition.quiet_s, 0.1)
        )
        return judge_push(trajectory, condition.quiet_s, 0.1), upright


def score(robot: str, values: dict[str, float], pushes: PushSet) -> tuple[float, list[float]]:
    """Return the objective of a set of values, and the number of levels survived by heading.

    The objective is a sum over both conditions (level ground, 20 ms of latency), minus the foot
    displacement penalty. The term of a condition is the number of levels survived over all
    headings, averaged over seeds, plus twice the number of the worst heading and seed. If the
    penalty is above MAX_PENALTY, the objective is only the negative penalty.
    """
    pushed, seeds = PushedRobot(robot, values), pushes.seeds
    cases = [(heading, seed) for heading in HEADINGS for seed in seeds]
    penalty = sum(
        pushed.foot_displacement_penalty(*case, pushes.in_place_level) for case in cases
    ) / len(seeds)
    if penalty > MAX_PENALTY:
        return -penalty, []
    objective, counts = -penalty, np.zeros(len(HEADINGS))
    for condition, levels in (
        (LEVEL_GROUND, pushes.levels),
        (LATENCY_20_MS, pushes.latency_levels),
    ):
        survived = np.array([pushed.survived_levels(condition, *case, levels) for case in cases])
        objective += survived.sum() / len(seeds) + 2.0 * survived.min()
        counts += survived.reshape(len(HEADINGS), -1).mean(axis=1)
    return float(objective), counts.tolist()
