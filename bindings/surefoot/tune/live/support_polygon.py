"""Polygon of the loaded feet and projected centre of mass in the 3D scene."""

from __future__ import annotations

import numpy as np
import viser

from surefoot.geometry.rotations import Array, matrix_from_wxyz
from surefoot.tune.live.scene_state import SceneState

BLUE = (40, 110, 220)
# Chosen for the page: below what a person sees.
_GROUND_OFFSET = 0.002  # [m] height above the ground, so that the ground does not cover it
_MIN_DISPLACEMENT = 5e-4  # [m] smallest displacement of a corner that is redrawn


class SupportPolygon:
    """Drawing of the polygon of the loaded feet, and of a dot below the centre of mass.

    The controller's class of this name contains the stance feet, loaded or not.

    Args:
        server: The server.
        size: Length scale of the drawing [m] (see Scene).
    """

    def __init__(self, server: viser.ViserServer, size: float) -> None:
        self._server, self._size = server, size
        self._corners = np.zeros((0, 3))
        self._dot = server.scene.add_icosphere("/support/com", 0.025 * size, color=BLUE)

    def show(self, scene_state: SceneState) -> None:
        """Draw the polygon and the dot for a state."""
        corners, normal = (
            scene_state.contact_points[scene_state.contact],
            matrix_from_wxyz(scene_state.ground)[:, 2],
        )
        if len(corners) > 2:
            corners = sort_counter_clockwise(corners)
        if (
            corners.shape != self._corners.shape
            or np.abs(corners - self._corners).max() > _MIN_DISPLACEMENT
        ):
            self._corners = corners
            self._draw(corners + _GROUND_OFFSET * normal)
        if len(corners):
            # Project vertically onto the plane of the ground.
            height = (scene_state.com - corners.mean(axis=0)) @ normal / normal[2]
            self._dot.position = scene_state.com - [0.0, 0.0, float(height)]

    def _draw(self, corners: Array) -> None:
        scene, count = self._server.scene, len(corners)
        enough = count > 1
        edges = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
        scene.add_line_segments(
            "/support/edge",
            edges if enough else np.zeros((1, 2, 3)),
            np.array(BLUE, dtype=np.uint8),
            thickness=0.012 * self._size,
            visible=enough,
        )
        faces = np.array([[0, k, k + 1] for k in range(1, count - 1)], dtype=np.int64)
        scene.add_mesh_simple(
            "/support/area",
            corners if len(faces) else np.zeros((3, 3)),
            faces if len(faces) else np.array([[0, 1, 2]]),
            color=BLUE,
            opacity=0.22,
            side="double",
            cast_shadow=False,
            visible=bool(len(faces)),
        )


def sort_counter_clockwise(corners: Array) -> Array:
    """Return corners (n, 3) in counter-clockwise order, seen from above."""
    centre = corners.mean(axis=0)
    angles = np.arctan2(corners[:, 1] - centre[1], corners[:, 0] - centre[0])
    return np.asarray(corners[np.argsort(angles)])
