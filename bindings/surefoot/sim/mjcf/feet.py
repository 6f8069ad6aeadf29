"""Finds the feet of a compiled model: in each leg the geom that touches the ground."""

from __future__ import annotations

import re
from dataclasses import dataclass

import mujoco
import numpy as np

from surefoot._core import Error
from surefoot.geometry.rotations import Array
from surefoot.sim.mjcf.ground import Ground, collides
from surefoot.sim.mjcf.names import body_name, geom_name
from surefoot.sim.mjcf.tree import Tree

# Share of a foot's radius by which the feet may differ. Chosen: above the rounding of any file.
_RADIUS_TOLERANCE = 0.01
# Smallest difference of the distances from the knee to the two ends of a capsule, as a share of its
# length. Chosen: 1 along the calf, 0 across it, a half at 60 degrees.
_MIN_CAPSULE_ALIGNMENT = 0.5
_SPHERE, _CAPSULE = int(mujoco.mjtGeom.mjGEOM_SPHERE), int(mujoco.mjtGeom.mjGEOM_CAPSULE)


@dataclass(frozen=True)
class Foot:
    """A foot.

    Attributes:
        geom: Id of the geom that touches the ground: a sphere, or a capsule with a spherical end.
        body: Id of its body.
        centre: (3,) centre of the sphere, or of the capsule's lower end, in the body's frame [m].
        radius: Radius of the sphere or capsule [m].
        named: Whether the name of geom or body says that it is a foot.
    """

    geom: int
    body: int
    centre: Array
    radius: float
    named: bool


def find_feet(model: mujoco.MjModel, tree: Tree, ground: Ground) -> tuple[Foot, ...]:
    """Find the feet FR FL RR RL.

    The foot is the geom that reaches farthest from the calf joint, of the geoms of the calf and of
    the bodies fixed to it that collide. If geoms with "foot" in their name or their body's name are
    among them, it is one of these.

    Raises:
        Error: A leg has no such geom, it is neither a sphere nor a capsule along the calf, it
            does not collide with the ground, or the radii differ.
    """
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    feet = tuple(_find_foot(model, data, leg[2]) for leg in tree.legs)
    for foot in feet:
        _check_collision(model, foot.geom, ground)
        if abs(foot.radius - feet[0].radius) > _RADIUS_TOLERANCE * feet[0].radius:
            raise Error(
                f"geom '{geom_name(model, foot.geom)}': got a foot radius of {foot.radius:g} m, "
                f"expected that of the other feet, {feet[0].radius:g} m"
            )
    return feet


def _find_foot(model: mujoco.MjModel, data: mujoco.MjData, calf_joint: int) -> Foot:
    calf = int(model.jnt_bodyid[calf_joint])
    geoms = [
        geom
        for geom in range(model.ngeom)
        if model.body_weldid[model.geom_bodyid[geom]] == calf and collides(model, geom)
    ]
    if not geoms:
        raise Error(
            f"body '{body_name(model, calf)}': got no geom that collides, expected a foot; add a "
            "sphere at its end"
        )
    named = [geom for geom in geoms if _is_named_foot(model, geom)]
    knee = data.xanchor[calf_joint]
    reach = {
        geom: float(np.linalg.norm(data.geom_xpos[geom] - knee) + model.geom_rbound[geom])
        for geom in named or geoms
    }
    geom = max(reach, key=lambda one: reach[one])
    body, kind = int(model.geom_bodyid[geom]), int(model.geom_type[geom])
    if kind not in (_SPHERE, _CAPSULE):
        shape = mujoco.mjtGeom(kind).name.removeprefix("mjGEOM_").lower()
        raise Error(
            f"geom '{geom_name(model, geom)}' of body '{body_name(model, body)}': got a {shape} as "
            "foot, expected a sphere or a capsule along the calf; replace it by a sphere"
        )
    centre = data.geom_xpos[geom].copy()
    if kind == _CAPSULE:
        half = model.geom_size[geom, 1] * data.geom_xmat[geom].reshape(3, 3)[:, 2]
        ends = sorted((centre - half, centre + half), key=lambda end: np.linalg.norm(end - knee))
        near, far = (float(np.linalg.norm(end - knee)) for end in ends)
        if far - near < _MIN_CAPSULE_ALIGNMENT * 2.0 * float(np.linalg.norm(half)):
            raise Error(
                f"geom '{geom_name(model, geom)}' of body '{body_name(model, body)}': got a "
                "capsule across the leg as foot, expected a sphere or a capsule along the calf; "
                "replace it by a sphere"
            )
        centre = ends[1]
    local = data.xmat[body].reshape(3, 3).T @ (centre - data.xpos[body])
    return Foot(geom, body, local, float(model.geom_size[geom, 0]), bool(named))


def _is_named_foot(model: mujoco.MjModel, geom: int) -> bool:
    names = (model.geom(geom).name, model.body(int(model.geom_bodyid[geom])).name)
    return any(re.search("foot|toe", name, re.IGNORECASE) for name in names)


def _check_collision(model: mujoco.MjModel, foot: int, ground: Ground) -> None:
    """Raise Error unless a foot collides with the plane, or with one that is added."""
    contype, conaffinity, plane = 1, 1, ground.plane
    if plane is not None:
        contype, conaffinity = int(model.geom_contype[plane]), int(model.geom_conaffinity[plane])
    pairs = {frozenset(p) for p in zip(model.pair_geom1, model.pair_geom2, strict=True)}
    by_bits = (model.geom_contype[foot] & conaffinity) | (contype & model.geom_conaffinity[foot])
    if not by_bits and (plane is None or frozenset((foot, plane)) not in pairs):
        name = "a plane with contype 1" if plane is None else f"geom '{geom_name(model, plane)}'"
        raise Error(
            f"geom '{geom_name(model, foot)}': got a foot that does not collide with {name}, "
            "expected matching contype and conaffinity"
        )
