"""Commanded velocities in text form: 0.5,0,0@1 is 0.5 m/s forward from 1 s on."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from surefoot._core import Error, WalkVelocity
from surefoot.robot.setting_checks import check_number
from surefoot.stand.reference_request import first_tick

VELOCITY_FORMAT = "VX,VY,YAW_RATE@TIME"
VELOCITY_EXAMPLE = "0.5,0,0@1"
_NAMES = ("VX", "VY", "YAW_RATE")
# Numerical: far beyond the reach of any robot; the controller clamps to its own limits.
_MAX_VELOCITY = 1000.0


@dataclass(frozen=True)
class VelocityRequest:
    """A commanded velocity, in force from its time until the next request.

    Attributes:
        vx: Velocity of the centre of mass, forward [m/s].
        vy: Velocity of the centre of mass, to the left [m/s].
        yaw_rate: Turn to the left [rad/s].
        time: Start [s].
    """

    vx: float
    vy: float
    yaw_rate: float
    time: float

    def __post_init__(self) -> None:
        for name, unit in (("vx", "m/s"), ("vy", "m/s"), ("yaw_rate", "rad/s")):
            value = getattr(self, name)
            check_number(f"velocity: {name} [{unit}]", value, -_MAX_VELOCITY, _MAX_VELOCITY)
        check_number("velocity: time [s]", self.time, 0.0, 1e9)

    def __str__(self) -> str:
        """Return the request as text that parse_velocity() reads."""
        return f"{self.vx},{self.vy},{self.yaw_rate}@{self.time}"

    @property
    def velocity(self) -> WalkVelocity:
        """The velocity as the controller receives it."""
        return WalkVelocity(self.vx, self.vy, self.yaw_rate)


def parse_velocity(text: str) -> VelocityRequest:
    """Parse a velocity of the form VX,VY,YAW_RATE@TIME, in m/s, m/s, rad/s and s.

    Raises:
        Error: The text does not match VELOCITY_FORMAT, or a number is invalid or out of range.
    """
    words, at, time = text.strip().partition("@")
    numbers = words.split(",")
    if not at or len(numbers) != len(_NAMES):
        raise Error(
            f"velocity: got '{text}', expected {VELOCITY_FORMAT}, such as {VELOCITY_EXAMPLE}"
        )
    vx, vy, yaw_rate = (
        _parse_number(number, name, text) for number, name in zip(numbers, _NAMES, strict=True)
    )
    return VelocityRequest(vx, vy, yaw_rate, _parse_number(time, "TIME", text))


def velocity_ticks(
    requests: Sequence[VelocityRequest], rate: float
) -> list[tuple[int, VelocityRequest]]:
    """Return the first tick of each request, by time, at a control rate [Hz]."""
    ordered = sorted(requests, key=lambda request: request.time)
    return [(first_tick(request.time, rate), request) for request in ordered]


def _parse_number(number_text: str, what: str, text: str) -> float:
    try:
        value = float(number_text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise Error(f"velocity '{text}': {what}: got '{number_text}', expected a finite number")
    return value
