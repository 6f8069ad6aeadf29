"""Timing of the control loop, and the observers of the estimator that affect stability."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, Gains
from surefoot.tune.design.ranges import check_range

# Limits of the requested delay. Each period of delay adds a state to the model, and the time to
# compute the poles grows with the cube of the number of states.
# Chosen: far above the delay with which a robot stands (margins in docs/how-to/design-gains.md).
MAX_DELAY, MAX_DELAY_PERIODS = 0.2, 100  # [s], [periods]
# [s], [periods] Largest delay that the search for margins adds to the requested delay.
# Chosen: half of the limits above.
_MARGIN_SEARCH_DELAY, _MARGIN_SEARCH_PERIODS = 0.1, 50
# Chosen: beyond the 100 to 1000 Hz of `surefoot run` on both sides.
RATE_RANGE = (10.0, 10_000.0)  # [Hz] permitted rates of the loop
# Chosen: far above the 1 to 4 ms of the episodes of tune search.
MOTOR_LAG_RANGE = (0.0, 0.1)  # [s] permitted time constants of the motor torque


@dataclass(frozen=True)
class Timing:
    """Rate and delays of the control loop.

    Attributes:
        rate: Ticks per second [Hz]. A command acts one period after its LowState, plus `delay`.
        delay: Additional delay of commands [s]. It may exceed the limit of
            check_requested_delay(), because the search for margins adds delay.
        motor_lag: Time constant of the motor torque [s].
    """

    rate: float = 500.0
    delay: float = 0.0
    # The lag of the simulated motors (surefoot.sim).
    motor_lag: float = 0.002

    def __post_init__(self) -> None:
        check_range("rate", self.rate, *RATE_RANGE, "Hz")
        check_range("delay", self.delay, 0.0, MAX_DELAY + _MARGIN_SEARCH_DELAY + 1e-9, "s")
        check_range("motor_lag", self.motor_lag, *MOTOR_LAG_RANGE, "s")
        _check_periods(self.rate, self.delay, MAX_DELAY_PERIODS + _MARGIN_SEARCH_PERIODS)

    @property
    def period(self) -> float:
        """Time between two commands [s]."""
        return 1.0 / self.rate

    @property
    def max_extra_delay(self) -> float:
        """Largest additional delay that the search for margins tries [s]."""
        periods = (MAX_DELAY_PERIODS + _MARGIN_SEARCH_PERIODS) * self.period - self.delay
        return min(_MARGIN_SEARCH_DELAY, MAX_DELAY + _MARGIN_SEARCH_DELAY - self.delay, periods)


def check_requested_delay(
    rate: float, delay: float, rate_name: str = "a rate of", delay_name: str = "additional delay"
) -> None:
    """Raise Error unless the requested delay is within MAX_DELAY and MAX_DELAY_PERIODS.

    Args:
        rate: Rate of the loop [Hz].
        delay: Additional delay of commands [s].
        rate_name: Name of the rate in the message, for example the name of an option.
        delay_name: Name of the delay in the message.
    """
    check_range(delay_name, 1000.0 * delay, 0.0, 1000.0 * MAX_DELAY, "ms")
    _check_periods(rate, delay, MAX_DELAY_PERIODS, rate_name, delay_name)


def _check_periods(
    rate: float, delay: float, most: int, rate_name: str = "a rate of", delay_name: str = "delay"
) -> None:
    if rate * delay > most + 1e-6:
        raise Error(
            f"{delay_name}: got {1000.0 * delay:g} ms at {rate_name} {rate:g} Hz, which are "
            f"{rate * delay:.0f} periods, expected at most {most} ({1000.0 * most / rate:g} ms)"
        )


@dataclass(frozen=True)
class Observers:
    """Observers of external forces in the estimator; see docs/explanation/estimator.md.

    Attributes:
        payload_time: Time constant of the payload observer [s].
        push_time: Filter time of the push observer [s].
        push_dead_band: Acceleration up to which the estimated push is zero [m/s^2].
        push_max: Largest estimated acceleration of a push [m/s^2].
        push_resist: Share of the estimated push that the controller compensates.
    """

    payload_time: float
    push_time: float
    push_dead_band: float
    push_max: float
    push_resist: float

    @staticmethod
    def of(gains: Gains) -> Observers:
        """Return the observers with the given gains."""
        return Observers(
            gains.payload_time,
            gains.push_time,
            gains.push_dead_band,
            gains.push_max,
            gains.push_resist,
        )
