"""Identification of the command delay from a log, for ControllerOptions.delay."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import Error

# [s] Step between two delays that the search tries. Chosen: an eighth of a period at 500 Hz. Test:
# tests/closed_loop/test_delay_identification.py.
_RESOLUTION = 0.25e-3
# [s] Interval of a torque change. Chosen: longer than a motor lag of 1 to 4 ms, which blurs shorter
# changes. During a longer interval, body motion changes tauEst too.
_DIFFERENCE_TIME = 0.01
# [N.m] Smallest RMS torque change per tick that is more than noise. Chosen: larger than the
# resolution of torques in a frame, 1/256 N.m.
_MIN_TORQUE_CHANGE = 0.02
# Smallest accepted result of _explained_share(). Chosen: below 1, the result without noise, and
# above the results for a robot at rest and for a wrong log.
_MIN_FIT = 0.8

Array = npt.NDArray[np.float64]


def identify_delay(
    tau_sent: Any, tau_reported: Any, period: float, max_delay: float = 0.05
) -> float:
    """Identify the delay from a measurement until its command acts, from a log of small motions.

    The model is tau_reported(t) = k tau_sent(t - delay) + noise, with a gain k per joint. The fit
    compares torque changes over 10 ms, so friction and offsets cancel. It searches delays from 0
    to `max_delay` in steps of 0.25 ms. The identified delay includes the motor lag.

    To record the log, let the robot stand and set in every tick, with t in seconds,
    BodyReference(height=0.01 * sin(20 * t), roll=0.03 * sin(31 * t)). Set the gains
    reference_acceleration to 10 and reference_turn_acceleration to 100. Log two seconds.

    Args:
        tau_sent: motorCmd[i].tau of the LowCmd of every tick, shape (n, 12) [N.m].
        tau_reported: motorState[i].tauEst of the LowState of every tick, shape (n, 12) [N.m]. The
            command in the same row of tau_sent was computed from this LowState.
        period: Time between ticks [s].
        max_delay: Longest delay to search [s].

    Returns:
        Delay [s] for ControllerOptions(delay=...).

    Raises:
        Error: The shapes differ, the log is too short, the motion is too small, or no delay
            explains at least 80 % of the torque changes.
    """
    sent, reported = _validated(tau_sent, tau_reported, period, max_delay)
    delays = np.arange(0.0, max_delay + 0.5 * _RESOLUTION, _RESOLUTION)
    span = max(1, round(_DIFFERENCE_TIME / period))
    fits = np.array([_explained_share(sent, reported, delay / period, span) for delay in delays])
    best = int(np.argmax(fits))
    if fits[best] < _MIN_FIT:
        raise Error(
            f"identify_delay: the best delay explains {100 * fits[best]:.0f} % of the changes of "
            f"tauEst, expected at least {100 * _MIN_FIT:.0f} %; move the body a little while "
            "logging, in pure torque mode"
        )
    return float(delays[best])


def _validated(
    tau_sent: Any, tau_reported: Any, period: float, max_delay: float
) -> tuple[Array, Array]:
    sent, reported = np.asarray(tau_sent, float), np.asarray(tau_reported, float)
    if sent.ndim != 2 or sent.shape != reported.shape:
        raise Error(
            f"identify_delay: got shapes {sent.shape} and {reported.shape}, "
            "expected two equal shapes (ticks, joints)"
        )
    if not (np.isfinite(sent).all() and np.isfinite(reported).all()):
        raise Error("identify_delay: got a torque that is NaN or infinite, expected finite ones")
    if not 0.0 < period <= max_delay:
        raise Error(f"identify_delay: got period {period} s, expected above 0, up to {max_delay} s")
    if len(sent) < 4.0 * max_delay / period:
        raise Error(
            f"identify_delay: got {len(sent)} ticks, "
            f"expected at least {4.0 * max_delay / period:.0f}"
        )
    motion = float(np.sqrt(np.mean(np.diff(sent, axis=0) ** 2)))
    if motion < _MIN_TORQUE_CHANGE:
        raise Error(
            f"identify_delay: sent torques change by {motion:.2g} N.m per tick, expected at least "
            f"{_MIN_TORQUE_CHANGE}; move the body a little while logging"
        )
    return sent, reported


def _explained_share(sent: Array, reported: Array, ticks: float, span: int) -> float:
    """Return the share of the changes of tauEst that the commands explain, at most 1.

    The commands are delayed by `ticks`, with linear interpolation. A change is a difference over
    `span` ticks. The gain of each joint is the least-squares gain.
    """
    count = len(sent)
    start = int(np.ceil(ticks))
    sample_time = np.arange(start, count) - ticks
    sample_index = np.minimum(np.floor(sample_time).astype(int), count - 2)
    fraction = (sample_time - sample_index)[:, None]
    delayed = (1.0 - fraction) * sent[sample_index] + fraction * sent[sample_index + 1]
    x, y = delayed[span:] - delayed[:-span], reported[start + span :] - reported[start:-span]
    gain = (x * y).sum(axis=0) / np.maximum((x * x).sum(axis=0), 1e-12)
    return float(1.0 - ((y - gain * x) ** 2).sum() / max((y**2).sum(), 1e-12))
