"""Plots of a design: stability maps, responses to a push, poles."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from surefoot.reports.plots import BLUE, GREY, ORANGE, RED, Plot
from surefoot.tune.design.closed_loop import ClosedLoop
from surefoot.tune.design.gain_design import AxisDesign, Design
from surefoot.tune.design.margins import MAX_GAIN_FACTOR
from surefoot.tune.design.panels import add_legend, four_panels
from surefoot.tune.design.stability_maps import draw_damping_map, draw_delay_map
from surefoot.tune.design.timing import Observers

# [s] Time after a push that the plot shows. Chosen: a loop of 1 Hz settles within this time.
_RESPONSE_TIME = 1.2


def draw_poles(design: Design) -> Figure:
    """Draw the poles at rest in the z plane, for the least stable direction of each axis."""
    figure, axes = four_panels(7.4)
    circle = np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 200))
    for axis, ax in zip(design.axes, axes, strict=True):
        loop = _loop(design, axis)
        ax.plot(circle.real, circle.imag, color=GREY, lw=0.8)
        shown = [(1.0, BLUE, "these gains")]
        if axis.margins.gain_up < MAX_GAIN_FACTOR:
            shown.append((axis.margins.gain_up, RED, "gain margin"))
        for factor, color, text in shown:
            kp, kd = factor * axis.goal.kp, factor * axis.goal.kd
            z = np.linalg.eigvals(loop.state_matrix(kp, kd))
            ax.plot(z.real, z.imag, "x", color=color, ms=5, label=text)
        ax.set_aspect("equal")
        ax.set_title(f"{axis.name}, direction {axis.direction}")
    add_legend(figure, axes)
    return figure


def draw_responses(design: Design) -> Figure:
    """Draw the acceleration of each axis after a push, at its gains and around the boundary."""
    figure, axes = four_panels(5.6)
    for axis, ax in zip(design.axes, axes, strict=True):
        loop = _loop(design, axis)
        shown = [(1.0, BLUE, "these gains")]
        # Skip both sides if the search found no boundary.
        if axis.margins.boundary < MAX_GAIN_FACTOR:
            shown.insert(0, (0.8 * axis.margins.boundary, ORANGE, "20 % inside"))
            shown.insert(0, (1.2 * axis.margins.boundary, RED, "20 % outside"))
        for factor, color, text in shown:
            a = loop.simulate(factor * axis.goal.kp, factor * axis.goal.kd, _RESPONSE_TIME)
            ax.plot(np.arange(len(a)) * loop.timing.period, a, color=color, label=text)
        unit = "rad/s" if loop.direction.rotates else "m/s"
        ax.set_title(f"{axis.name}, direction {axis.direction}")
        ax.set_xlabel("time [s]")
        ax.set_ylabel(f"acceleration [{unit}\u00b2]")
    add_legend(figure, axes)
    return figure


PLOTS: tuple[Plot[Design], ...] = (
    Plot(
        "delay_map.png",
        "Stability over frequency and delay",
        "Green: settles after a push. Yellow: stable at rest, but oscillates after a push. Red: "
        "oscillates by itself. For the direction with the smallest margin.",
        draw_delay_map,
    ),
    Plot(
        "damping_map.png",
        "Stability over frequency and damping",
        "As above, over the damping ratio, with the requested delay.",
        draw_damping_map,
    ),
    Plot(
        "responses.png",
        "Response to a push",
        "Acceleration of the body in the model, after a push of half the LIP push limit.",
        draw_responses,
    ),
    Plot(
        "poles.png",
        "Poles at rest",
        "In the z plane; at the gain margin a pair of poles reaches the unit circle.",
        draw_poles,
    ),
)


def _loop(design: Design, axis: AxisDesign) -> ClosedLoop:
    direction = design.body.directions[axis.direction]
    return ClosedLoop(direction, design.settings.timing, Observers.of(design.gains))
