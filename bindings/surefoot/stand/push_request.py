"""Pushes as people write them: lateral:8.0:0.1@2.0, or lateral:50%:0.1:-0.05@2.0."""

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
    """A push as asked for; a share of the pendulum's limit has a size only on a plant.

    Attributes:
        direction: "lateral" (left), "forward", or degrees from forward towards left.
        impulse: [N.s], or percent of the limit.
        percent: Whether impulse is percent of the limit.
        duration: [s].
        time: When it begins [s].
        height: Of its line of action above the centre of mass [m].
    """

    direction: str | float
    impulse: float
    percent: bool
    duration: float
    time: float
    height: float = 0.0

    def __str__(self) -> str:
        """Write the push in the form that parse_push() reads."""
        unit = "%" if self.percent else ""
        height = f":{self.height}" if self.height else ""
        return f"{self.direction}:{self.impulse}{unit}:{self.duration}{height}@{self.time}"

    def resolve(self, plant: Plant) -> Push:
        """Return the push in newton seconds for a plant as it stands now; raises Error."""
        impulse = self.impulse
        if self.percent:
            impulse *= plant.lip_push_limit(self.direction, self.duration) / 100.0
        return Push(self.direction, impulse, self.duration, self.time, self.height)


def parse_push(text: str) -> PushRequest:
    """Read DIRECTION:IMPULSE:LENGTH[:HEIGHT]@TIME.

    Args:
        text: Direction lateral, forward or degrees from forward towards left; impulse in N.s, or
            with a % sign in percent of the linear inverted pendulum's limit; length and time [s];
            height of its line of action above the centre of mass [m], 0 if left out.

    Raises:
        Error: Another form, a number that is none, a length, height or time that cannot be.
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
    # The plant checks the ranges in its own terms; percent stands in for an impulse here.
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
