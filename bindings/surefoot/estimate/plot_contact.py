"""Plots of contact and of sensor verdicts."""

from __future__ import annotations

from itertools import chain

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from surefoot._core import SensorVerdict
from surefoot.estimate.estimate_result import SENSOR_NAMES, Estimate
from surefoot.estimate.plot_rows import rows_to_plot
from surefoot.estimate.truth_summary import true_rows
from surefoot.reports.plots import BLUE, GREEN, GREY, ORANGE, RED, finish_time_axis, subplot_grid

LEGS = ("front right", "front left", "rear right", "rear left")
_VERDICT_COLOURS = {
    SensorVerdict.GOOD: GREEN,
    SensorVerdict.UNJUDGED: "#dfe3e8",
    SensorVerdict.ZERO: GREY,
    SensorVerdict.CONSTANT: "#6d5bb5",
    SensorVerdict.SATURATED: ORANGE,
    SensorVerdict.DISAGREES: RED,
    SensorVerdict.IMPLAUSIBLE: "#7c1f1c",
}


def draw_contact(estimate: Estimate) -> Figure:
    """Draw each foot's contact confidence, and its measured and true vertical force."""
    rows = rows_to_plot(estimate)
    time = estimate.time[rows]
    truth = true_rows(estimate, "truth_foot_forces")
    reported_forces = estimate.log.columns.get("footForceEst")
    figure, axes = subplot_grid(2, 2, 5.2)
    for leg, ax in enumerate(chain.from_iterable(axes)):
        if truth is not None:
            force = truth[rows, 3 * leg + 2]
            ax.fill_between(time, force, color=GREEN, alpha=0.25, lw=0, label="true force [N]")
        if reported_forces is not None and np.any(reported_forces):
            values = reported_forces[estimate.rows][rows, leg]
            ax.plot(time, values, color=GREY, lw=0.7, label="footForceEst [N]")
        values = estimate.foot_forces_from_torques[rows, leg]
        ax.plot(time, values, color=BLUE, lw=0.8, label="from tauEst [N]")
        ax.plot([], [], color=ORANGE, label="contact confidence (right)")
        ax.set_title(LEGS[leg])
        ax.set_ylabel("force [N]")
        right = ax.twinx()
        right.plot(time, estimate.contact[rows, leg], color=ORANGE, lw=0.9)
        right.set_ylim(0.0, 1.15)
        right.set_yticks([0.0, 0.5, 1.0])
        right.grid(False)
        right.spines["right"].set_visible(True)
    finish_time_axis(figure, axes, float(estimate.time[-1]))
    return figure


def draw_verdicts(estimate: Estimate) -> Figure:
    """Draw the verdict on each sensor as stripes over time."""
    figure, axes = subplot_grid(1, 1, 3.8)
    ax = axes[0][0]
    order = list(_VERDICT_COLOURS)
    colour_index = {verdict.value: k for k, verdict in enumerate(order)}
    rows = rows_to_plot(estimate)
    codes = np.vectorize(colour_index.__getitem__, otypes=[np.int64])(estimate.verdicts[rows])
    # Draw each row until the time of the next row; the rows may be unevenly spaced.
    edges = np.append(estimate.time[rows], estimate.time[-1] + estimate.log.period)
    colours = ListedColormap(list(_VERDICT_COLOURS.values()))
    levels = np.arange(len(SENSOR_NAMES) + 1) - 0.5
    ax.pcolormesh(edges, levels, codes.T, cmap=colours, vmin=-0.5, vmax=len(order) - 0.5)
    ax.set_yticks(range(len(SENSOR_NAMES)), SENSOR_NAMES)
    ax.invert_yaxis()
    ax.grid(False)
    ax.set_xlabel("time [s]")
    patches = [Patch(color=_VERDICT_COLOURS[v], label=v.name.lower()) for v in order]
    figure.legend(handles=patches, loc="outside upper right", ncols=len(patches))
    return figure
