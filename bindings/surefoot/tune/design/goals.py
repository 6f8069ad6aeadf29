"""Goal of an axis: natural frequency and damping ratio."""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot._core import Error
from surefoot.tune.design.ranges import check_range

# Lower end chosen: slower than any motion of a standing robot.
FREQUENCY_RANGE = (0.01, 7.1)  # [Hz] range of goals; 7.1 Hz gives kp = 2000 1/s^2, the largest kp


@dataclass(frozen=True)
class Goal:
    """Natural frequency and damping of x'' = -kp x - kd x'.

    Attributes:
        frequency: Natural frequency f [Hz].
        damping: Damping ratio zeta; 1 is critical damping.
    """

    frequency: float
    damping: float

    def __post_init__(self) -> None:
        for name, value, unit in (
            ("frequency", self.frequency, " Hz"),
            ("damping", self.damping, ""),
        ):
            if not (math.isfinite(value) and value > 0.0):
                raise Error(f"{name}: got {value:g}{unit}, expected a number above 0")

    @property
    def kp(self) -> float:
        """Stiffness per unit of inertia, (2 pi f)^2 [1/s^2]."""
        return (2.0 * math.pi * self.frequency) ** 2

    @property
    def kd(self) -> float:
        """Damping per unit of inertia, 2 zeta 2 pi f [1/s]."""
        return 4.0 * math.pi * self.damping * self.frequency

    def at(self, frequency: float) -> Goal:
        """Return a goal with the same damping ratio and the given frequency [Hz]."""
        return Goal(frequency, self.damping)


def goal_from_gains(kp: float, kd: float) -> Goal:
    """Return the frequency and damping of kp [1/s^2] and kd [1/s].

    Raises:
        Error: kp or kd is not above 0.
    """
    if not (kp > 0.0 and kd > 0.0):
        raise Error(f"gains: got kp {kp:g} and kd {kd:g}, expected both above 0")
    return Goal(math.sqrt(kp) / (2.0 * math.pi), kd / (2.0 * math.sqrt(kp)))


def parse_goal(option: str, text: str, damping: float) -> Goal:
    """Parse FREQ[:DAMPING] to a goal; raise Error if the text is invalid.

    Args:
        option: Name of the option, for messages.
        text: Frequency [Hz], and optionally a damping ratio.
        damping: Damping ratio if the text has none.
    """
    try:
        frequency, *own = (float(word) for word in text.split(":"))
        if len(own) > 1:
            raise ValueError
    except ValueError:
        raise Error(f"{option}: got '{text}', expected FREQ[:DAMPING] in Hz") from None
    check_range(option, frequency, *FREQUENCY_RANGE, "Hz")
    try:
        return Goal(frequency, own[0] if own else damping)
    except Error as problem:
        raise Error(f"{option}: {problem}") from None
