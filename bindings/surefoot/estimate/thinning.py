"""Which rows are drawn of a long log."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot.estimate.result import Estimate

MOST = 20_000  # rows in a plot: ten to a pixel


def shown_rows(estimate: Estimate) -> npt.NDArray[np.int64]:
    """Return the indices of the rows to draw: all, or evenly spread ones."""
    count = len(estimate.time)
    return np.unique(np.linspace(0, count - 1, min(count, MOST)).astype(np.int64))
