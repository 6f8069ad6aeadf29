"""Calibration of the contact confidence: how far it is from a probability."""

from __future__ import annotations

import numpy as np

from estimation.log_rows import Array


def calibration_error(confidence_and_truth: Array, bins: int = 10) -> float:
    """Compute the calibration error of a contact confidence.

    The error is the mean absolute difference over equal bins of the confidence between the
    confidence and the frequency of contact, weighted by the rows per bin. NaN without rows.

    Args:
        confidence_and_truth: (n, 2) contact confidence, and true contact (0 or 1).
        bins: Number of bins.
    """
    if len(confidence_and_truth) == 0:
        return float("nan")
    index = np.minimum((confidence_and_truth[:, 0] * bins).astype(int), bins - 1)
    gaps = [
        abs(np.sum(confidence_and_truth[index == k, 0] - confidence_and_truth[index == k, 1]))
        for k in range(bins)
    ]
    return float(np.sum(gaps) / len(confidence_and_truth))
