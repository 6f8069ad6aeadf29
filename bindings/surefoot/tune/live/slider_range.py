"""Range and step of a gain's slider."""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot._core import GainInfo

RANGE_FACTORS = {"x 2": 2.0, "x 4": 4.0, "x 10": 10.0, "x 100": 100.0}
"""Upper end of a slider as a multiple of the robot's own value, by its label on the page. A larger
factor is a larger range; the page calls the factor "slider reach"."""
# Chosen for the page: a person can set such a slider with the mouse.
_ZERO_GAIN_REACH = 0.25  # used in place of the robot's own value if that is zero
_MIN_STEPS = 100  # smallest number of steps of a slider


@dataclass(frozen=True)
class SliderRange:
    """Ends, step and number of decimals of a slider."""

    low: float
    high: float
    step: float
    digits: int


def slider_range(info: GainInfo, own: float, value: float, range_factor: float) -> SliderRange:
    """Return a slider range from the gain's minimum to a multiple of the robot's own value.

    The ranges in gain_table() span up to eight decades, too much for a slider. A larger
    `range_factor` gives a larger range. The number box of the slider accepts exact values.

    Args:
        info: The gain.
        own: The robot's own value.
        value: Present value; the range always includes it.
        range_factor: One of RANGE_FACTORS.
    """
    high = min(info.maximum, (own or _ZERO_GAIN_REACH) * range_factor)
    high = max(high, value)
    return rounded_range(info.minimum, high, value)


def rounded_range(low: float, high: float, value: float) -> SliderRange:
    """Return a range whose step is a power of ten and whose lower end is a multiple of the step.

    Args:
        low: Lower end before rounding. The function rounds this end up to a multiple of the
            step, but not above `value`.
        high: Upper end. If `high` is not above `low`, the range contains only `value`.
        value: Value that the range must include.
    """
    span = high - low
    if span <= 0.0:
        return SliderRange(value, value, 1.0, 3)
    digits = -math.floor(math.log10(span / _MIN_STEPS) + 1e-9)
    step = 10.0**-digits
    first_step = round(math.ceil(low / step - 1e-9) * step, max(digits, 0))
    return SliderRange(min(first_step, value), high, step, max(digits, 0))
