"""Calibration of the contact confidence: its difference from the frequency of contact."""

from __future__ import annotations

import numpy as np

from estimation.log_rows import Array


def calibration_error(confidence_and_truth: Array, bins: int = 10) -> float:
    """Compute the calibration error of a contact confidence.

    The confidence range is divided into equal bins. In each bin, the mean confidence is compared
    with the frequency of true contact. The error is the mean of the absolute differences, weighted
    by the number of rows in each bin. NaN: there are no rows.

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
