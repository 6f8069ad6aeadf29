"""Whether a probability of contact is one."""

from __future__ import annotations

import numpy as np

from estimation.log_rows import Array


def calibration_error(confidence_and_truth: Array, bins: int = 10) -> float:
    """Return the mean distance between probability and frequency over bins; NaN without rows."""
    if len(confidence_and_truth) == 0:
        return float("nan")
    index = np.minimum((confidence_and_truth[:, 0] * bins).astype(int), bins - 1)
    gaps = [
        abs(np.sum(confidence_and_truth[index == k, 0] - confidence_and_truth[index == k, 1]))
        for k in range(bins)
    ]
    return float(np.sum(gaps) / len(confidence_and_truth))
