"""Plots of an estimate over time."""

from __future__ import annotations

from itertools import chain

import numpy as np
from matplotlib.figure import Figure

from surefoot.estimate.estimate_result import Estimate
from surefoot.estimate.plot_bands import band, three_bands
from surefoot.estimate.plot_contact import draw_contact, draw_verdicts
from surefoot.estimate.plot_rows import rows_to_plot
from surefoot.estimate.plot_stance import draw_stance
from surefoot.estimate.truth_summary import heading_offset, rotate_by_yaw, true_rows, true_rpy
from surefoot.geometry.batch_rotations import Array
from surefoot.reports.plots import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    Plot,
    finish_time_axis,
    subplot_grid,
    widen_y_axis,
)

AXES = ("x", "y", "z")


def draw_path(estimate: Estimate) -> Figure:
    """Draw path and height, also of baselines, and the 2-sigma ellipse at the end of the path."""
    rows = rows_to_plot(estimate)
    p, std = estimate.q[rows, :3], estimate.std[rows, 6:9]
    figure = Figure(figsize=(9.2, 4.2), layout="constrained")
    ground, height = figure.subplots(1, 2)
    truth = _true_path(estimate)
    if truth is not None:
        ground.plot(truth[rows, 0], truth[rows, 1], color=BLUE, label="true")
        height.plot(estimate.time[rows], truth[rows, 2], color=BLUE)
    for (name, motion), color in zip(estimate.baselines.items(), (GREEN, GREY), strict=False):
        path = motion.position[rows]
        ground.plot(path[:, 0], path[:, 1], color=color, lw=0.9, label=name.replace("_", " "))
        height.plot(estimate.time[rows], path[:, 2], color=color, lw=0.9)
    ground.plot(p[:, 0], p[:, 1], color=ORANGE, lw=0.9, label="estimated")
    if np.isfinite(std[-1]).all():
        angle = np.linspace(0.0, 2.0 * np.pi, 60)
        x, y = (p[-1, k] + 2.0 * std[-1, k] * f(angle) for k, f in enumerate((np.cos, np.sin)))
        ground.plot(x, y, color=ORANGE, lw=0.7, ls="--", label="2 sigma at the end")
    ground.set(xlabel="x [m]", ylabel="y [m]", title="over ground")
    ground.set_aspect("equal", adjustable="datalim")
    band(height, estimate.time[rows], p[:, 2], std[:, 2])
    height.set(xlabel="time [s]", ylabel="z [m]", title="height")
    handles, labels = ground.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=len(labels))
    return figure


def draw_attitude(estimate: Estimate) -> Figure:
    """Draw roll, pitch and yaw."""
    truth = true_rpy(estimate)
    if truth is not None:
        truth = truth - [0.0, 0.0, heading_offset(estimate)]
        truth = np.degrees((truth + np.pi) % (2.0 * np.pi) - np.pi)
    values, std = np.degrees(estimate.rpy), np.degrees(estimate.rpy_std)
    return three_bands(
        estimate, values, std, ("roll [deg]", "pitch [deg]", "yaw [deg]"), truth, 0.2
    )


def draw_velocity(estimate: Estimate) -> Figure:
    """Draw the velocity of the base in world axes."""
    truth = true_rows(estimate, "truth_v")
    truth = None if truth is None else rotate_by_yaw(truth, -heading_offset(estimate))
    labels = tuple(f"{axis} [m/s]" for axis in AXES)
    return three_bands(estimate, estimate.v_world, estimate.std[:, 3:6], labels, truth, 0.02)


def draw_biases(estimate: Estimate) -> Figure:
    """Draw the biases of the gyroscope and the accelerometer."""
    rows = rows_to_plot(estimate)
    figure, axes = subplot_grid(2, 1, 4.2)
    sensors = (
        ("gyroscope [rad/s]", estimate.gyroscope_bias, estimate.std[:, 9:12]),
        ("accelerometer [m/s²]", estimate.accelerometer_bias, estimate.std[:, 12:15]),
    )
    for ax, (label, values, std) in zip(chain.from_iterable(axes), sensors, strict=True):
        for k, color in enumerate((BLUE, ORANGE, GREEN)):
            band(ax, estimate.time[rows], values[rows, k], std[rows, k], color, AXES[k])
        widen_y_axis(ax, 0.01)
        ax.set_ylabel(label)
    finish_time_axis(figure, axes, float(estimate.time[-1]))
    return figure


def draw_nis(estimate: Estimate) -> Figure:
    """Draw the normalised innovation squared over its dimension, and the rejected rows."""
    figure, axes = subplot_grid(1, 1, 2.6)
    ax = axes[0][0]
    with np.errstate(invalid="ignore", divide="ignore"):
        share = np.where(estimate.nis_dimension > 0, estimate.nis / estimate.nis_dimension, np.nan)
    rows = rows_to_plot(estimate)
    ax.plot(estimate.time[rows], share[rows], ".", ms=1.5, color=BLUE, label="one row")
    ax.axhline(1.0, color=GREY, label="as modelled")
    refused = np.nansum(estimate.refused, axis=1) > 0
    ax.plot(estimate.time[refused], 0.0 * estimate.time[refused], "|", color=RED, label="rejected")
    ax.set_ylim(0.0, max(2.0, 1.1 * float(np.nanmax(share[rows], initial=1.0))))
    ax.set_ylabel("NIS / dimension")
    finish_time_axis(figure, axes, float(estimate.time[-1]))
    return figure


def _true_path(estimate: Estimate) -> Array | None:
    """Return the true positions (m, 3), aligned with the estimate's pose at the start."""
    truth = true_rows(estimate, "truth_p")
    if truth is None or not np.isfinite(truth).any():
        return None
    first = int(np.flatnonzero(np.isfinite(truth).all(axis=1))[0])
    moved = rotate_by_yaw(truth - truth[first], -heading_offset(estimate))
    return np.asarray(moved + estimate.q[first, :3])


PLOTS: tuple[Plot[Estimate], ...] = (
    Plot(
        "path.png",
        "Path of the base",
        "In the world frame of the estimator, which starts under the base with its heading. The "
        "truth and the baselines are aligned at the start. Bands and ellipse are two standard "
        "deviations.",
        draw_path,
    ),
    Plot(
        "attitude.png",
        "Attitude",
        "Roll, pitch and yaw with two standard deviations.",
        draw_attitude,
    ),
    Plot(
        "velocity.png",
        "Velocity",
        "Velocity of the base, world axes, with two standard deviations.",
        draw_velocity,
    ),
    Plot(
        "biases.png",
        "Biases",
        "Biases of the IMU, base axes, with two standard deviations.",
        draw_biases,
    ),
    Plot(
        "contact.png",
        "Contact",
        "Contact confidence of each foot and the measured vertical forces; the shaded area is the "
        "true force.",
        draw_contact,
    ),
    Plot(
        "stance.png",
        "Stances",
        "Each bar is a stance of a foot, with contact confidence above 0.5: over the whole log, "
        "and over the 4 s with the most steps. Narrow bars: true contact.",
        draw_stance,
    ),
    Plot("verdicts.png", "Verdicts", "Verdict on each sensor over time.", draw_verdicts),
    Plot(
        "nis.png",
        "Consistency",
        "Normalised innovation squared over its dimension: about 1 where the noise is as large as "
        "modelled. Red: the innovation gate rejected a foot.",
        draw_nis,
    ),
)
