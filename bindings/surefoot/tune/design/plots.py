"""Maps of where a design is stable: an axis over frequency and delay, over damping, over gain."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from surefoot.report_axes import BLUE, GREEN, GREY, ORANGE, RED, Plot, grid
from surefoot.tune.design.design import AxisDesign, Design
from surefoot.tune.design.goals import Goal
from surefoot.tune.design.loop import ClosedLoop
from surefoot.tune.design.margins import greatest_frequency, spectral_radius
from surefoot.tune.design.timing import Observers

_DELAYS = np.linspace(0.0, 0.03, 11)  # [s] further than the robot's own
_DAMPINGS = np.linspace(0.2, 1.6, 11)
_MOST_FREQUENCY = 16.0  # [Hz] shown
_TIME = 1.2  # [s] of a step response


def draw_delay_map(design: Design) -> Figure:
    """Draw for each axis the greatest stable frequency over the delay, and what was asked for."""
    figure, axes = grid(2, 2, 5.6)
    for axis, ax in zip(design.axes, [a for row in axes for a in row], strict=True):
        damping = axis.goal.damping
        columns = [_greatest(design, axis, delay, damping) for delay in _DELAYS]
        _fill(ax, 1000.0 * _DELAYS, columns)
        delay = 1000.0 * design.settings.timing.delay
        ax.plot(delay, axis.goal.frequency, "o", color=BLUE, label="asked for")
        ax.set_title(f"{axis.name}, damping {damping:g}")
        ax.set_xlabel("further delay [ms]")
        ax.set_ylabel("frequency [Hz]")
    _finish(figure, axes)
    return figure


def draw_damping_map(design: Design) -> Figure:
    """Draw for each axis the greatest stable frequency over the damping, at the design's delay."""
    figure, axes = grid(2, 2, 5.6)
    delay = design.settings.timing.delay
    for axis, ax in zip(design.axes, [a for row in axes for a in row], strict=True):
        columns = [_greatest(design, axis, delay, float(zeta)) for zeta in _DAMPINGS]
        _fill(ax, _DAMPINGS, columns)
        ax.plot(axis.goal.damping, axis.goal.frequency, "o", color=BLUE, label="asked for")
        ax.set_title(f"{axis.name}, {1000.0 * delay:g} ms of further delay")
        ax.set_xlabel("damping")
        ax.set_ylabel("frequency [Hz]")
    _finish(figure, axes)
    return figure


def draw_poles(design: Design) -> Figure:
    """Draw the poles of each axis's binding direction at rest in the plane of z."""
    figure, axes = grid(2, 2, 7.4)
    circle = np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 200))
    for axis, ax in zip(design.axes, [a for row in axes for a in row], strict=True):
        loop = _loop(design, axis)
        ax.plot(circle.real, circle.imag, color=GREY, lw=0.8)
        for factor, color, text in (
            (1.0, BLUE, "these gains"),
            (axis.margins.gain_up, RED, "gain margin"),
        ):
            kp, kd = factor * axis.goal.kp, factor * axis.goal.kd
            z = np.linalg.eigvals(loop.matrix(kp, kd))
            ax.plot(z.real, z.imag, "x", color=color, ms=5, label=text)
        ax.set_aspect("equal")
        ax.set_title(f"{axis.name}, direction {axis.direction}")
    _finish(figure, axes, limit=False)
    return figure


def draw_responses(design: Design) -> Figure:
    """Draw each axis's acceleration after a push, at its gains and either side of the boundary."""
    figure, axes = grid(2, 2, 5.6)
    for axis, ax in zip(design.axes, [a for row in axes for a in row], strict=True):
        loop = _loop(design, axis)
        for factor, color, text in (
            (1.2 * axis.margins.boundary, RED, "20 % outside"),
            (0.8 * axis.margins.boundary, ORANGE, "20 % inside"),
            (1.0, BLUE, "these gains"),
        ):
            a = loop.run(factor * axis.goal.kp, factor * axis.goal.kd, _TIME)
            ax.plot(np.arange(len(a)) * loop.timing.period, a, color=color, label=text)
        unit = "rad/s" if loop.direction.rotates else "m/s"
        ax.set_title(f"{axis.name}, direction {axis.direction}")
        ax.set_xlabel("time [s]")
        ax.set_ylabel(f"acceleration [{unit}\u00b2]")
    _finish(figure, axes, limit=False)
    return figure


PLOTS: tuple[Plot[Design], ...] = (
    Plot(
        "delay_map.png",
        "Where it is stable: frequency and delay",
        "Green settles after a push, yellow stands still but keeps oscillating once pushed, red "
        "oscillates by itself. In the direction that bears least.",
        draw_delay_map,
    ),
    Plot(
        "damping_map.png",
        "Where it is stable: frequency and damping",
        "The same over the damping ratio, with the delay that was asked for.",
        draw_damping_map,
    ),
    Plot(
        "responses.png",
        "After a push",
        "Acceleration of the body in the model, after half the speed that a linear inverted "
        "pendulum survives.",
        draw_responses,
    ),
    Plot(
        "poles.png",
        "Poles at rest",
        "In the plane of z; at the gain margin a pair reaches the circle.",
        draw_poles,
    ),
)


def _loop(design: Design, axis: AxisDesign) -> ClosedLoop:
    direction = design.body.directions[axis.direction]
    return ClosedLoop(direction, design.settings.timing, Observers.of(design.gains))


def _greatest(
    design: Design, axis: AxisDesign, delay: float, damping: float
) -> tuple[float, float]:
    """Return the greatest frequencies that are stable after a push, and at rest [Hz]."""
    direction = design.body.directions[axis.direction]
    timing = replace(design.settings.timing, delay=float(delay))
    observers = Observers.of(design.gains)
    pushed = greatest_frequency(direction, timing, observers, damping)
    return pushed, _greatest_at_rest(ClosedLoop(direction, timing, observers), damping)


def _greatest_at_rest(loop: ClosedLoop, damping: float) -> float:
    low, high = 0.05, 40.0
    while high > 1.01 * low:
        middle = float(np.sqrt(low * high))
        goal = Goal(middle, damping)
        stable = spectral_radius(loop, goal.kp, goal.kd) < 1.0
        low, high = (middle, high) if stable else (low, middle)
    return low


def _fill(ax: Axes, x: np.ndarray, columns: list[tuple[float, float]]) -> None:
    pushed, rest = (np.array(side) for side in zip(*columns, strict=True))
    rest = np.maximum(rest, pushed)
    ax.fill_between(x, 0.0, pushed, color=GREEN, alpha=0.25, lw=0, label="settles")
    ax.fill_between(x, pushed, rest, color=ORANGE, alpha=0.25, lw=0, label="rests until pushed")
    ax.fill_between(x, rest, _MOST_FREQUENCY, color=RED, alpha=0.15, lw=0, label="oscillates")
    ax.plot(x, pushed, color=GREEN)
    ax.plot(x, rest, color=RED)
    ax.set_xlim(float(x[0]), float(x[-1]))


def _finish(figure: Figure, axes: list[list[Axes]], limit: bool = True) -> None:
    for row in axes:
        for ax in row:
            if limit:
                ax.set_ylim(0.0, _MOST_FREQUENCY)
    handles, labels = axes[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=len(labels))
