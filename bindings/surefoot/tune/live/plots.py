"""Four plots of the metrics of the last seconds."""

from __future__ import annotations

from typing import NamedTuple

import viser
from viser import uplot

from surefoot.tune.live.metric_curves import Curves, TickMetrics

_HEIGHT = 122  # [pixels] height of a plot
_BLUE, _ORANGE = "#2563eb", "#ea580c"


class _Plot(NamedTuple):
    title: str
    curves: dict[str, str]  # field of TickMetrics: label in the legend


_PLOTS = (
    _Plot("Pose error", {"position_error": "mm", "angle_error": "deg"}),
    _Plot("Greatest torque / its limit", {"torque_ratio": "1"}),
    _Plot("Power of the command", {"power": "W"}),
    _Plot("Tick: LowState to LowCmd", {"tick_us": "us"}),
)


class Plots:
    """Plots of Curves.

    Args:
        gui: GUI to add the plots to.
        curves: Data of the plots.
    """

    def __init__(self, gui: viser.GuiApi, curves: Curves) -> None:
        self._curves = curves
        arrays = dict(zip(("time", *TickMetrics._fields), curves.arrays(), strict=True))
        self._handles = [
            gui.add_uplot(
                (arrays["time"], *(arrays[name] for name in plot.curves)),
                _series(plot),
                title=plot.title,
                scales={"x": uplot.Scale(time=False)},  # seconds, not dates
                axes=_axes(plot),
                legend=uplot.Legend(show=len(plot.curves) > 1),
                cursor=uplot.Cursor(show=False),
                height=_HEIGHT + (40 if len(plot.curves) > 1 else 0),
                padding=(4, 12, 0, 0),
            )
            for plot in _PLOTS
        ]

    def refresh(self) -> None:
        """Update the plots with the present data."""
        arrays = dict(zip(("time", *TickMetrics._fields), self._curves.arrays(), strict=True))
        for plot, handle in zip(_PLOTS, self._handles, strict=True):
            handle.data = (arrays["time"], *(arrays[name] for name in plot.curves))


def _series(plot: _Plot) -> tuple[uplot.Series, ...]:
    colours = (_BLUE, _ORANGE)
    lines = (
        uplot.Series(label=label, stroke=colour, width=1.5)
        for label, colour in zip(plot.curves.values(), colours, strict=False)
    )
    return (uplot.Series(label="s"), *lines)


def _axes(plot: _Plot) -> tuple[uplot.Axis, ...]:
    unit = ", ".join(plot.curves.values())
    return uplot.Axis(size=26), uplot.Axis(label=unit, labelSize=18, size=46)
