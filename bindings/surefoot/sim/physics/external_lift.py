"""External lifts: a person or a crane lifts the trunk, or one foot of a standing robot.

A lift is a spring and a damper between the lifted part and a target point. The target point is
above the position of the part at the start of the grip. The grip closes and opens within Lift.ramp,
by default 20 ms, so foot loads vanish and return faster than any motion of a leg could cause.
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
# Chosen by hand; tests: test_plant_lifts.py.
# [rad/s] Natural frequency of the critically damped spring on the trunk. The weight extends the
# spring by g / 40^2 = 6 mm.
TRUNK_FREQUENCY = 40.0
# [m^2] Inertia per kilogram of robot, for the spring on the attitude. Assumed: a radius of gyration
# of 0.3 m.
TRUNK_SPECIFIC_INERTIA = 0.1
# [N/m] Stiffness of the spring on a foot, per kilogram of robot. Derived: 1 cm of extension lifts a
# quarter of the weight (2.45 N/kg).
FOOT_STIFFNESS = 250.0
FOOT_DAMPING = 4.0  # [N.s/m] damping on a foot, per kilogram of robot: time constant 16 ms


@dataclass(frozen=True)
class Lift:
    """One external lift.

    Attributes:
        part: "trunk", or a foot: "FR", "FL", "RR", "RL".
        time: Time when the grip begins to close, measured from reset [s].
        duration: Time from the start of closing to the start of opening [s].
        height: Desired height of the part above its position at the start of the grip [m].
        speed: Speed at which the desired height rises [m/s].
        ramp: Duration of closing, and of opening, the grip [s].
        lowering: Speed of lowering the part before the grip opens [m/s]; None: the grip opens at
            the full height.
    """

    part: str
    time: float
    # Defaults, chosen: a foot is up in 50 ms; the ramp is faster than any motion of a leg.
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
                f"duration: got {self.duration:g} s, expected at least the ramp, {self.ramp:g} s"
            )

    def desired_height(self, time: float) -> float:
        """Return the desired height above the start of the grip [m] at a time [s]."""
        height = min(self.height, self.speed * (time - self.time))
        if self.lowering is not None:
            height = min(height, self.lowering * (self.time + self.duration - time))
        return max(0.0, height)

    def grip(self, time: float) -> float:
        """Return the firmness of the grip, 0 .. 1, at a time [s]."""
        closing = (time - self.time) / self.ramp
        opening = 1.0 - (time - self.time - self.duration) / self.ramp
        return max(0.0, min(1.0, closing, opening))


class ExternalLift:
    """Applies the forces of one external lift.

    Args:
        model: MuJoCo's model.
        handles: Indices into model.
        robot: The robot, for its mass.
        lift: The lift.
    """

    def __init__(self, model: mujoco.MjModel, handles: Handles, robot: Robot, lift: Lift) -> None:
        self._model, self._lift, self._mass = model, lift, robot.mass
        k = LIFT_PARTS.index(lift.part)
        self._trunk = k == 0
        self._body = handles.root if k == 0 else int(handles.foot_bodies[k - 1])
        self._grip_pose: tuple[Array, Array] | None = None

    def apply(self, data: mujoco.MjData, time: float) -> None:
        """Add the force and moment to xfrc_applied for the step that begins at `time` [s]."""
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
    """Return the small rotation (3,) [rad], world axes, from attitude `actual` to `desired`."""
    E = desired @ actual.T
    return 0.5 * np.array([E[2, 1] - E[1, 2], E[0, 2] - E[2, 0], E[1, 0] - E[0, 1]])
