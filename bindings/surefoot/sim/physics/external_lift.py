"""Hands that lift: the trunk off the ground and back, or one foot of a standing robot.

A hand is a spring and a damper to a place above the one where it took hold. Its grip closes and
opens in a few milliseconds, so loads leave the feet, and come back, faster than a leg could do it.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from surefoot._core import Error, Robot
from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.robot.setting_checks import check_number, check_one_of
from surefoot.sim.model.mujoco_handles import Handles

LIFT_PARTS = ("trunk", *LEGS)
TRUNK_FREQUENCY = 40.0  # [rad/s] of the critically damped hold
TRUNK_SPECIFIC_INERTIA = (
    0.1  # [m^2] inertia per kilogram that the hold of the attitude reckons with
)
FOOT_STIFFNESS = 250.0  # [N/m] per kilogram of robot: lifts a foot that pushes a quarter of it down
FOOT_DAMPING = 4.0  # [N.s/m] per kilogram


@dataclass(frozen=True)
class Lift:
    """One lift.

    Attributes:
        part: "trunk", or a foot: "FR", "FL", "RR", "RL".
        time: When the grip begins to close, since reset [s].
        duration: Until it begins to open [s].
        height: How far above the place of the grip the hand wants the part [m].
        speed: With which it wants it there [m/s].
        ramp: In which the grip closes, and opens [s].
        lowering: Speed of putting it down before the grip opens [m/s]; None: let go up there.
    """

    part: str
    time: float
    duration: float = 0.5
    height: float = 0.03
    speed: float = 0.6
    ramp: float = 0.02
    lowering: float | None = None

    def __post_init__(self) -> None:
        check_one_of("part", self.part, LIFT_PARTS)
        check_number("time", self.time, 0.0, 1e9)
        for name, maximum in (("duration", 1e6), ("height", 1.0), ("speed", 100.0), ("ramp", 10.0)):
            check_number(name, getattr(self, name), 1e-6, maximum)
        if self.lowering is not None:
            check_number("lowering", self.lowering, 1e-6, 100.0)
        if self.duration < self.ramp:
            raise Error(
                f"duration: got {self.duration:g} s, expected the ramp's {self.ramp:g} or more"
            )

    def desired_height(self, time: float) -> float:
        """Return how far above the place of the grip the hand wants the part at a time [m]."""
        height = min(self.height, self.speed * (time - self.time))
        if self.lowering is not None:
            height = min(height, self.lowering * (self.time + self.duration - time))
        return max(0.0, height)

    def grip(self, time: float) -> float:
        """Return how firm the grip is, 0 .. 1, at a time [s]."""
        closing = (time - self.time) / self.ramp
        opening = 1.0 - (time - self.time - self.duration) / self.ramp
        return max(0.0, min(1.0, closing, opening))


class ExternalLift:
    """Carries out one lift.

    Args:
        model: MuJoCo's model.
        handles: Indices into it.
        robot: For its mass.
        lift: What to do.
    """

    def __init__(self, model: mujoco.MjModel, handles: Handles, robot: Robot, lift: Lift) -> None:
        self._model, self._lift, self._mass = model, lift, robot.mass
        k = LIFT_PARTS.index(lift.part)
        self._trunk = k == 0
        self._body = handles.root if k == 0 else int(handles.foot_bodies[k - 1])
        self._grip_pose: tuple[Array, Array] | None = None

    def apply(self, data: mujoco.MjData, time: float) -> None:
        """Add to xfrc_applied for the step that begins at `time` [s]."""
        grip = self._lift.grip(time)
        if grip <= 0.0:
            self._grip_pose = None
            return
        position, attitude = data.xpos[self._body], data.xmat[self._body].reshape(3, 3)
        if self._grip_pose is None:
            self._grip_pose = position.copy(), attitude.copy()
        twist = np.zeros(6)  # angular, linear, world axes, of the body's origin
        kind = mujoco.mjtObj.mjOBJ_XBODY
        mujoco.mj_objectVelocity(self._model, data, kind, self._body, twist, 0)
        target = self._grip_pose[0] + [0.0, 0.0, self._lift.desired_height(time)]
        stiffness, damping = self._spring_gains()
        force = grip * (stiffness * (target - position) - damping * twist[3:])
        # MuJoCo applies the force at the body's own centre of mass.
        moment = np.cross(position - data.xipos[self._body], force)
        if self._trunk:
            inertia = grip * TRUNK_SPECIFIC_INERTIA * self._mass
            moment += inertia * TRUNK_FREQUENCY**2 * rotation_error(self._grip_pose[1], attitude)
            moment -= inertia * 2.0 * TRUNK_FREQUENCY * twist[:3]
        data.xfrc_applied[self._body, :3] += force
        data.xfrc_applied[self._body, 3:] += moment

    def _spring_gains(self) -> tuple[float, float]:
        if self._trunk:
            return self._mass * TRUNK_FREQUENCY**2, 2.0 * self._mass * TRUNK_FREQUENCY
        return self._mass * FOOT_STIFFNESS, self._mass * FOOT_DAMPING


def rotation_error(desired: Array, actual: Array) -> Array:
    """Return the rotation (3,) [rad], small, that takes attitude `actual` (3, 3) to `desired`."""
    E = desired @ actual.T
    return 0.5 * np.array([E[2, 1] - E[1, 2], E[0, 2] - E[2, 0], E[1, 0] - E[0, 1]])
