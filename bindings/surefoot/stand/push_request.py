"""Pushes in text form: lateral:8.0:0.1@2.0, or lateral:50%:0.1:-0.05@2.0."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from surefoot._core import Error
from surefoot.sim import Plant, Push

PUSH_FORMAT = "DIRECTION:IMPULSE:LENGTH[:HEIGHT]@TIME"
PUSH_EXAMPLE = "lateral:8.0:0.1@2.0"
_NAMED_DIRECTIONS = ("lateral", "forward")


@dataclass(frozen=True)
class PushRequest:
    """A requested push; only a plant can convert a percentage of the LIP push limit to N.s.

    Attributes:
        direction: "lateral" (left), "forward", or degrees from forward towards left.
        impulse: Impulse [N.s], or percentage of the LIP push limit.
        percent: True if `impulse` is a percentage.
        duration: Duration [s].
        time: Start time [s].
        height: Height of the line of action above the centre of mass [m].
    """

    direction: str | float
    impulse: float
    percent: bool
    duration: float
    time: float
    height: float = 0.0

    def __str__(self) -> str:
        """Return the push in the form that parse_push() reads."""
        unit = "%" if self.percent else ""
        height = f":{self.height}" if self.height else ""
        return f"{self.direction}:{self.impulse}{unit}:{self.duration}{height}@{self.time}"

    def resolve(self, plant: Plant) -> Push:
        """Return the push in N.s for the current state of a plant; raises Error."""
        impulse = self.impulse
        if self.percent:
            impulse *= plant.lip_push_limit(self.direction, self.duration) / 100.0
        return Push(self.direction, impulse, self.duration, self.time, self.height)


def parse_push(text: str) -> PushRequest:
    """Parse DIRECTION:IMPULSE:LENGTH[:HEIGHT]@TIME.

    Args:
        text: Direction: lateral, forward, or degrees from forward towards left. Impulse: N.s, or
            percent of the LIP push limit with a % sign. Length (duration) and time: s. Height of
            the line of action above the centre of mass: m, default 0.

    Raises:
        Error: The form is another one, a number is invalid, or a value is out of range.
    """
    match = re.fullmatch(r"([^:@]+):([^:@%]+)(%?):([^:@]+)(?::([^:@]+))?@([^:@]+)", text.strip())
    if match is None:
        raise Error(f"push: got '{text}', expected {PUSH_FORMAT}, such as {PUSH_EXAMPLE}")
    direction, impulse, percent, duration, height, time = match.groups()
    request = PushRequest(
        direction
        if direction in _NAMED_DIRECTIONS
        else _parse_number(direction, "direction", text, _NAMED_DIRECTIONS),
        _parse_number(impulse, "impulse", text),
        bool(percent),
        _parse_number(duration, "length", text),
        _parse_number(time, "time", text),
        0.0 if height is None else _parse_number(height, "height", text),
    )
    # Push checks the ranges; a percentage takes the place of the impulse in this check.
    Push(request.direction, request.impulse, request.duration, request.time, request.height)
    return request


def _parse_number(number_text: str, what: str, text: str, names: tuple[str, ...] = ()) -> float:
    try:
        value = float(number_text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        valid = ", ".join((*names, "")) + "a number"
        raise Error(f"push '{text}': {what}: got '{number_text}', expected {valid}")
    return value
