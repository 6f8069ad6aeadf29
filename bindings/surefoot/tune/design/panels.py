"""Figures with four panels, one per axis of a design."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from surefoot.reports.plots import subplot_grid


def four_panels(height: float) -> tuple[Figure, list[Axes]]:
    """Return an empty figure of this height [inch], and its panels in the order of AXES."""
    figure, axes = subplot_grid(2, 2, height)
    return figure, [ax for row in axes for ax in row]


def add_legend(figure: Figure, axes: Sequence[Axes]) -> None:
    """Add a legend that lists each label of all panels once."""
    handles: dict[str, Artist] = {}
    for ax in axes:
        for handle, label in zip(*ax.get_legend_handles_labels(), strict=True):
            handles.setdefault(label, handle)
    figure.legend(
        list(handles.values()), list(handles), loc="outside upper right", ncols=len(handles)
    )
