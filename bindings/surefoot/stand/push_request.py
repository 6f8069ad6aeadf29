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
    """A requested push, with its impulse in N.s or in percent of the LIP push limit.

    The LIP push limit depends on the plant, so resolve() needs a plant to convert a percentage.

    Attributes:
        direction: "lateral" (left), "forward", or an angle [deg] from forward towards left.
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
        """Return the push as text that parse_push() reads."""
        unit = "%" if self.percent else ""
        height = f":{self.height}" if self.height else ""
        return f"{self.direction}:{self.impulse}{unit}:{self.duration}{height}@{self.time}"

    def resolve(self, plant: Plant) -> Push:
        """Return the push with its impulse in N.s.

        A percentage refers to the LIP push limit in the plant's present pose.

        Raises:
            Error: A value is out of range.
        """
        impulse = self.impulse
        if self.percent:
            impulse *= plant.lip_push_limit(self.direction, self.duration) / 100.0
        return Push(self.direction, impulse, self.duration, self.time, self.height)


def parse_push(text: str) -> PushRequest:
    """Parse a push of the form DIRECTION:IMPULSE:LENGTH[:HEIGHT]@TIME.

    Direction: lateral, forward, or an angle [deg] from forward towards left. Impulse: [N.s]; with a
    % sign: percent of the LIP push limit. Length: duration of the push [s]. Height: height of the
    line of action above the centre of mass [m]; default 0. Time: start of the push [s].

    Args:
        text: The push as text.

    Raises:
        Error: The text does not match PUSH_FORMAT, a number is invalid, or a value is out of range.
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
    # The constructor of Push checks the ranges. It checks a percentage as if it were an impulse.
    Push(request.direction, request.impulse, request.duration, request.time, request.height)
    return request


def _parse_number(number_text: str, what: str, text: str, names: tuple[str, ...] = ()) -> float:
    try:
        value = float(number_text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        valid = f"{', '.join(names)} or a finite number" if names else "a finite number"
        raise Error(f"push '{text}': {what}: got '{number_text}', expected {valid}")
    return value
