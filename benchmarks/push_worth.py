# SPDX-License-Identifier: BSD-3-Clause
"""What a set of weights is worth by pushes: how far a robot survives, and whether its feet stay."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from surefoot import StandController, load_robot
from surefoot.assess import Condition, Contestant
from surefoot.assess.push_limits import Limits
from surefoot.assess.push_run import Outcome, judge, run_length
from surefoot.assess.unit import PushUnit
from surefoot.gain_files import gain_values, gains_of
from surefoot.robots import build_robot, describe_robot

LEVEL = Condition("level ground")
RANGES = {  # all searched by their logarithm
    "weight_com_horizontal": (0.2, 4.0),
    "weight_com_vertical": (0.05, 5.0),
    "weight_base_tilt": (1.5, 12.0),
    "weight_base_yaw": (0.1, 3.0),
    "weight_force": (0.02, 2.0),
    "penalty_hold_down": (0.05, 3.0),
    "edge_margin": (0.02, 0.3),
    "edge_tilt": (0.01, 0.5),
    "edge_load": (0.02, 0.7),
    "push_time": (0.008, 0.02),
    "foot_speed": (0.5, 10.0),
    "foot_step": (0.1, 0.5),
    "edge_rise": (0.3, 100.0),  # the end is off, as a1 has it
    "friction": (0.6, 0.8),  # [robot] friction, what the controller assumes
}
# Heading [deg] and seed. Robots fall first 22.5 degrees off fore and aft.
HARDEST = ((0.0, 2), (22.5, 0), (157.5, 0), (157.5, 1), (180.0, 1), (202.5, 0), (202.5, 2))
AROUND = ((0.0, 0), (22.5, 1), (90.0, 2), (135.0, 0), (157.5, 0), (180.0, 1), (337.5, 2))
LEVELS = tuple(np.arange(80.0, 132.5, 2.5))  # [%] of the own limit
HOPELESS = 15.0  # strict penalty from which on survival is not looked at


def own_values(robot: str) -> dict[str, float]:
    """Return a robot's own values of what is searched, within the ranges."""
    config = load_robot(robot).config
    values = {**gain_values(config.gains), "friction": config.friction}
    return {name: float(np.clip(values[name], *RANGES[name])) for name in RANGES}


def contestant(robot: str, values: dict[str, float]) -> Contestant:
    """Return the controller with other values; the plant's floor stays as it is."""
    description = describe_robot(robot)
    rows = {**description.table["robot"], "friction": values["friction"]}
    built = build_robot(replace(description, table={**description.table, "robot": rows}))
    changed = {name: value for name, value in values.items() if name != "friction"}
    gains = gains_of({**gain_values(built.config.gains), **changed})
    return Contestant("searched", factory=lambda _: StandController(built, gains))


class Pushed:
    """A robot with a set of values, pushed.

    Args:
        robot: Its name.
        values: Of what is searched.
    """

    def __init__(self, robot: str, values: dict[str, float]) -> None:
        self._robot, self._limits = robot, Limits(load_robot(robot))
        self._contestant = contestant(robot, values)

    def too_far(self, heading: float, seed: int, level: float) -> float:
        """Return by how many times 10 mm feet moved too far; 0.5 or more if late, 2 if it fell."""
        outcome, _ = self.push(heading, seed, level)
        if outcome.strict:
            return 0.0
        return max(0.1 * outcome.foot_mm - 1.0, 0.5) if outcome.survived else 2.0

    def survives(self, heading: float, seed: int) -> float:
        """Return the last of LEVELS that it survives [%], more the later it falls at the next."""
        best = 0.0
        for level in LEVELS:
            outcome, upright = self.push(heading, seed, level)
            if not outcome.survived:
                return best + 2.0 * upright
            best = level
        return best

    def push(self, heading: float, seed: int, level: float) -> tuple[Outcome, float]:
        """Push once: what came of it, and the share of the run that it was upright."""
        limit = self._limits.of(LEVEL, heading, 0.1, 0.0).own
        unit = PushUnit(LEVEL, heading, 0.1, 0.0, seed, limit)
        track = unit.play(self._robot, self._contestant, level)
        upright = (len(track.base) - 1) / (track.rate * run_length(LEVEL.quiet_s, 0.1))
        return judge(track, LEVEL.quiet_s, 0.1), upright


def score(robot: str, values: dict[str, float], strict: float) -> tuple[float, list[float]]:
    """Return what a set of values is worth, and the survived levels of HARDEST [%].

    Args:
        robot: Its name.
        values: Of what is searched.
        strict: Level at which no foot may move by a centimetre [%].
    """
    pushed = Pushed(robot, values)
    penalty = 10.0 * sum(pushed.too_far(*push, strict) for push in AROUND)
    if penalty > HOPELESS:
        return -penalty, []
    survived = [pushed.survives(*push) for push in HARDEST]
    return float(np.mean(survived)) + min(survived) - 2.0 * penalty, survived
