"""Pictures of feet and of verdicts."""

from __future__ import annotations

from itertools import chain

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from surefoot._core import Verdict
from surefoot.estimate.result import SENSOR_NAMES, Estimate
from surefoot.estimate.thinning import shown_rows
from surefoot.estimate.truth_summary import true_rows
from surefoot.report_axes import BLUE, GREEN, GREY, ORANGE, RED, finish_time, grid

LEGS = ("front right", "front left", "rear right", "rear left")
_COLOURS = {
    Verdict.GOOD: GREEN,
    Verdict.UNJUDGED: "#dfe3e8",
    Verdict.ZERO: GREY,
    Verdict.CONSTANT: "#6d5bb5",
    Verdict.SATURATED: ORANGE,
    Verdict.DISAGREES: RED,
    Verdict.IMPLAUSIBLE: "#7c1f1c",
}


def draw_contact(estimate: Estimate) -> Figure:
    """Draw each foot's probability of contact, and its vertical force by source and in truth."""
    rows = shown_rows(estimate)
    time = estimate.time[rows]
    truth = true_rows(estimate, "truth_foot_forces")
    told = estimate.log.columns.get("footForceEst")
    figure, axes = grid(2, 2, 5.2)
    for leg, ax in enumerate(chain.from_iterable(axes)):
        if truth is not None:
            force = truth[rows, 3 * leg + 2]
            ax.fill_between(time, force, color=GREEN, alpha=0.25, lw=0, label="true force [N]")
        if told is not None and np.any(told):
            values = told[estimate.rows][rows, leg]
            ax.plot(time, values, color=GREY, lw=0.7, label="footForceEst [N]")
        values = estimate.torque_forces[rows, leg]
        ax.plot(time, values, color=BLUE, lw=0.8, label="from tauEst [N]")
        ax.plot([], [], color=ORANGE, label="probability (right)")
        ax.set_title(LEGS[leg])
        ax.set_ylabel("force [N]")
        right = ax.twinx()
        right.plot(time, estimate.contact[rows, leg], color=ORANGE, lw=0.9)
        right.set_ylim(0.0, 1.15)
        right.set_yticks([0.0, 0.5, 1.0])
        right.grid(False)
        right.spines["right"].set_visible(True)
    finish_time(figure, axes, float(estimate.time[-1]))
    return figure


def draw_verdicts(estimate: Estimate) -> Figure:
    """Draw what each sensor was held for, as stripes over time."""
    figure, axes = grid(1, 1, 3.8)
    ax = axes[0][0]
    order = list(_COLOURS)
    places = {verdict.value: k for k, verdict in enumerate(order)}
    rows = shown_rows(estimate)
    codes = np.vectorize(places.__getitem__, otypes=[np.int64])(estimate.verdicts[rows])
    # Rows need not be evenly spaced: each holds until the next.
    edges = np.append(estimate.time[rows], estimate.time[-1] + estimate.log.period)
    colours = ListedColormap(list(_COLOURS.values()))
    levels = np.arange(len(SENSOR_NAMES) + 1) - 0.5
    ax.pcolormesh(edges, levels, codes.T, cmap=colours, vmin=-0.5, vmax=len(order) - 0.5)
    ax.set_yticks(range(len(SENSOR_NAMES)), SENSOR_NAMES)
    ax.invert_yaxis()
    ax.grid(False)
    ax.set_xlabel("time [s]")
    patches = [Patch(color=_COLOURS[v], label=v.name.lower()) for v in order]
    figure.legend(handles=patches, loc="outside upper right", ncols=len(patches))
    return figure
