"""Plots of a search: history of costs, parameter importance, Pareto front, before and after."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from surefoot.reports.plots import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    Plot,
    finish_time_axis,
    subplot_grid,
)
from surefoot.stand.foot_frame import pose_from_feet, rotation_angle
from surefoot.tune.search.run import SearchResult
from surefoot.tune.search.walk_plot import draw_walk


@dataclass(frozen=True)
class PlotData:
    """Data of the plots.

    Attributes:
        result: Result of the search.
        records: Records of the first held-out episode, by name of the gains: start, own and best;
            each is a Trace of a stand or a WalkLog.
    """

    result: SearchResult
    records: dict[str, Any]


COLOURS = {"start": RED, "own": GREY, "best": BLUE}


def draw_history(data: PlotData) -> Figure:
    """Draw the cost of every trial, and the lowest cost so far."""
    result = data.result
    figure, axes = subplot_grid(len(result.settings.objectives), 1, 3.2)
    for k, (objective, (ax,)) in enumerate(zip(result.settings.objectives, axes, strict=True)):
        costs = np.array([trial.values[k] for trial in result.trials])
        stopped = np.array([bool(t.user_attrs.get("stopped")) for t in result.trials])
        number = np.arange(len(costs))
        ax.plot(number[~stopped], costs[~stopped], ".", color=GREY, label="trial")
        ax.plot(number[stopped], costs[stopped], "x", color=ORANGE, ms=4, label="stopped early")
        ax.plot(number, np.minimum.accumulate(costs), color=BLUE, label="best so far")
        ax.set_yscale("log")
        ax.set_ylabel(f"cost, {objective}")
    axes[-1][0].set_xlabel("trial")
    figure.legend(*axes[0][0].get_legend_handles_labels(), loc="outside upper right", ncols=3)
    return figure


def draw_importance(data: PlotData) -> Figure:
    """Draw the importance of each parameter for the cost."""
    items = sorted(data.result.importance.items(), key=lambda item: item[1])
    figure = Figure(figsize=(9.2, 0.6 + 0.24 * max(len(items), 1)), layout="constrained")
    ax = figure.subplots()
    ax.barh([name for name, _ in items], [100.0 * share for _, share in items], color=GREEN)
    ax.set_xlabel("share [%]")
    return figure


def draw_before_after(data: PlotData) -> Figure:
    """Draw one episode with the start gains, the robot's own gains and the best gains."""
    figure, axes = subplot_grid(3, 1, 6.0)
    end = 0.0
    for name, trace in data.records.items():
        time = trace.column("time")
        q = trace.column("base")[:, [0, 1, 2, 4, 5, 6, 3]]
        pose = pose_from_feet(q, np.moveaxis(trace.column("feet"), 1, 2))
        displacement = 1000.0 * np.linalg.norm(pose.position - pose.position[0], axis=1)
        angle = np.degrees(rotation_angle(pose.rotation[0].T @ pose.rotation))
        power = np.abs(trace.column("tau") * trace.column("dq")).sum(axis=1)
        for (ax,), rows in zip(axes, (displacement, angle, power), strict=True):
            ax.plot(time, rows, color=COLOURS[name], label=name)
        end = max(end, float(time[-1]))
    for (ax,), text in zip(
        axes, ("base displacement [mm]", "base angle [deg]", "power [W]"), strict=True
    ):
        ax.set_ylabel(text)
    finish_time_axis(figure, axes, end)
    return figure


def draw_front(data: PlotData) -> Figure:
    """Draw both objectives of every trial, and the Pareto front."""
    result = data.result
    figure = Figure(figsize=(9.2, 4.2), layout="constrained")
    ax = figure.subplots()
    costs = np.array([trial.values for trial in result.trials])
    front = np.array(sorted(tuple(trial.values) for trial in result.front))
    ax.plot(costs[:, 0], costs[:, 1], ".", color=GREY, label="trial")
    ax.plot(front[:, 0], front[:, 1], ".-", color=BLUE, label="front")
    if result.start.search_costs:
        ax.plot(*result.start.search_costs, "s", color=RED, label="start")
    ax.plot(*result.best.search_costs, "o", color=BLUE, label="best")
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel(f"cost, {result.settings.objectives[0]}")
    ax.set_ylabel(f"cost, {result.settings.objectives[1]}")
    ax.legend()
    return figure


HISTORY = Plot(
    "history.png",
    "Cost of the trials",
    "All trials, in the order in which they began.",
    draw_history,
)
IMPORTANCE = Plot(
    "importance.png",
    "Importance of the parameters",
    "How much each parameter distinguishes good trials from the others (PED-ANOVA).",
    draw_importance,
)
BEFORE_AFTER = Plot(
    "before_after.png",
    "Before and after",
    "One held-out episode, with the same robot, ground and pushes for all gains.",
    draw_before_after,
)
WALK_BEFORE_AFTER: Plot[PlotData] = Plot(
    "before_after.png",
    "Before and after",
    "One held-out walk, with the same robot, ground, commands and pushes for all gains; the "
    "command is black.",
    lambda data: draw_walk(data.records, COLOURS),
)
FRONT = Plot(
    "front.png",
    "Pareto front",
    "No trial is better in both objectives than a trial of the front.",
    draw_front,
)


def search_plots(result: SearchResult) -> list[Plot[PlotData]]:
    """Return the plots for which the search has data."""
    plots = [WALK_BEFORE_AFTER if result.settings.walk else BEFORE_AFTER, HISTORY]
    if result.importance:
        plots.append(IMPORTANCE)
    if result.front:
        plots.append(FRONT)
    return plots
