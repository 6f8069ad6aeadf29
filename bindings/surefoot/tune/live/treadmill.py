"""Treadmill: a robot that walks stays in view, and the ground moves below it."""

from __future__ import annotations

import numpy as np

from surefoot.geometry.rotations import Array, matrix_from_wxyz
from surefoot.tune.live.scene_state import SceneState


class Treadmill:
    """Origin of the view, which follows the robot along the ground.

    Args:
        slack: Horizontal distance of the base from the origin that moves nothing [m], so that sways
            and steps stay visible.
        section: Size of a section of the ground's grid [m].
    """

    def __init__(self, slack: float, section: float) -> None:
        self._slack, self._section = slack, section
        self._origin = np.zeros(2)

    def follow(self, scene_state: SceneState) -> SceneState:
        """Return the state in the view, with the robot near the origin."""
        away = scene_state.qpos[:2] - self._origin
        distance = float(np.linalg.norm(away))
        if distance > self._slack:
            self._origin = self._origin + away * (1.0 - self._slack / distance)
        normal = matrix_from_wxyz(scene_state.ground)[:, 2]
        # The ground goes through the world's origin, so the view moves within its plane.
        height = -float(normal[:2] @ self._origin) / normal[2]
        return scene_state.moved(-np.array([*self._origin, height]))

    def ground_position(self, ground: Array) -> Array:
        """Return where the grid of the ground is drawn (3,) [m], less than a section from 0.

        Args:
            ground: Orientation of the ground, w x y z.
        """
        axes = matrix_from_wxyz(ground)[:, :2]
        along = np.linalg.lstsq(axes[:2], -self._origin, rcond=None)[0]
        return np.asarray(axes @ np.fmod(along, self._section))
