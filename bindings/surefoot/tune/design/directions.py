"""Model of a standing robot as six decoupled directions with inertia, friction and QP limits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot._core import Robot

Array = npt.NDArray[np.float64]

DIRECTION_NAMES = ("x", "y", "z", "roll", "pitch", "yaw")
# For each axis: the names of its stiffness gain and damping gain, and its directions.
AXES: dict[str, tuple[str, str, tuple[str, ...]]] = {
    "height": ("com_kp_vertical", "com_kd_vertical", ("z",)),
    "sway": ("com_kp_horizontal", "com_kd_horizontal", ("x", "y")),
    "attitude": ("base_kp_tilt", "base_kd_tilt", ("roll", "pitch")),
    "yaw": ("base_kp_yaw", "base_kd_yaw", ("yaw",)),
}


@dataclass(frozen=True)
class Direction:
    """One direction of body motion with fixed feet: a mass or inertia that moves on its own.

    Forces are divided by `inertia`, so they have the unit of an acceleration.

    Attributes:
        name: x, y, z of the centre of mass, or roll, pitch, yaw of the base; in base axes.
        rotates: True for roll, pitch and yaw.
        inertia: Inertia of the robot in this direction, with rotors [kg or kg.m^2].
        friction: Deceleration by dry friction of the joints [m/s^2 or rad/s^2]. It is 0 for y,
            because friction hardly changes the stability boundary (docs/how-to/design-gains.md).
        viscous: Deceleration by viscous friction of the joints, per speed [1/s].
        base_motion_ratio: Displacement of the base origin per displacement of the centre of mass.
        external_acceleration_ratio: Ratio r. If the estimator reports an external acceleration e
            although no external force acts, the motors accelerate the body by r e less than
            planned. r = base_motion_ratio * mass / inertia; 1 for rotations.
        limits: Table (n, 2) with increasing rows: desired acceleration, and acceleration that the
            QP achieves [m/s^2 or rad/s^2].
        push_velocity: Velocity after a push of half the LIP push limit [m/s or rad/s].
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
    """Model of a standing robot.

    Attributes:
        robot: The robot.
        height: Height of the centre of mass above the ground [m].
        directions: The six directions, by name.
    """

    robot: Robot
    height: float
    directions: dict[str, Direction]

    def axis_directions(self, axis: str) -> list[Direction]:
        """Return the directions that the gains of an axis control."""
        return [self.directions[name] for name in AXES[axis][2]]
