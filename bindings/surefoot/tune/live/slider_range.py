"""Where a gain's slider begins and ends, and how fine it is."""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot._core import GainInfo

ZOOMS = {"x 2": 2.0, "x 4": 4.0, "x 10": 10.0, "x 100": 100.0}
"""How far sliders reach: multiples of the robot's own value, by what the page calls them."""
_ZERO_GAIN_REACH = 0.25  # a slider of a gain whose own value is zero reaches to this times the zoom
_MIN_STEPS = 100  # at least, from end to end


@dataclass(frozen=True)
class SliderRange:
    """Ends, step and digits after the point of a slider."""

    low: float
    high: float
    step: float
    digits: int


def slider_range(info: GainInfo, own: float, value: float, zoom: float) -> SliderRange:
    """Return the range of a slider around a robot's own value.

    Ranges of the table span up to eight decades, most of them of no use for a given robot. A
    slider from zero to a few times the own value is as fine as its robot needs it, its box
    takes exact numbers, and the zoom leads further.

    Args:
        info: Of the gain.
        own: The robot's own value.
        value: The present one; the slider reaches it in any case.
        zoom: Of ZOOMS.
    """
    high = min(info.maximum, (own or _ZERO_GAIN_REACH) * zoom)
    high = max(high, value)
    return rounded_range(info.minimum, high, value)


def rounded_range(low: float, high: float, value: float) -> SliderRange:
    """Return a range whose step is a power of ten and whose low end is a multiple of it.

    Args:
        low: Where it may begin; it begins at the next multiple above, but never above `value`.
        high: Where it ends; above low, or there is nothing to slide.
        value: What it must be able to show.
    """
    span = high - low
    if span <= 0.0:
        return SliderRange(value, value, 1.0, 3)
    digits = -math.floor(math.log10(span / _MIN_STEPS) + 1e-9)
    step = 10.0**-digits
    first_step = round(math.ceil(low / step - 1e-9) * step, max(digits, 0))
    return SliderRange(min(first_step, value), high, step, max(digits, 0))
