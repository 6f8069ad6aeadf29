"""Style of report plots, and helpers that draw them into the folder of a report."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, TypeVar

from matplotlib import style
from matplotlib.axes import Axes
from matplotlib.figure import Figure

BLUE, ORANGE, GREEN, RED, GREY = "#2f6db5", "#e08a1e", "#2a9d5c", "#d1342f", "#8a929b"
STYLE: dict[str, Any] = {
    "font.size": 9.0,
    "axes.titlesize": 9.5,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#b6bcc4",
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6e9ed",
    "lines.linewidth": 1.1,
    "legend.frameon": False,
    "xtick.color": "#4a525b",
    "ytick.color": "#4a525b",
}

Data = TypeVar("Data")


@dataclass(frozen=True)
class Plot(Generic[Data]):
    """One plot of a report.

    Attributes:
        file: File name in the folder of the report.
        title: Heading.
        caption: Description of the plot.
        draw: Function that draws the data.
    """

    file: str
    title: str
    caption: str
    draw: Callable[[Data], Figure]


def draw_plots(plots: Iterable[Plot[Data]], data: Data, folder: Path) -> None:
    """Write every plot of `data` into a folder as PNG."""
    with style.context(STYLE):
        for plot in plots:
            plot.draw(data).savefig(folder / plot.file, dpi=130)


def subplot_grid(rows: int, columns: int, height: float) -> tuple[Figure, list[list[Axes]]]:
    """Return a figure with a grid of axes that share the time axis; `height` in inches."""
    figure = Figure(figsize=(9.2, height), layout="constrained")
    axes = figure.subplots(rows, columns, sharex=True, squeeze=False)
    return figure, [list(row) for row in axes]


def widen_y_axis(ax: Axes, span: float) -> None:
    """Widen the y axis to at least [-span, span], so that small noise is not drawn large."""
    low, high = ax.get_ylim()
    ax.set_ylim(min(low, -span), max(high, span))


def finish_time_axis(figure: Figure, axes: list[list[Axes]], duration: float) -> None:
    """Label the time axis, 0 .. duration [s], and add one legend above all plots."""
    for ax in axes[-1]:
        ax.set_xlabel("time [s]")
        ax.set_xlim(0.0, max(duration, 1e-3))
    handles, labels = axes[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=len(labels))
