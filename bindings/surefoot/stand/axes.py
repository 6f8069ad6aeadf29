"""How a stand's plots look: shaded pushes, times of the run."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from surefoot.reports.plots import RED, finish_time_axis
from surefoot.stand.stand_log import StandLog


def shade_pushes(ax: Axes, log: StandLog) -> None:
    """Shade the time of every push."""
    for push in log.pushes:
        ax.axvspan(push.time, push.time + push.duration, color=RED, alpha=0.25, lw=0)


def finish_figure(figure: Figure, axes: list[list[Axes]], log: StandLog) -> None:
    """Label the time axis and explain the lines once, above all plots."""
    finish_time_axis(figure, axes, log.duration)
