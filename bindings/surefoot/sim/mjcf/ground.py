"""Finds the ground of a compiled model: a level plane at height 0, or none."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from surefoot._core import Error
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.sim.mjcf.names import body_name, geom_name

# Numerical: text of five digits, as MuJoCo's exporters write it.
_LEVEL_TOLERANCE = 1e-4


@dataclass(frozen=True)
class Ground:
    """Fixed geoms with which a robot can collide, as ids of the model.

    Attributes:
        plane: The level plane at height 0; None if the file has no fixed geom that collides.
        obstacles: All other fixed geoms that collide.
    """

    plane: int | None
    obstacles: tuple[int, ...]


def collides(model: mujoco.MjModel, geom: int) -> bool:
    """Return whether a geom takes part in collisions, by its bits or by a contact pair."""
    pairs = np.concatenate([model.pair_geom1, model.pair_geom2])
    return bool(model.geom_contype[geom] or model.geom_conaffinity[geom] or geom in pairs)


def find_ground(model: mujoco.MjModel) -> Ground:
    """Find the ground.

    Raises:
        Error: A fixed geom is not a geom of the worldbody; or there are fixed geoms that collide,
            but not exactly one plane among them, level and at height 0.
    """
    fixed = [
        geom
        for geom in range(model.ngeom)
        if model.body_weldid[model.geom_bodyid[geom]] == 0 and collides(model, geom)
    ]
    for geom in fixed:
        body = int(model.geom_bodyid[geom])
        if body != 0:
            raise Error(
                f"geom '{geom_name(model, geom)}': got a fixed geom of body "
                f"'{body_name(model, body)}', expected fixed geoms in the worldbody only, which "
                "the foot sensors feel; move it there"
            )
    planes = [g for g in fixed if model.geom_type[g] == mujoco.mjtGeom.mjGEOM_PLANE]
    if not fixed:
        return Ground(None, ())
    if len(planes) != 1:
        names = ", ".join(f"'{geom_name(model, geom)}'" for geom in planes or fixed)
        raise Error(
            f"ground: got {len(planes)} planes among the fixed geoms ({names}), expected one; the "
            "robot starts on it"
        )
    plane = planes[0]
    normal = matrix_from_wxyz(model.geom_quat[plane])[:, 2]
    height = float(model.geom_pos[plane] @ normal)
    if abs(height) > _LEVEL_TOLERANCE or normal[2] < 1.0 - _LEVEL_TOLERANCE:
        raise Error(
            f"geom '{geom_name(model, plane)}': got a plane through "
            f"{' '.join(f'{p:g}' for p in model.geom_pos[plane])} with normal "
            f"{' '.join(f'{n:.3g}' for n in normal)}, expected a level one at height 0; move it"
        )
    return Ground(plane, tuple(geom for geom in fixed if geom != plane))
