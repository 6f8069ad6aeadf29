"""Body references in text form: roll=10@4.0, or roll=10,height=-0.02@4.0."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from surefoot._core import BodyReference, Error
from surefoot.robot.robot_toml import suggest
from surefoot.robot.setting_checks import check_number

REFERENCE_FORMAT = "NAME=VALUE[,NAME=VALUE ...]@TIME"
REFERENCE_EXAMPLE = "roll=10,height=-0.02@4.0"
AXES = {"x": "m", "y": "m", "height": "m", "roll": "deg", "pitch": "deg", "yaw": "deg"}
"""Axes of a request and their units, with the names and the order of BodyReference."""

# 10 m: kMaxTarget in body_motion.cpp; 180 deg: any rotation.
_MAX_OFFSET = {"m": 10.0, "deg": 180.0}  # largest accepted offset, by its unit
# Numerical: sums of periods, which are whole milliseconds.
_TIME_ROUNDING = 1e-9  # [s] tolerance for the rounding of tick times


@dataclass(frozen=True)
class ReferenceRequest:
    """Requested offsets of some axes of the body pose; all other axes keep their last request.

    Attributes:
        offsets: Offset from the latched pose [m] or [deg], by the axes in AXES.
        time: Time of the request [s].
    """

    offsets: dict[str, float]
    time: float

    def __post_init__(self) -> None:
        for axis, value in self.offsets.items():
            if axis not in AXES:
                raise Error(
                    f"reference: got axis '{axis}'{suggest(axis, AXES)}; "
                    f"valid names: {', '.join(AXES)}"
                )
            max_offset = _MAX_OFFSET[AXES[axis]]
            check_number(f"reference: {axis} [{AXES[axis]}]", value, -max_offset, max_offset)
        check_number("reference: time [s]", self.time, 0.0, 1e9)

    def __str__(self) -> str:
        """Return the request as text that parse_reference() reads."""
        words = ",".join(f"{axis}={value}" for axis, value in self.offsets.items())
        return f"{words}@{self.time}"


def parse_reference(text: str) -> ReferenceRequest:
    """Parse a request of the form NAME=VALUE[,NAME=VALUE ...]@TIME.

    The names are x, y and height, with values in m, and roll, pitch and yaw, with values in deg.
    Each value is an offset from the latched pose. The time is in s.

    Args:
        text: The request as text.

    Raises:
        Error: The text does not match REFERENCE_FORMAT, an axis is unknown or named twice, or a
            number is invalid.
    """
    words, at, time = text.strip().partition("@")
    pairs = [word.partition("=") for word in words.split(",")]
    if not at or any(not name.strip() or not equals for name, equals, _ in pairs):
        raise Error(
            f"reference: got '{text}', expected {REFERENCE_FORMAT}, such as {REFERENCE_EXAMPLE}"
        )
    names = [name.strip() for name, _, _ in pairs]
    duplicates = [name for name in names if names.count(name) > 1]
    if duplicates:
        raise Error(f"reference '{text}': got '{duplicates[0]}' twice, expected every name once")
    offsets = {name.strip(): _parse_number(value, name.strip(), text) for name, _, value in pairs}
    return ReferenceRequest(offsets, _parse_number(time, "time", text))


def reference_schedule(
    requests: Sequence[ReferenceRequest],
) -> list[tuple[float, dict[str, float]]]:
    """Return the time [s] of each request, with the offsets that apply from this time.

    The offsets are given for all six axes, by axis [m] or [deg]. An axis without a request at this
    time keeps the offset of its last request, or 0.
    """
    requested = dict.fromkeys(AXES, 0.0)
    steps = []
    for request in sorted(requests, key=lambda request: request.time):
        requested = {**requested, **request.offsets}
        steps.append((request.time, requested))
    return steps


def first_tick(time: float, rate: float) -> int:
    """Return the first tick at or after a time [s] in a run with a control rate [Hz]."""
    return math.ceil((time - _TIME_ROUNDING) * rate)


def body_references(requests: Sequence[ReferenceRequest], rate: float) -> dict[int, BodyReference]:
    """Return a dict of tick to body reference.

    The controller receives each reference just before its update() in that tick.

    Args:
        requests: Requests in any order.
        rate: Control rate [Hz].
    """
    return {
        first_tick(time, rate): BodyReference(
            **{axis: to_si(axis, v) for axis, v in requested.items()}
        )
        for time, requested in reference_schedule(requests)
    }


def to_si(axis: str, value: float) -> float:
    """Convert an offset of an axis from m or deg to m or rad."""
    return math.radians(value) if AXES[axis] == "deg" else value


def _parse_number(number_text: str, what: str, text: str) -> float:
    try:
        value = float(number_text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise Error(f"reference '{text}': {what}: got '{number_text}', expected a finite number")
    return value
