"""Stability maps of a design: greatest stable frequency over delay, and over damping."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from surefoot.reports.plots import BLUE, GREEN, ORANGE, RED
from surefoot.tune.design.closed_loop import ClosedLoop
from surefoot.tune.design.gain_design import AxisDesign, Design
from surefoot.tune.design.goals import Goal
from surefoot.tune.design.margins import max_stable_frequency, spectral_radius
from surefoot.tune.design.panels import add_legend, four_panels
from surefoot.tune.design.timing import MAX_DELAY_PERIODS, Observers

# Limits of the maps. Chosen: larger than the delays and goals that a robot can have.
_MAX_SHOWN_DELAY = 0.03  # [s] greatest additional delay on the map; smaller at very high rates
_DAMPINGS = np.linspace(0.2, 1.6, 11)
_MAX_SHOWN_FREQUENCY = 16.0  # [Hz] upper end of the map


def draw_delay_map(design: Design) -> Figure:
    """Draw the greatest stable frequency of each axis over the delay, and the design's goal."""
    figure, axes = four_panels(5.6)
    timing = design.settings.timing
    delays = np.linspace(0.0, min(_MAX_SHOWN_DELAY, MAX_DELAY_PERIODS * timing.period), 11)
    for axis, ax in zip(design.axes, axes, strict=True):
        damping = axis.goal.damping
        columns = [_max_frequencies(design, axis, delay, damping) for delay in delays]
        _fill_regions(ax, 1000.0 * delays, columns)
        delay = 1000.0 * timing.delay
        ax.plot(delay, axis.goal.frequency, "o", color=BLUE, label="goal")
        ax.set_title(f"{axis.name}, damping {damping:g}")
        ax.set_xlabel("additional delay [ms]")
        ax.set_ylabel("frequency [Hz]")
    add_legend(figure, axes)
    return figure


def draw_damping_map(design: Design) -> Figure:
    """Draw the greatest stable frequency of each axis over the damping, at the design's delay."""
    figure, axes = four_panels(5.6)
    delay = design.settings.timing.delay
    for axis, ax in zip(design.axes, axes, strict=True):
        columns = [_max_frequencies(design, axis, delay, float(zeta)) for zeta in _DAMPINGS]
        _fill_regions(ax, _DAMPINGS, columns)
        ax.plot(axis.goal.damping, axis.goal.frequency, "o", color=BLUE, label="goal")
        ax.set_title(f"{axis.name}, {1000.0 * delay:g} ms of additional delay")
        ax.set_xlabel("damping")
        ax.set_ylabel("frequency [Hz]")
    add_legend(figure, axes)
    return figure


def _max_frequencies(
    design: Design, axis: AxisDesign, delay: float, damping: float
) -> tuple[float, float]:
    """Return the greatest frequency [Hz] that is stable after a push, and the greatest at rest."""
    direction = design.body.directions[axis.direction]
    timing = replace(design.settings.timing, delay=float(delay))
    observers = Observers.of(design.gains)
    pushed = max_stable_frequency(direction, timing, observers, damping)
    return pushed, _max_frequency_at_rest(ClosedLoop(direction, timing, observers), damping)


def _max_frequency_at_rest(loop: ClosedLoop, damping: float) -> float:
    low, high = 0.05, 40.0
    while high > 1.01 * low:
        middle = float(np.sqrt(low * high))
        goal = Goal(middle, damping)
        stable = spectral_radius(loop, goal.kp, goal.kd) < 1.0
        low, high = (middle, high) if stable else (low, middle)
    return low


def _fill_regions(ax: Axes, x: np.ndarray, columns: list[tuple[float, float]]) -> None:
    pushed, rest = (np.array(side) for side in zip(*columns, strict=True))
    rest = np.maximum(rest, pushed)
    ax.fill_between(x, 0.0, pushed, color=GREEN, alpha=0.25, lw=0, label="settles")
    ax.fill_between(
        x, pushed, rest, color=ORANGE, alpha=0.25, lw=0, label="oscillates after a push"
    )
    ax.fill_between(x, rest, _MAX_SHOWN_FREQUENCY, color=RED, alpha=0.15, lw=0, label="oscillates")
    ax.plot(x, pushed, color=GREEN)
    ax.plot(x, rest, color=RED)
    ax.set_ylim(0.0, _MAX_SHOWN_FREQUENCY)
    ax.set_xlim(float(x[0]), float(x[-1]))
