"""When what is measured acts, and what the estimator makes of it meanwhile."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, Gains


@dataclass(frozen=True)
class Timing:
    """When what is measured acts.

    Attributes:
        rate: LowStates and LowCmds per second [Hz]; each takes one period on its way.
        delay: Further delay of commands [s].
        motor_lag: Time constant of the motors' torque [s].
    """

    rate: float = 500.0
    delay: float = 0.0
    motor_lag: float = 0.002

    def __post_init__(self) -> None:
        for name, value, low, high in (
            ("rate", self.rate, 10.0, 10_000.0),
            ("delay", self.delay, 0.0, 0.2),
            ("motor_lag", self.motor_lag, 0.0, 0.1),
        ):
            if not low <= value <= high:
                raise Error(f"{name}: got {value:g}, expected {low:g} .. {high:g}")

    @property
    def period(self) -> float:
        """Between commands [s]."""
        return 1.0 / self.rate


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
