"""Plots of a fault matrix: reaction times, and the largest torques and torque steps of commands."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure

from surefoot.faults.matrix.command_monitor import MAX_TORQUE_STEP
from surefoot.reports.plots import BLUE, RED, Plot

_COLOURS = {"pass": BLUE, "fail": RED}


def _draw_times(result: dict[str, Any]) -> Figure:
    figure = Figure(figsize=(9.2, 4.6), layout="constrained")
    ax = figure.subplots()
    for verdict, colour in _COLOURS.items():
        cells = [
            cell
            for cell in result["cells"]
            if cell["verdict"] == verdict and cell.get("reaction_s") is not None
        ]
        allowed = [max(1e3 * cell["within_s"], 1.0) for cell in cells]
        ax.scatter(
            allowed,
            [max(1e3 * cell["reaction_s"], 1.0) for cell in cells],
            14,
            colour,
            label=verdict,
        )
    ax.axline((1.0, 1.0), (1e4, 1e4), color="#8a929b", linewidth=0.8)
    ax.set(xscale="log", yscale="log", xlim=(1, 2e4), ylim=(0.8, 2e4))
    ax.set(xlabel="time limit [ms]", ylabel="reaction time [ms]")
    ax.legend()
    return figure


def _draw_limits(result: dict[str, Any]) -> Figure:
    figure = Figure(figsize=(9.2, 3.0), layout="constrained")
    torque, step = figure.subplots(1, 2)
    shares = [cell["torque_share"] for cell in result["cells"] if "torque_share" in cell]
    steps = [cell["torque_step_share"] for cell in result["cells"] if "torque_share" in cell]
    torque.hist(shares, 40, color=BLUE)
    torque.axvline(1.0, color=RED)
    torque.set(xlabel="largest torque / limit", ylabel="cells")
    step.hist(steps, 40, color=BLUE)
    step.axvline(MAX_TORQUE_STEP, color=RED)
    step.set(xlabel="largest torque step in 2 ms / torque limit")
    return figure


PLOTS: tuple[Plot[dict[str, Any]], ...] = (
    Plot(
        "times.png",
        "Reaction times",
        "One point for each cell with a reaction; points above the line are too late.",
        _draw_times,
    ),
    Plot(
        "limits.png",
        "Commands against their limits",
        "One count for each cell; values right of a red line are violations.",
        _draw_limits,
    ),
)
