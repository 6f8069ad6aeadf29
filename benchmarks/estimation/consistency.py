"""Consistency of an estimator: normalised squared errors against their chi-square band."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import NormalDist

import numpy as np

from estimation.log_rows import Array

BAND_PROBABILITY = 0.95  # probability that a consistent value is inside the band


def chi_square_band(dof: Array) -> tuple[Array, Array]:
    """Return the ends of the 95 % chi-square band for degrees of freedom (n,).

    The approximation of Wilson and Hilferty has an error below 1 % from 5 degrees of freedom on.
    """
    z = NormalDist().inv_cdf(0.5 + BAND_PROBABILITY / 2.0)
    spread = 2.0 / (9.0 * np.maximum(dof, 1))
    low, high = (
        dof * np.maximum(1.0 - spread + sign * z * np.sqrt(spread), 0.0) ** 3 for sign in (-1, 1)
    )
    return low, high


def within_band(squares: Sequence[Array], dofs: Sequence[Array]) -> tuple[float, float]:
    """Compare the sums over all seeds of normalised squared errors with their chi-square band.

    Args:
        squares: Normalised squared errors (n,) of each seed; long ones are cut to the shortest.
        dofs: Degrees of freedom (n,) of each seed.

    Returns:
        Share of ticks [%] whose sum is in its band, and mean error per degree of freedom. (NaN,
        NaN): no tick has degrees of freedom.
    """
    n = min(len(values) for values in squares)
    total = np.sum([values[:n] for values in squares], axis=0)
    dof = np.sum([values[:n] for values in dofs], axis=0)
    defined = (dof > 0) & np.isfinite(total)
    if not defined.any():
        return float("nan"), float("nan")
    low, high = chi_square_band(dof[defined])
    inside = (total[defined] >= low) & (total[defined] <= high)
    return 100.0 * float(inside.mean()), float(total[defined].sum() / dof[defined].sum())
