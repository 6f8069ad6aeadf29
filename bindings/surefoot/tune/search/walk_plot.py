"""Plot of one walk with several sets of gains."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from surefoot.reports.plots import finish_time_axis, subplot_grid
from surefoot.walk import WalkLog
from surefoot.walk.heading_frame import attitude_on_ground, heading_velocity

_LABELS = ("vx [m/s]", "vy [m/s]", "yaw rate [rad/s]", "roll, pitch [deg]")


def draw_walk(logs: dict[str, WalkLog], colours: dict[str, str]) -> Figure:
    """Draw velocity and command, and the larger of roll and pitch, for each log by name."""
    figure, axes = subplot_grid(len(_LABELS), 1, 7.0)
    longest = max(logs.values(), key=len)
    for axis in range(3):
        axes[axis][0].plot(longest.time, longest.commanded[:, axis], color="black", lw=1)
    for name, log in logs.items():
        tilt = np.degrees(np.abs(attitude_on_ground(log)[:, :2]).max(axis=1))
        for (ax,), row in zip(axes, (*heading_velocity(log).T, tilt), strict=True):
            ax.plot(log.time, row, color=colours[name], lw=1, label=name)
    for (ax,), text in zip(axes, _LABELS, strict=True):
        ax.set_ylabel(text)
    finish_time_axis(figure, axes, float(longest.time[-1]))
    return figure
