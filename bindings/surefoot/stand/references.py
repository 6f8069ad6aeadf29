"""References as people write them: roll=10@4.0, or roll=10,height=-0.02@4.0."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from surefoot._core import BodyReference, Error
from surefoot.robot_table import suggest
from surefoot.sim.checks import number

FORM = "NAME=VALUE[,NAME=VALUE ...]@TIME"
EXAMPLE = "roll=10,height=-0.02@4.0"
AXES = {"x": "m", "y": "m", "height": "m", "roll": "deg", "pitch": "deg", "yaw": "deg"}
"""What can be asked for and its unit; the names and the order are BodyReference's."""

_GREATEST = {"m": 10.0, "deg": 180.0}
_CLOCK = 1e-9  # [s] of rounding in the time of a tick


@dataclass(frozen=True)
class ReferenceRequest:
    """Some axes of the body's pose, as asked for; the others stay where they were asked to be.

    Attributes:
        offsets: From the pose that the robot stands in, by axis: m and deg.
        time: When it is asked for [s].
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
            greatest = _GREATEST[AXES[axis]]
            number(f"reference: {axis} [{AXES[axis]}]", value, -greatest, greatest)
        number("reference: time [s]", self.time, 0.0, 1e9)

    def __str__(self) -> str:
        """Write the request in the form that parse_reference() reads."""
        words = ",".join(f"{axis}={value}" for axis, value in self.offsets.items())
        return f"{words}@{self.time}"


def parse_reference(text: str) -> ReferenceRequest:
    """Read NAME=VALUE[,NAME=VALUE ...]@TIME.

    Args:
        text: Names x, y, height with a value in m, roll, pitch, yaw in deg: offsets from the pose
            that the robot stands in; time [s].

    Raises:
        Error: Another form, an unknown axis or one named twice, a number that is none.
    """
    words, at, time = text.strip().partition("@")
    pairs = [word.partition("=") for word in words.split(",")]
    if not at or any(not name.strip() or not equals for name, equals, _ in pairs):
        raise Error(f"reference: got '{text}', expected {FORM}, such as {EXAMPLE}")
    names = [name.strip() for name, _, _ in pairs]
    twice = [name for name in names if names.count(name) > 1]
    if twice:
        raise Error(f"reference '{text}': got '{twice[0]}' twice, expected every name once")
    offsets = {name.strip(): _number(value, name.strip(), text) for name, _, value in pairs}
    return ReferenceRequest(offsets, _number(time, "time", text))


def schedule(requests: Sequence[ReferenceRequest]) -> list[tuple[float, dict[str, float]]]:
    """Return when each request comes [s] and all that is then asked for: every axis, m and deg.

    A later request of one axis keeps what earlier ones asked of the others.
    """
    asked = dict.fromkeys(AXES, 0.0)
    steps = []
    for request in sorted(requests, key=lambda request: request.time):
        asked = {**asked, **request.offsets}
        steps.append((request.time, asked))
    return steps


def first_tick(time: float, rate: float) -> int:
    """Return the first tick at or after a time [s] of a run with a rate [Hz]."""
    return math.ceil((time - _CLOCK) * rate)


def body_references(requests: Sequence[ReferenceRequest], rate: float) -> dict[int, BodyReference]:
    """Return what to ask of the controller, by the tick before which to ask for it."""
    return {
        first_tick(time, rate): BodyReference(**{axis: in_si(axis, v) for axis, v in asked.items()})
        for time, asked in schedule(requests)
    }


def in_si(axis: str, value: float) -> float:
    """Return an axis' value in m or rad."""
    return math.radians(value) if AXES[axis] == "deg" else value


def _number(digits: str, what: str, text: str) -> float:
    try:
        value = float(digits)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise Error(f"reference '{text}': {what}: got '{digits}', expected a number")
    return value
