"""Plots of estimates with bands of two standard deviations, and of the truth."""

from __future__ import annotations

from itertools import chain

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from surefoot.estimate.estimate_result import Estimate
from surefoot.estimate.plot_rows import rows_to_plot
from surefoot.geometry.batch_rotations import Array
from surefoot.reports.plots import BLUE, ORANGE, finish_time_axis, subplot_grid, widen_y_axis


def three_bands(
    estimate: Estimate,
    values: Array,
    std: Array,
    labels: tuple[str, ...],
    truth: Array | None,
    span: float,
) -> Figure:
    """Draw three quantities in three axes, one above the other.

    Args:
        estimate: Estimate with the times of the rows.
        values: (m, 3) estimated quantities.
        std: (m, 3) standard deviations of the values.
        labels: Labels of the three y axes.
        truth: (m, 3) true quantities, or None.
        span: Smallest range of the y axes on either side of 0.
    """
    rows = rows_to_plot(estimate)
    figure, axes = subplot_grid(3, 1, 5.2)
    for k, ax in enumerate(chain.from_iterable(axes)):
        if truth is not None:
            ax.plot(estimate.time[rows], truth[rows, k], color=BLUE, label="true")
        band(ax, estimate.time[rows], values[rows, k], std[rows, k], label="estimated, 2 sigma")
        widen_y_axis(ax, span)
        ax.set_ylabel(labels[k])
    finish_time_axis(figure, axes, float(estimate.time[-1]))
    return figure


def band(
    ax: Axes, time: Array, value: Array, std: Array, color: str = ORANGE, label: str = ""
) -> None:
    """Draw a value with a band of two standard deviations on either side."""
    ax.fill_between(time, value - 2.0 * std, value + 2.0 * std, color=color, alpha=0.2, lw=0)
    ax.plot(time, value, color=color, lw=0.9, label=label or None)
