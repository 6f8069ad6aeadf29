"""Figures of each commanded velocity, and the worst of them."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import WalkLimit
from surefoot.stand.simulation_log import Array
from surefoot.stand.spectrum import high_frequency_rms
from surefoot.walk.heading_frame import attitude_on_ground, heading_velocity
from surefoot.walk.steps import LOADED
from surefoot.walk.velocity_request import velocity_ticks
from surefoot.walk.walk_log import WalkLog
from surefoot.walk.walk_motion import WalkMotion

# [s] Time after a command that its figures leave out: the robot accelerates. Chosen: longer than
# the acceleration to the largest velocity.
SETTLING = 1.0
MIN_SPEED = 0.1  # [m/s] below it, the cost of transport has no meaning


def command_figures(log: WalkLog) -> list[dict[str, Any]]:
    """Return the figures of each commanded velocity that the run reached, by time.

    The figures cover the time from SETTLING after the command to the next command or the end of the
    run. They are None if no time is left.
    """
    ticks = velocity_ticks(log.settings.velocities, log.rate)
    reached = [(k, request) for k, request in ticks if k < len(log.time)]
    edges = [*(k for k, _ in reached), len(log.time)]
    entries = []
    for (start, request), end in zip(reached, edges[1:], strict=True):
        window = slice(start + round(SETTLING * log.rate), end)
        entries.append(
            {
                "velocity": [request.vx, request.vy, request.yaw_rate],
                "time": request.time,
                "commanded_velocity": log.commanded[start],
                "limit": WalkLimit(int(log.limit[start])).name.lower(),
                **window_figures(log, window),
            }
        )
    return entries


def worst_command(entries: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the worst value of each figure over all commands, each axis for itself.

    The worst is the largest, of three_or_more_loaded the smallest.

    None: no command has the figure.
    """
    worst: dict[str, Any] = {}
    for name in _NO_FIGURES:
        values = [entry[name] for entry in entries if entry[name] is not None]
        of_all = np.min if name == "three_or_more_loaded" else np.max
        worst[name] = of_all(values, axis=0) if values else None
    return worst


_NO_FIGURES: dict[str, Any] = {
    "velocity_mean_error": None,
    "velocity_rmse": None,
    "roll_pitch_rms_deg": None,
    "three_or_more_loaded": None,
    "cost_of_transport": None,
    "torque_hf_rms": None,
}


def window_figures(log: WalkMotion, window: slice) -> dict[str, Any]:
    """Return velocity errors, attitude, cost of transport and torque noise over some ticks.

    Each is None if the window is empty.
    """
    if window.start >= window.stop:
        return dict(_NO_FIGURES)
    velocity = heading_velocity(log)[window]
    loaded = log.normal_forces[window] > LOADED * log.weight
    error = velocity - log.commanded[window]
    angles = np.degrees(attitude_on_ground(log)[window, :2] - log.body_reference[window, 1:])
    return {
        "velocity_mean_error": np.abs(error.mean(axis=0)),
        "velocity_rmse": rms(error),
        "roll_pitch_rms_deg": rms(angles),
        "three_or_more_loaded": float(np.mean(loaded.sum(axis=1) >= 3)),
        "cost_of_transport": _cost_of_transport(log, window, velocity),
        "torque_hf_rms": high_frequency_rms(log.tau[window], log.rate).max(),
    }


def _cost_of_transport(log: WalkMotion, window: slice, velocity: Array) -> float | None:
    speed = float(np.linalg.norm(velocity[:, :2].mean(axis=0)))
    if speed < MIN_SPEED:
        return None
    power = np.maximum(log.tau[window] * log.dq[window], 0.0).sum(axis=1).mean()
    return float(power) / (log.weight * speed)


def rms(values: Array) -> Array:
    """Return the root mean square of each column."""
    return np.asarray(np.sqrt(np.mean(values**2, axis=0)))
