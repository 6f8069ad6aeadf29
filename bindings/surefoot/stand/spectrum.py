"""High-frequency content of signals."""

from __future__ import annotations

import math

import numpy as np

from surefoot.stand.simulation_log import Array

# [Hz] Lower bound of the high-frequency band. Chosen: above the frequencies of body motion (at most
# 7.1 Hz), and below half of the control rate (250 Hz).
HIGH_FREQUENCY = 30.0


def high_frequency_rms(signal: Array, rate: float) -> Array:
    """Return the RMS (m,) of the components of signals at HIGH_FREQUENCY and above.

    Sums the power of a Hann-windowed spectrum. The window keeps slow changes from leaking into high
    frequencies. NaN: there are fewer than 16 samples, or the rate is 60 Hz or less.

    Args:
        signal: (n, m) samples of m signals, in any unit; the RMS has the same unit.
        rate: Sample rate [Hz].
    """
    n = len(signal)
    frequency = np.fft.rfftfreq(n, 1.0 / rate)
    if n < 16 or frequency[-1] <= HIGH_FREQUENCY:
        return np.full(signal.shape[1], math.nan)
    window = np.hanning(n + 1)[:-1]
    spectrum = np.fft.rfft((signal - signal.mean(axis=0)) * window[:, None], axis=0)
    # Parseval: each bin of the one-sided spectrum has weight 2. The zero-frequency bin and, for
    # even n, the Nyquist bin have weight 1.
    bin_weight = np.full(len(frequency), 2.0)
    bin_weight[0] = 1.0
    if n % 2 == 0:
        bin_weight[-1] = 1.0
    power = bin_weight[:, None] * np.abs(spectrum) ** 2 / (n * np.sum(window**2))
    return np.asarray(np.sqrt(power[frequency >= HIGH_FREQUENCY].sum(axis=0)))
