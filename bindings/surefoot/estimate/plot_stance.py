"""Plot of the stances of each foot over time."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from surefoot.estimate.contact_events import THRESHOLD, stance_rows
from surefoot.estimate.estimate_result import Estimate
from surefoot.estimate.truth_summary import true_contact
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.reports.plots import BLUE, ORANGE

DETAIL_TIME = 4.0  # [s] time in the lower diagram. Chosen: about ten strides of a trot.


def draw_stance(estimate: Estimate) -> Figure:
    """Draw a bar for each stance of each foot: over the whole log, and over 4 s of it."""
    figure = Figure(figsize=(9.2, 4.4), layout="constrained")
    whole, detail = figure.subplots(2, 1)
    truth = true_contact(estimate)
    for ax in (whole, detail):
        _draw_bars(ax, estimate, estimate.contact, 0.0, 0.6, ORANGE)
        if truth is not None:
            _draw_bars(ax, estimate, truth, 0.35, 0.15, BLUE)
        ax.set_yticks(range(4), LEGS)
        ax.set_ylim(3.6, -0.5)
        ax.grid(False)
    whole.set_xlim(0.0, max(float(estimate.time[-1]), 1e-3))
    start = _busiest_time(estimate)
    detail.set(xlim=(start, start + DETAIL_TIME), xlabel="time [s]")
    handles = [whole.barh([9], [0], color=ORANGE), whole.barh([9], [0], color=BLUE)]
    labels = ["estimated", "true"][: 1 if truth is None else 2]
    figure.legend(handles[: len(labels)], labels, loc="outside upper right", ncols=len(labels))
    return figure


def _draw_bars(
    ax: Axes, estimate: Estimate, contact: Array, offset: float, height: float, color: str
) -> None:
    ends = np.append(estimate.time, estimate.time[-1] + estimate.log.period)
    for leg in range(4):
        on = np.nan_to_num(contact[:, leg]) > THRESHOLD
        bars = [(ends[a], ends[b] - ends[a]) for a, b in stance_rows(on)]
        ax.broken_barh(bars, (leg + offset - 0.3, height), color=color, lw=0)


def _busiest_time(estimate: Estimate) -> float:
    """Return the start [s] of the DETAIL_TIME with the most changes of the contact."""
    on = np.nan_to_num(estimate.contact) > THRESHOLD
    times = estimate.time[1:][np.any(on[1:] != on[:-1], axis=1)]
    if len(times) == 0:
        return 0.0
    counts = np.searchsorted(times, times + DETAIL_TIME) - np.arange(len(times))
    return float(times[np.argmax(counts)])
