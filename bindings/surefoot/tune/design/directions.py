"""The robot as six directions of its body, standing: inertia, friction, what its program gives."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot._core import Robot

Array = npt.NDArray[np.float64]

DIRECTION_NAMES = ("x", "y", "z", "roll", "pitch", "yaw")
# Axis, its gains, its directions.
AXES: dict[str, tuple[str, str, tuple[str, ...]]] = {
    "height": ("com_kp_vertical", "com_kd_vertical", ("z",)),
    "sway": ("com_kp_horizontal", "com_kd_horizontal", ("x", "y")),
    "attitude": ("base_kp_tilt", "base_kd_tilt", ("roll", "pitch")),
    "yaw": ("base_kp_yaw", "base_kd_yaw", ("yaw",)),
}


@dataclass(frozen=True)
class Direction:
    """One way in which the body moves while the feet stay, per unit of its own inertia.

    Attributes:
        name: x, y, z of the centre of mass, or roll, pitch, yaw of the base; the robot's axes.
        rotates: Whether it is one of the last three.
        inertia: That the whole robot has in it, feet fixed, rotors included [kg or kg.m^2].
        friction: Deceleration by dry friction of the joints [m/s^2 or rad/s^2]; 0 for y, where
            it does not help (docs/tuning-design.md).
        viscous: Deceleration by viscous friction, per speed [1/s].
        base_motion_ratio: How much further the base's origin moves than the centre of mass.
        external_acceleration_ratio: What an outside acceleration that is counted with, but is not there, takes
            from the one that is planned: base_motion_ratio times mass by inertia; 1 for rotations.
        limits: (n, 2) accelerations asked of the whole-body program, and those that it gives,
            rising [m/s^2 or rad/s^2].
        push_velocity: Speed that half of the pendulum's limit gives it [m/s or rad/s].
    """

    name: str
    rotates: bool
    inertia: float
    friction: float
    viscous: float
    base_motion_ratio: float
    external_acceleration_ratio: float
    limits: Array
    push_velocity: float


@dataclass(frozen=True)
class StandingBody:
    """A standing robot.

    Attributes:
        robot: The robot.
        height: Of the centre of mass above the ground [m].
        directions: By name.
    """

    robot: Robot
    height: float
    directions: dict[str, Direction]

    def axis_directions(self, axis: str) -> list[Direction]:
        """Return the directions that one pair of gains moves."""
        return [self.directions[name] for name in AXES[axis][2]]
