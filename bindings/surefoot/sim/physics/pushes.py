"""Applies pushes as rectangular pulses with exact impulse."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable

import mujoco
import numpy as np

from surefoot.geometry.rotations import Array
from surefoot.sim.settings import Push


def heading_vector(R_world_base: Array, degrees: float) -> Array:
    """Return the horizontal unit vector (3,) at an angle from the base's heading.

    Args:
        R_world_base: (3, 3) attitude; the horizontal projection of its x axis is forward.
        degrees: From forward towards left [deg].
    """
    angle = math.atan2(R_world_base[1, 0], R_world_base[0, 0]) + math.radians(degrees)
    return np.array([math.cos(angle), math.sin(angle), 0.0])


class PushSchedule:
    """Applies pushes at the centre of mass of the whole robot, or at a height above it.

    Args:
        body: The base; its subtree is the robot.
        dt: Physics step [s].
        pushes: The pushes; add() adds more.

    Attributes:
        force: (3,) total force that the last apply() set, world axes [N].
        point: (3,) point where the last active push acts, world axes [m].
    """

    def __init__(self, body: int, dt: float, pushes: Iterable[Push]) -> None:
        self._body, self._dt = body, dt
        self._pushes: list[Push] = []
        self._direction: dict[int, Array] = {}
        self.force, self.point = np.zeros(3), np.zeros(3)
        for push in pushes:
            self.add(push)

    def add(self, push: Push) -> None:
        """Add a push."""
        self._pushes.append(push)

    def idle_steps(self, time: float) -> int:
        """Return how many steps from `time` [s] on need no call of apply()."""
        wait = math.inf
        for push in self._pushes:
            # One step of margin on both sides, because apply() must also reset the force to zero.
            if time <= push.time + push.duration + self._dt:
                wait = min(wait, push.time - self._dt - time)
        return sys.maxsize if wait == math.inf else max(0, math.floor(wait / self._dt))

    def apply(self, data: mujoco.MjData, time: float) -> None:
        """Write xfrc_applied for the step from `time` to `time` + dt [s]."""
        force, moment = np.zeros(3), np.zeros(3)
        for k, push in enumerate(self._pushes):
            overlap = min(time + self._dt, push.time + push.duration) - max(time, push.time)
            # Ignore overlaps below 1e-9 steps, which rounding of the clock causes at both ends.
            if overlap <= 1e-9 * self._dt:
                continue
            if k not in self._direction:
                attitude = data.xmat[self._body].reshape(3, 3)
                self._direction[k] = heading_vector(attitude, push.degrees)
            magnitude = push.impulse / push.duration * overlap / self._dt
            push_force = magnitude * self._direction[k]
            self.point = data.subtree_com[self._body] + [0.0, 0.0, push.height]
            force += push_force
            # MuJoCo applies the force at the body's own centre of mass.
            moment += np.cross(self.point - data.xipos[self._body], push_force)
        self.force = force
        data.xfrc_applied[self._body, :3] = force
        data.xfrc_applied[self._body, 3:] = moment
