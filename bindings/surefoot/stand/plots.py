"""Plots of a run: base pose, torques, contacts, power, and tick time."""

from __future__ import annotations

from itertools import chain

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

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
from surefoot.stand.foot_frame import foot_positions, pose_from_feet
from surefoot.stand.requested_pose import requested_pose
from surefoot.stand.simulation_log import SimulationLog
from surefoot.stand.stand_log import StandLog

LEG_TITLES = ("front right", "front left", "rear right", "rear left")
JOINTS = ("hip", "thigh", "calf")


def shade_pushes(ax: Axes, log: SimulationLog) -> None:
    """Shade the time during which each push acts."""
    for push in log.pushes:
        ax.axvspan(push.time, push.time + push.duration, color=RED, alpha=0.25, lw=0)


def finish_figure(figure: Figure, axes: list[list[Axes]], log: SimulationLog) -> None:
    """Label the time axis and draw one legend above all plots."""
    finish_time_axis(figure, axes, log.duration)


def draw_pose(log: StandLog) -> Figure:
    """Plot the true and the estimated base pose relative to the feet, minus their first values."""
    true = pose_from_feet(log.q_true, log.feet).rows_mm_deg
    estimated = pose_from_feet(
        log.q_estimated, foot_positions(log.robot, log.q_estimated)
    ).rows_mm_deg
    requested = requested_pose(log).rows_mm_deg - true[0]
    true, estimated = true - true[0], estimated - estimated[0]
    labels = ("x [mm]", "y [mm]", "z [mm]", "roll [deg]", "pitch [deg]", "yaw [deg]")
    figure, axes = subplot_grid(3, 2, 5.2)
    for k, label in enumerate(labels):
        ax = axes[k % 3][k // 3]
        shade_pushes(ax, log)
        if log.settings.references:
            ax.plot(log.time, requested[:, k], color=GREY, ls=":", label="requested")
        ax.plot(log.time, true[:, k], color=BLUE, label="true")
        ax.plot(log.time, estimated[:, k], color=ORANGE, lw=0.9, ls="--", label="estimated")
        widen_y_axis(ax, 1.0 if k < 3 else 0.2)
        ax.set_ylabel(label)
    finish_figure(figure, axes, log)
    return figure


def draw_torques(log: SimulationLog) -> Figure:
    """Plot the true torques of each leg, with the torque limits of its motors."""
    figure, axes = subplot_grid(2, 2, 4.6)
    for leg, ax in enumerate(chain.from_iterable(axes)):
        shade_pushes(ax, log)
        for joint, color in enumerate((BLUE, ORANGE, GREEN)):
            motor = 3 * leg + joint
            limit = log.robot.config.tau_max[motor]
            ax.plot(log.time, log.tau[:, motor], color=color, label=JOINTS[joint])
            for bound in (-limit, limit):
                ax.axhline(bound, color=color, ls=(0, (4, 3)), lw=0.8, alpha=0.7)
        ax.set_title(LEG_TITLES[leg])
        ax.set_ylabel("torque [N.m]")
    finish_figure(figure, axes, log)
    return figure


def draw_contacts(log: SimulationLog) -> Figure:
    """Plot the true vertical force and the estimated contact confidence of each foot."""
    figure, axes = subplot_grid(2, 2, 4.6)
    max_force = 1.15 * max(1.0, float(log.forces[:, 2].max()))
    for leg, ax in enumerate(chain.from_iterable(axes)):
        shade_pushes(ax, log)
        ax.fill_between(log.time, log.forces[:, 2, leg], color=GREEN, alpha=0.25, lw=0)
        ax.plot(log.time, log.forces[:, 2, leg], color=GREEN, label="true vertical force [N]")
        ax.plot([], [], color=ORANGE, label="contact confidence (right axis)")
        ax.set_ylim(0.0, max_force)
        ax.set_title(LEG_TITLES[leg])
        ax.set_ylabel("force [N]")
        confidence_axes = ax.twinx()
        confidence_axes.plot(log.time, log.contact[:, leg], color=ORANGE, lw=0.9)
        confidence_axes.set_ylim(0.0, 1.15)
        confidence_axes.set_yticks([0.0, 0.5, 1.0])
        confidence_axes.grid(False)
        confidence_axes.spines["right"].set_visible(True)
    finish_figure(figure, axes, log)
    return figure


def draw_power(log: SimulationLog) -> Figure:
    """Plot the power: the sum over the motors of the absolute product of torque and velocity."""
    figure, axes = subplot_grid(1, 1, 2.4)
    ax = axes[0][0]
    shade_pushes(ax, log)
    ax.fill_between(log.time, log.power, color=BLUE, alpha=0.2, lw=0)
    ax.plot(log.time, log.power, color=BLUE, label="sum of |torque x velocity|")
    ax.set_ylim(0.0, 1.1 * max(1.0, float(log.power.max())))
    ax.set_ylabel("power [W]")
    finish_figure(figure, axes, log)
    return figure


def draw_ticks(log: SimulationLog) -> Figure:
    """Plot a histogram of tick times in logarithmic bins, with percentiles."""
    figure, axes = subplot_grid(1, 1, 2.6)
    ax = axes[0][0]
    low, high = float(log.tick_us.min()), float(log.tick_us.max())
    ax.hist(log.tick_us, bins=np.geomspace(0.9 * low, 1.1 * high, 90).tolist(), color=GREY)
    for percentile, color in ((50, BLUE), (90, GREEN), (99, ORANGE), (100, RED)):
        value = float(np.percentile(log.tick_us, percentile))
        name = "max" if percentile == 100 else f"p{percentile}"
        ax.axvline(value, color=color, label=f"{name} {value:.0f} us")
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel(f"tick [us]; the control period is {1e6 / log.rate:.0f} us")
    ax.set_ylabel("ticks")
    figure.legend(loc="outside upper right", ncols=4)
    return figure


PLOTS: tuple[Plot[StandLog], ...] = (
    Plot(
        "pose.png",
        "Base pose relative to the feet",
        "Change from the start, in a frame at the mean of the feet and along their heading. The "
        "estimate is relative to the estimated feet. Pushes are shaded red.",
        draw_pose,
    ),
    Plot(
        "torques.png",
        "Joint torques and their limits",
        "True torque of every motor; dashed: torque limit at low speed.",
        draw_torques,
    ),
    Plot(
        "contacts.png",
        "Contact",
        "Load of each foot, and the estimator's contact confidence.",
        draw_contacts,
    ),
    Plot(
        "power.png", "Power", "Sum over all motors; braking counts as positive power.", draw_power
    ),
    Plot(
        "ticks.png",
        "Tick time",
        "Wall time of the controller's update() as called from Python on this machine. Other "
        "processes on the same CPU cause the longest times.",
        draw_ticks,
    ),
)
