"""Velocity of a walking robot that the keyboard of surefoot run gives."""

from __future__ import annotations

import math

from surefoot._core import Error, WalkVelocity

# Change per key. Chosen: a few keys reach a brisk walk, and one key is a slow walk.
SPEED_STEP = 0.1  # [m/s]
TURN_STEP = 0.2  # [rad/s]
_STEPS = {
    "i": (SPEED_STEP, 0.0, 0.0),
    "k": (-SPEED_STEP, 0.0, 0.0),
    "h": (0.0, SPEED_STEP, 0.0),
    "g": (0.0, -SPEED_STEP, 0.0),
    "j": (0.0, 0.0, TURN_STEP),
    "l": (0.0, 0.0, -TURN_STEP),
}
VELOCITY_HELP = (
    "i k faster forward and backward, h g to the left and right, j l turn left and right, "
    "0 velocity 0, v VX VY YAW sets it [m/s, rad/s]"
)


class KeyVelocity:
    """Velocity that typed lines change.

    Attributes:
        value: The velocity: forward, to the left [m/s], turn to the left [rad/s].
    """

    def __init__(self) -> None:
        self.value = (0.0, 0.0, 0.0)

    @property
    def velocity(self) -> WalkVelocity:
        """The velocity as the Runner receives it."""
        return WalkVelocity(*self.value)

    def reset(self) -> None:
        """Set the velocity to 0."""
        self.value = (0.0, 0.0, 0.0)

    def reduce_to(self, in_force: WalkVelocity) -> None:
        """Reduce each component to that of the velocity in force, so that the next key acts.

        Args:
            in_force: The velocity to which the limits have reduced this one.
        """
        vx, vy, yaw_rate = self.value
        self.value = (
            math.copysign(min(abs(vx), abs(in_force.vx)), vx),
            math.copysign(min(abs(vy), abs(in_force.vy)), vy),
            math.copysign(min(abs(yaw_rate), abs(in_force.yaw_rate)), yaw_rate),
        )

    def handle_line(self, line: str) -> bool:
        """Change the velocity; return whether the line is about the velocity.

        Args:
            line: Typed line in lower case: the keys of VELOCITY_HELP, also several in a row.

        Raises:
            Error: The line begins with v, but three numbers do not follow.
        """
        words = line.split()
        if words[0] == "v":
            self.value = _numbers(words[1:])
        elif line == "0":
            self.reset()
        elif all(key in _STEPS for key in line):
            for key in line:
                x, y, yaw = _STEPS[key]
                self.value = (self.value[0] + x, self.value[1] + y, self.value[2] + yaw)
        else:
            return False
        return True

    def __str__(self) -> str:
        vx, vy, yaw_rate = self.value
        return f"{vx:.2f} {vy:.2f} m/s {yaw_rate:.2f} rad/s"


def _numbers(words: list[str]) -> tuple[float, float, float]:
    try:
        vx, vy, yaw_rate = (float(word) for word in words)
    except ValueError:
        vx = vy = yaw_rate = math.nan
    if not math.isfinite(vx + vy + yaw_rate):
        raise Error(f"v: got '{' '.join(words)}', expected three numbers: VX VY YAW [m/s, rad/s]")
    return vx, vy, yaw_rate
