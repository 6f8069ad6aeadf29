"""Ground and payload in the 3D scene."""

from __future__ import annotations

import numpy as np
import viser

from surefoot.geometry.rotations import Array
from surefoot.tune.live.scene_state import SceneState

_ORANGE = (217, 140, 51)
GRID_SECTION = 0.5  # [m] distance of the grid's thick lines; chosen: about one robot length
_DENSITY = 1000.0  # [kg/m^3] density of the drawn payload, as in the simulation


class GroundAndPayload:
    """Drawing of ground and payload.

    Args:
        server: The server.
        base: Name of the scene node of the trunk, which carries the payload.
        size: Length scale of the drawing [m] (see Scene).
    """

    def __init__(self, server: viser.ViserServer, base: str, size: float) -> None:
        self._server, self._base = server, base
        self._ground: Array = np.array([1.0, 0.0, 0.0, 0.0])
        self._position: Array = np.zeros(3)
        self._payload_kg = 0.0
        self._grid = server.scene.add_grid(
            "/ground",
            infinite_grid=True,
            cell_size=0.1,
            section_size=GRID_SECTION,
            fade_distance=12.0 * size,
            cell_color=(214, 218, 223),
            section_color=(176, 182, 190),
            shadow_opacity=0.25,
        )
        self._payload_box = self._box(0.0)

    def show(self, scene_state: SceneState, position: Array) -> None:
        """Redraw ground and payload if they have changed; `position` is the grid's [m]."""
        if not np.array_equal(position, self._position):
            self._position = self._grid.position = position
        if not np.array_equal(scene_state.ground, self._ground):
            self._ground = self._grid.wxyz = scene_state.ground.copy()
        if scene_state.payload_kg != self._payload_kg:
            self._payload_kg = scene_state.payload_kg
            self._payload_box = self._box(scene_state.payload_kg)

    def _box(self, mass: float) -> viser.BoxHandle:
        side = max(mass / _DENSITY, 1e-6) ** (1.0 / 3.0)
        return self._server.scene.add_box(
            f"{self._base}/payload",
            color=_ORANGE,
            dimensions=(side, side, side),
            visible=mass > 0.0,
        )
