# SPDX-License-Identifier: BSD-3-Clause
"""What a set of weights is worth by pushes: what a robot survives, and whether its feet stay."""

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
RANGES = {  # all searched by their logarithm
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
    "foot_speed": (0.5, 10.0),
    "foot_step": (0.1, 0.5),
    "edge_rise": (0.3, 100.0),  # the end is off, as a1 has it
    "friction": (0.6, 0.8),  # [robot] friction, what the controller assumes
}
HEADINGS = tuple(22.5 * k for k in range(9))  # [deg] to the left: robots are symmetric
MAX_FALLS = 3  # of one heading; beyond the third, harder pushes tell nothing new
MAX_PENALTY = 9.0  # strict penalty from which on survival is not looked at


@dataclass(frozen=True)
class PushSet:
    """What a set is judged by.

    Attributes:
        levels: Pushes on level ground that may be survived, rising [% of the own limit].
        latency_levels: The same with 20 ms of latency [%].
        in_place_level: Push on level ground that no foot may move by a centimetre under [%].
        seeds: Of sensors and motors.
    """

    levels: Sequence[float]
    latency_levels: Sequence[float]
    in_place_level: float
    seeds: Sequence[int] = (0,)


def default_values(robot: str) -> dict[str, float]:
    """Return a robot's own values of what is searched, within the ranges."""
    config = load_robot(robot).config
    values = {**gain_values(config.gains), "friction": config.friction}
    return {name: float(np.clip(values[name], *RANGES[name])) for name in RANGES}


def controller_under_test(robot: str, values: dict[str, float]) -> ControllerUnderTest:
    """Return the controller with other values; the plant's floor stays as it is."""
    description = describe_robot(robot)
    rows = {**description.table["robot"], "friction": values["friction"]}
    changed_robot = build_robot(replace(description, table={**description.table, "robot": rows}))
    changed = {name: value for name, value in values.items() if name != "friction"}
    gains = {**gain_values(changed_robot.config.gains), **changed}

    def make(_: Robot, delay: float) -> StandController:
        return make_stand_controller(changed_robot, delay, gains)

    return ControllerUnderTest("searched", factory=make)


class PushedRobot:
    """A robot with a set of values, pushed.

    Args:
        robot: Its name.
        values: Of what is searched.
    """

    def __init__(self, robot: str, values: dict[str, float]) -> None:
        self._robot, self._limits = robot, PushLimits(load_robot(robot))
        self._contestant = controller_under_test(robot, values)

    def foot_travel_penalty(self, heading: float, seed: int, level: float) -> float:
        """Return by how many times 10 mm feet moved too far, 2 at most; 0.5 or more if late."""
        outcome, _ = self.push(LEVEL_GROUND, heading, seed, level)
        if outcome.in_place:
            return 0.0
        return float(np.clip(0.1 * outcome.foot_mm - 1.0, 0.5, 2.0)) if outcome.survived else 2.0

    def survived_levels(
        self, condition: Condition, heading: float, seed: int, levels: Sequence[float]
    ) -> float:
        """Return how many levels it survives; half of the share that it is upright under others."""
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
        """Push once: what came of it, and the share of the run that it was upright."""
        limit = self._limits.push_limit(LEVEL_GROUND, heading, 0.1, 0.0).limit
        unit = PushUnit(condition, heading, 0.1, 0.0, seed, limit)
        trajectory = unit.simulate(self._robot, self._contestant, level)
        upright = (len(trajectory.base) - 1) / (
            trajectory.rate * run_duration(condition.quiet_s, 0.1)
        )
        return judge_push(trajectory, condition.quiet_s, 0.1), upright


def score(robot: str, values: dict[str, float], pushes: PushSet) -> tuple[float, list[float]]:
    """Return what a set of values is worth, and how many levels each heading survives.

    The count of levels in all and twice that of the worst heading, on level ground and late, less
    the strict penalty; of an average seed.
    """
    pushed, seeds = PushedRobot(robot, values), pushes.seeds
    cases = [(heading, seed) for heading in HEADINGS for seed in seeds]
    penalty = sum(pushed.foot_travel_penalty(*case, pushes.in_place_level) for case in cases) / len(
        seeds
    )
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
