"""Selection of the rows to plot from a long log."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot.estimate.estimate_result import Estimate

# Chosen for the size and time of a plot.
MAX_PLOT_ROWS = 20_000  # largest number of rows in a plot: ten per pixel


def rows_to_plot(estimate: Estimate) -> npt.NDArray[np.int64]:
    """Return the indices of the rows to plot: all rows, or MAX_PLOT_ROWS evenly spaced rows."""
    count = len(estimate.time)
    return np.unique(np.linspace(0, count - 1, min(count, MAX_PLOT_ROWS)).astype(np.int64))
