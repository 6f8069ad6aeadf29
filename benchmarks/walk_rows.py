"""Rows of walk_table.py: the walk of each row, and the figures that are asked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from surefoot import Gait
from surefoot.robot.loading import build_robot, describe_robot
from surefoot.sim import PlantSettings
from surefoot.stand import parse_push
from surefoot.walk import VelocityRequest, WalkLog, WalkSettings
from surefoot.walk.heading_frame import commanded_path, heading_velocity
from surefoot.walk.settings import walking_plant
from surefoot.walk.steps import stance_phases

START = 0.5  # [s] time of the first command: the robot stands before
PUSH_TIME = 3.0  # [s] time of a push; its phase of the gait is added
RECOVERY = 2.0  # [s] time after a push in which the robot recovers

Check = Callable[[WalkLog, dict[str, Any]], dict[str, tuple[float, float]]]
"""Function that returns the figures of a run by name, each with its largest allowed value."""


@dataclass(frozen=True)
class Row:
    """One row: a walk and what is asked of it.

    Attributes:
        name: Name for --row.
        settings: Function that returns the settings for a robot and a seed.
        check: Function that returns the figures beside what is asked.
        robots: Robots that the row asks about.
        allowed: Share of the seeds that may fail.
        seeds: Number of seeds that the row needs at least.
    """

    name: str
    settings: Callable[[str, int], WalkSettings]
    check: Check
    robots: tuple[str, ...] = ("a1", "go1", "go2", "b1")
    allowed: float = 0.0
    seeds: int = 1


SMALL = ("a1", "go1", "go2")


def walk(
    robot: str,
    seed: int,
    velocity: tuple[float, float, float],
    duration: float = 6.0,
    plant: dict[str, Any] | None = None,
    **more: Any,
) -> WalkSettings:
    """Return a walk with one command; seeds take turns with and without foot forces."""
    settings: PlantSettings = replace(
        walking_plant(),
        seed=seed,
        foot_force="est" if seed % 2 else "dead",
        **(plant or {}),
    )
    velocities = (VelocityRequest(*velocity, START),)
    more = {"gait": Gait.TROT if not any(velocity) else Gait.AUTO, "velocities": velocities} | more
    return WalkSettings(robot=robot, duration=duration, plant=settings, **more)


def check_upright(log: WalkLog, summary: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Ask that the robot does not fall, walks on to the end of the terrain, and no legs touch."""
    figures = {"falls": (float(log.fell), 0.0), "leg contacts": (summary["leg_contacts"], 0.0)}
    end = log.settings.plant.terrain.end
    if end:
        figures["m short of the end"] = (max(0.0, end - float(log.com[-1, 0])), 0.0)
    return figures


def check_velocity(log: WalkLog, summary: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Ask for the velocity errors and the quality of a walk on flat ground."""
    figures = check_upright(log, summary)
    if summary["velocity_rmse"] is None:
        return figures
    command = log.settings.velocities[0]
    asked = np.array([command.vx, command.vy, command.yaw_rate])
    fast = abs(command.vx) > 1.0
    rmse = (0.1, 0.1, 0.2) if fast else (0.05, 0.05, 0.1)
    for k, axis in enumerate(("vx", "vy", "yaw")):
        limit = max(0.02, 0.03 * abs(float(asked[k])))
        figures[f"{axis} mean error"] = (summary["velocity_mean_error"][k], limit)
        figures[f"{axis} RMSE"] = (summary["velocity_rmse"][k], rmse[k])
    for name, value in zip(("roll", "pitch"), summary["roll_pitch_rms_deg"], strict=True):
        figures[f"{name} RMS deg"] = (value, 1.0)
    figures["slip mm"] = (summary["slip_mm_per_step"] or 0.0, 5.0)
    figures["touchdown m g"] = (summary["touchdown_force_mg"] or 0.0, 2.0)
    if not fast:
        figures["saturated %"] = (100.0 * summary["saturated_ticks"] / summary["ticks"], 1.0)
    if asked.tolist() == [1.0, 0.0, 0.0]:
        figures["cost of transport"] = (summary["cost_of_transport"], 0.55)
    figures["failed ticks"] = (summary["failed_ticks"], 0.0)
    return figures


def check_walk_gait(log: WalkLog, summary: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Ask for the velocity errors of a gait walk, and for three loaded feet in 95 % of ticks."""
    figures = check_velocity(log, summary)
    if summary["three_or_more_loaded"] is not None:
        figures["ticks below three feet %"] = (100.0 * (1.0 - summary["three_or_more_loaded"]), 5.0)
    return figures


def check_straight(log: WalkLog, summary: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Ask for heading, path and equal strides of a long straight walk."""
    if log.fell:
        return check_upright(log, summary)
    middle: dict[int, list[np.ndarray]] = {leg: [] for leg in range(4)}
    for phase in stance_phases(log):
        middle[phase.leg].append(log.feet[(phase.start + phase.end) // 2, :2, phase.leg])
    # Without the first and last strides, in which the robot starts and the run ends.
    strides = [
        np.linalg.norm(np.diff(np.array(middle[leg])[3:-1], axis=0), axis=1).mean()
        for leg in range(4)
    ]
    # As the other errors, from 1 s after the command on: the robot first has to gain its speed.
    start = np.searchsorted(log.time, log.settings.velocities[0].time + 1.0)
    error = log.com[:, :2] - commanded_path(log)[:, :2]
    return check_upright(log, summary) | {
        "heading deg": (summary["heading_error_deg"], 3.0),
        "path m": (float(np.linalg.norm(error[-1] - error[start])), 0.15),
        "strides mm": (500.0 * abs(strides[0] + strides[2] - strides[1] - strides[3]), 5.0),
    }


def check_start_and_stop(log: WalkLog, summary: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Ask for the times in which 1 m/s is reached and the robot stands again."""
    first, stop = (request.time for request in log.settings.velocities)
    speed = heading_velocity(log)[:, 0]
    reached = np.flatnonzero((log.time > first) & (speed > 0.95))
    walking = np.flatnonzero(log.walking)
    # The mean over a second: the speed oscillates with the steps.
    overshoot = np.convolve(speed, np.ones(round(log.rate)) / log.rate, "valid").max() - 1.0
    return check_upright(log, summary) | {
        "s to 0.95 m/s": (float(log.time[reached[0]]) - first if len(reached) else np.inf, 1.0),
        "overshoot %": (100.0 * float(overshoot), 10.0),
        "s to a stand": (float(log.time[walking[-1]]) - stop if len(walking) else np.inf, 1.5),
        "feet mm": (summary["stance_error_mm"], 20.0),
        "not standing": (float(not summary["stands_at_end"]), 0.0),
    }


def check_push(log: WalkLog, summary: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Ask that the robot has its velocity and attitude again RECOVERY after a push."""
    figures = {"falls": (float(log.fell), 0.0)}
    if log.fell:
        return figures
    late = log.time > log.pushes[0].time + log.pushes[0].duration + RECOVERY
    error = heading_velocity(log)[late, :2] - log.commanded[late, :2]
    # Over whole steps: the velocity oscillates with them.
    window = np.ones(round(0.4 * log.rate)) / round(0.4 * log.rate)
    mean = [np.convolve(error[:, k], window, "valid") for k in range(2)]
    q = log.q_true[late, 3:7]
    tilt = np.degrees(2.0 * np.arcsin(np.minimum(1.0, np.hypot(q[:, 0], q[:, 1]))))
    return figures | {
        "m/s off": (float(np.hypot(*mean).max()), 0.15),
        "tilt deg": (float(tilt.max()), 5.0),
    }


def pushed(
    robot: str, seed: int, speed: float, share: float, direction: float, phase: int
) -> WalkSettings:
    """Return a walk that is pushed, at one of four phases of the gait."""
    period = 2.4 * np.sqrt(nominal_height(robot) / 9.81)  # gain gait_period
    time = PUSH_TIME + 0.25 * phase * period
    push = parse_push(f"{direction:g}:{100.0 * share:g}%:0.1@{time:g}")
    duration = round(time + 0.1 + RECOVERY + 0.8, 2)
    return walk(robot, seed, (speed, 0.0, 0.0), duration, pushes=(push,))


def nominal_height(robot: str) -> float:
    """Return the height of the base above the feet in the standing pose [m]."""
    from surefoot.stand.foot_frame import foot_positions

    built = build_robot(describe_robot(robot))
    q = np.asarray(built.q_standing())
    return float(q[2] - foot_positions(built, q[None])[0][2].mean())
