"""Polar plots of a scorecard: push results over push direction."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes

from surefoot.assess.push_score import summary_table
from surefoot.reports.plots import BLUE, GREEN, GREY, ORANGE, RED, Plot

_CRITERION_COLORS = (("survive", BLUE), ("strict", GREEN))
_REFERENCE_COLORS = (ORANGE, "#8e5bb5", "#7a5c3e")


def _draw_pushes(card: dict[str, Any]) -> Figure:
    tables = card["push"]["tables"]
    lengths = list(dict.fromkeys(table["length_s"] for table in tables))
    heights = list(dict.fromkeys(table["height_m"] for table in tables))
    size = 3.0 if len(tables) > 1 else 5.2
    figure = Figure(figsize=(max(5.2, size * len(lengths)), size * len(heights) + 0.8))
    figure.set_layout_engine("constrained")
    for table in tables:
        index = heights.index(table["height_m"]) * len(lengths) + lengths.index(table["length_s"])
        ax = _polar_axes(figure, len(heights), len(lengths), index)
        _plot_polar(ax, table, "limit_ns", RED, "push limit", ls="--")
        _plot_polar(ax, table, "lip_ns", GREY, "LIP push limit", ls=":")
        for kind, color in _CRITERION_COLORS:
            _plot_polar(ax, table, kind, color, kind)
        _finish_polar(ax, f"{table['length_s']:g} s, {table['height_m']:+g} m [N.s]")
    _legend(figure)
    return figure


def _draw_references(card: dict[str, Any]) -> Figure:
    figure = Figure(figsize=(9.2, 5.8), layout="constrained")
    controller_table = summary_table(card["push"]["tables"])
    for index, kind in enumerate(("survive", "strict")):
        ax = _polar_axes(figure, 1, 2, index)
        _plot_polar(ax, controller_table, "limit_ns", RED, "push limit", ls="--")
        _plot_polar(ax, controller_table, kind, BLUE, card["controller"])
        for (name, push), color in zip(card["references"].items(), _REFERENCE_COLORS, strict=False):
            _plot_polar(ax, summary_table(push["tables"]), kind, color, name)
        _finish_polar(
            ax,
            f"{kind}, {controller_table['length_s']:g} s, "
            f"{controller_table['height_m']:+g} m [N.s]",
        )
    _legend(figure)
    return figure


def _polar_axes(figure: Figure, rows: int, columns: int, index: int) -> PolarAxes:
    ax = figure.add_subplot(rows, columns, index + 1, projection="polar")
    assert isinstance(ax, PolarAxes)
    ax.set_theta_zero_location("N")  # the forward direction points up in the plot, left to the left
    ax.set_rlabel_position(60.0)  # [deg] angle at which the curves leave room for the labels
    return ax


def _finish_polar(ax: PolarAxes, title: str) -> None:
    max_radius = max(float(np.max(line.get_ydata())) for line in ax.get_lines())
    ax.set_ylim(0.0, 1.05 * max_radius)
    ax.set_title(title, pad=14.0)


def _plot_polar(
    ax: PolarAxes, table: dict[str, Any], name: str, color: str, label: str, ls: str = "-"
) -> None:
    rows = table["directions"]
    angles = np.radians([row["degrees"] for row in rows])
    values = [row[name]["ns"] if isinstance(row[name], dict) else row[name] for row in rows]
    ax.plot(np.append(angles, angles[0]), [*values, values[0]], color=color, ls=ls, label=label)


def _legend(figure: Figure) -> None:
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=len(labels))


PUSH_PLOT: Plot[dict[str, Any]] = Plot(
    "pushes.png",
    "Push results by direction",
    "Largest impulse below which every tried push was passed, statistic over seeds, against push "
    "direction; forward is up. One plot for each duration and height above the centre of mass.",
    _draw_pushes,
)
REFERENCE_PLOT: Plot[dict[str, Any]] = Plot(
    "references.png",
    "Comparison with the reference controllers",
    "All controllers receive the same pushes; forward is up.",
    _draw_references,
)


def plots_of(card: dict[str, Any]) -> tuple[Plot[dict[str, Any]], ...]:
    """Return the plots for which a scorecard has data."""
    return (PUSH_PLOT, REFERENCE_PLOT) if card["references"] else (PUSH_PLOT,)
