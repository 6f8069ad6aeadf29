"""When what is measured acts, and what the estimator makes of it meanwhile."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, Gains
from surefoot.tune.design.ranges import check_range

# Each period of delay is a state of the model: its poles cost the cube of them.
MAX_DELAY, MAX_DELAY_PERIODS = 0.2, 100  # [s] that may be asked for, in all and in periods
# Beyond what is asked for; longer delay margins are not told apart.
_MARGIN_SEARCH_DELAY, _MARGIN_SEARCH_PERIODS = 0.1, 50
RATE_RANGE = (10.0, 10_000.0)  # [Hz]
MOTOR_LAG_RANGE = (0.0, 0.1)  # [s]


@dataclass(frozen=True)
class Timing:
    """When what is measured acts.

    Attributes:
        rate: LowStates and LowCmds per second [Hz]; each takes one period on its way.
        delay: Further delay of commands [s]; up to what the search for margins adds to the most
            that may be asked for (see check_requested_delay).
        motor_lag: Time constant of the motors' torque [s].
    """

    rate: float = 500.0
    delay: float = 0.0
    motor_lag: float = 0.002

    def __post_init__(self) -> None:
        check_range("rate", self.rate, *RATE_RANGE, "Hz")
        check_range("delay", self.delay, 0.0, MAX_DELAY + _MARGIN_SEARCH_DELAY + 1e-9, "s")
        check_range("motor_lag", self.motor_lag, *MOTOR_LAG_RANGE, "s")
        _check_periods(self.rate, self.delay, MAX_DELAY_PERIODS + _MARGIN_SEARCH_PERIODS)

    @property
    def period(self) -> float:
        """Between commands [s]."""
        return 1.0 / self.rate

    @property
    def max_extra_delay(self) -> float:
        """More delay than this is not looked at for margins [s]."""
        periods = (MAX_DELAY_PERIODS + _MARGIN_SEARCH_PERIODS) * self.period - self.delay
        return min(_MARGIN_SEARCH_DELAY, MAX_DELAY + _MARGIN_SEARCH_DELAY - self.delay, periods)


def check_requested_delay(
    rate: float, delay: float, rate_name: str = "a rate of", delay_name: str = "further delay"
) -> None:
    """Raise Error for more delay than may be asked for.

    Args:
        rate: Of the loop [Hz].
        delay: Further delay of commands [s].
        rate_name: What the rate is called in the error, an option for instance.
        delay_name: What the delay is.
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
    """What the estimator lays to an outside force; see docs/estimation.md.

    Attributes:
        payload_time: Of the payload observer [s].
        push_time: Of the push observer's smoothing [s].
        push_dead_band: Acceleration that is no push [m/s^2].
        push_max: Most that is believed [m/s^2].
        push_resist: Share of a push that is leant against.
    """

    payload_time: float
    push_time: float
    push_dead_band: float
    push_max: float
    push_resist: float

    @staticmethod
    def of(gains: Gains) -> Observers:
        """Return those of gains."""
        return Observers(
            gains.payload_time,
            gains.push_time,
            gains.push_dead_band,
            gains.push_max,
            gains.push_resist,
        )
