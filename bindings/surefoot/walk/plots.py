"""Plots of a walk: velocities, footsteps from above, gait, and those of every simulated run."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from surefoot.messages.low_state_layout import LEGS
from surefoot.reports.plots import BLUE, GREEN, GREY, ORANGE, RED, Plot, subplot_grid
from surefoot.stand.plots import draw_power, draw_ticks, draw_torques, finish_figure, shade_pushes
from surefoot.walk.heading_frame import commanded_path, heading_velocity
from surefoot.walk.steps import stance_phases
from surefoot.walk.walk_log import WalkLog

LEG_COLORS = (BLUE, ORANGE, GREEN, RED)
_PATH_COLOR = "#1f252b"
_TERRAIN_COLOR = "#b59b6d"


def draw_velocity(log: WalkLog) -> Figure:
    """Plot the true velocity in the heading frame, the command and the reference."""
    velocity = heading_velocity(log)
    labels = ("vx [m/s]", "vy [m/s]", "yaw rate [rad/s]")
    figure, axes = subplot_grid(3, 1, 5.2)
    for k, label in enumerate(labels):
        ax = axes[k][0]
        shade_pushes(ax, log)
        ax.plot(log.time, velocity[:, k], color=BLUE, label="true")
        ax.plot(log.time, log.reference[:, k], color=ORANGE, label="reference")
        ax.plot(log.time, log.commanded[:, k], color=GREY, ls="--", label="command, clamped")
        low, high = ax.get_ylim()
        middle = 0.5 * (low + high)
        ax.set_ylim(min(low, middle - 0.2), max(high, middle + 0.2))
        ax.set_ylabel(label)
    finish_figure(figure, axes, log)
    return figure


def draw_footsteps(log: WalkLog) -> Figure:
    """Plot from above: where each foot stood, the path of the centre of mass, and the command."""
    path = commanded_path(log)
    shown = [log.com[:, :2], path[:, :2], *(log.feet[:, :2, leg] for leg in range(4))]
    low, high = np.min([p.min(axis=0) for p in shown], 0), np.max([p.max(axis=0) for p in shown], 0)
    width, height = np.maximum(high - low, 0.3)
    figure = Figure(figsize=(9.2, float(np.clip(1.2 + 8.0 * height / width, 3.0, 9.2))))
    figure.set_layout_engine("constrained")
    ax = figure.subplots()
    for box in log.settings.plant.terrain.boxes():
        ax.fill(*box.corners().T, color=_TERRAIN_COLOR, alpha=_terrain_shade(box.height), zorder=0)
    ax.plot(path[:, 0], path[:, 1], color=GREY, ls="--", label="integrated command")
    ax.plot(log.com[:, 0], log.com[:, 1], color=_PATH_COLOR, label="centre of mass")
    for leg, color in enumerate(LEG_COLORS):
        stances = [phase for phase in stance_phases(log) if phase.leg == leg]
        middle = [(phase.start + phase.end) // 2 for phase in stances]
        x, y = log.feet[middle, 0, leg], log.feet[middle, 1, leg]
        ax.scatter(x, y, s=20.0, color=color, alpha=0.8, label=LEGS[leg])
    margin = 0.1 * float(np.max(high - low))
    ax.set_xlim(low[0] - margin, high[0] + margin)  # a terrain may be wider
    ax.set_ylim(low[1] - margin, high[1] + margin)
    ax.set_aspect("equal")  # keeps the limits, and makes the box fit
    ax.set_xlabel("x, forward at the start [m]")
    ax.set_ylabel("y, to the left [m]")
    figure.legend(loc="outside upper right", ncols=6)
    return figure


def _terrain_shade(height: float) -> float:
    """Return the opacity of a box; the boxes of stairs overlap, so the highest is darkest."""
    return 0.1 + 0.4 * min(1.0, height / 0.1)


def draw_gait(log: WalkLog) -> Figure:
    """Plot the true and the planned stance phases of each leg as bars over time."""
    figure, axes = subplot_grid(1, 1, 2.6)
    ax = axes[0][0]
    shade_pushes(ax, log)
    true = log.normal_forces > 0.0
    for leg, color in enumerate(LEG_COLORS):
        _draw_bars(ax, log, true[:, leg], leg - 0.34, color)
        _draw_bars(ax, log, log.planned_loads[:, leg] > 0.0, leg + 0.08, GREY)
    ax.bar(0.0, 0.0, color=_PATH_COLOR, label="coloured: true contact")
    ax.bar(0.0, 0.0, color=GREY, label="grey: planned load")
    ax.set_yticks(range(4), LEGS)
    ax.set_ylim(3.6, -0.6)
    ax.grid(axis="y", visible=False)
    finish_figure(figure, axes, log)
    return figure


def _draw_bars(ax: Axes, log: WalkLog, on: np.ndarray, top: float, color: str) -> None:
    edges = np.flatnonzero(np.diff(np.concatenate([[False], on, [False]]))) / log.rate
    spans = [(start, end - start) for start, end in edges.reshape(-1, 2).tolist()]
    ax.broken_barh(spans, (top, 0.34), color=color, lw=0)


PLOTS: tuple[Plot[WalkLog], ...] = (
    Plot(
        "velocity.png",
        "Velocity",
        "True velocity of the centre of mass and yaw rate in the heading frame, the command as the "
        "controller clamped it, and the reference that approaches it. Pushes are shaded red.",
        draw_velocity,
    ),
    Plot(
        "footsteps.png",
        "Footsteps from above",
        "True places of the feet in the middle of each stance phase, and the true path of the "
        "centre of mass, on the terrain. The integrated command has neither acceleration nor "
        "pushes.",
        draw_footsteps,
    ),
    Plot(
        "gait.png",
        "Gait",
        "Bars: the foot touches the ground (coloured), or carries planned load (grey).",
        draw_gait,
    ),
    Plot(
        "torques.png",
        "Joint torques and their limits",
        "True torque of every motor; dashed: torque limit at low speed.",
        draw_torques,
    ),
    Plot(
        "power.png", "Power", "Sum over all motors; braking counts as positive power.", draw_power
    ),
    Plot(
        "ticks.png",
        "Tick time",
        "CPU time of the controller's update() as called from Python on this machine.",
        draw_ticks,
    ),
)
