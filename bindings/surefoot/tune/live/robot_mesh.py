"""Triangle meshes of a robot's bodies, from its MuJoCo model with visuals."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from surefoot.geometry.rotations import Array
from surefoot.sim.model.collada import Faces
from surefoot.sim.model.visuals import HIDDEN_GROUP

Colour = tuple[int, int, int]


@dataclass(frozen=True)
class BodyMesh:
    """Mesh of one colour, fixed to one body.

    Attributes:
        body: Index of the body in the MuJoCo model.
        vertices: Vertices (n, 3) in the body's frame [m].
        faces: Vertex indices of the triangles (k, 3).
        colour: Red, green, blue, 0 .. 255.
    """

    body: int
    vertices: Array
    faces: Faces
    colour: Colour


def body_meshes(model: mujoco.MjModel) -> list[BodyMesh]:
    """Return the meshes of all visible geoms of a model, without the ground.

    Bodies that are welded together share one frame, so that fewer poses are sent to the browser.
    """
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    found: dict[tuple[int, Colour], list[tuple[Array, Faces]]] = {}
    for geom in range(model.ngeom):
        owner = int(model.body_weldid[model.geom_bodyid[geom]])
        if owner == 0 or model.geom_group[geom] == HIDDEN_GROUP:
            continue
        vertices, faces = _geom_mesh(model, geom)
        world = vertices @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]
        local = (world - data.xpos[owner]) @ data.xmat[owner].reshape(3, 3)
        red, green, blue = (round(255 * float(c)) for c in model.geom_rgba[geom][:3])
        found.setdefault((owner, (red, green, blue)), []).append((local, faces))
    return [
        BodyMesh(body, *_merge_meshes(shapes), colour)
        for (body, colour), shapes in sorted(found.items())
    ]


def _geom_mesh(model: mujoco.MjModel, geom: int) -> tuple[Array, Faces]:
    """Return the triangles of a geom in the geom's frame."""
    kind, size = int(model.geom_type[geom]), model.geom_size[geom]
    if kind == mujoco.mjtGeom.mjGEOM_MESH:
        mesh = int(model.geom_dataid[geom])
        first, count = int(model.mesh_vertadr[mesh]), int(model.mesh_vertnum[mesh])
        # Index of the first triangle, and number of triangles:
        start, faces = int(model.mesh_faceadr[mesh]), int(model.mesh_facenum[mesh])
        vertices = np.array(model.mesh_vert[first : first + count], dtype=float)
        triangles = np.array(model.mesh_face[start : start + faces], dtype=np.int64)
        return vertices, triangles
    if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
        return _sphere(float(size[0]))
    return _box(size)


def _merge_meshes(shapes: list[tuple[Array, Faces]]) -> tuple[Array, Faces]:
    vertices, faces, count = [], [], 0
    for points, triangles in shapes:
        vertices.append(points)
        faces.append(triangles + count)
        count += len(points)
    return np.concatenate(vertices), np.concatenate(faces)


def _sphere(radius: float, rings: int = 8, sectors: int = 12) -> tuple[Array, Faces]:
    """Return vertices and faces of a sphere, as a latitude-longitude grid.

    Each pole has `sectors` equal vertices.
    """
    polar = np.linspace(0.0, np.pi, rings + 1)[:, None]
    around = np.linspace(0.0, 2.0 * np.pi, sectors, endpoint=False)[None, :]
    grid = [np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around)]
    vertices = np.stack([*grid, np.broadcast_to(np.cos(polar), grid[0].shape)], axis=-1)
    i, j = np.meshgrid(np.arange(rings), np.arange(sectors), indexing="ij")
    a, b = i * sectors + j, i * sectors + (j + 1) % sectors
    c, d = a + sectors, b + sectors
    faces = np.stack([np.stack([a, c, d], axis=-1), np.stack([a, d, b], axis=-1)])
    return radius * vertices.reshape(-1, 3), faces.reshape(-1, 3)


def _box(size: Array) -> tuple[Array, Faces]:
    """Return vertices and faces of a box with half sizes (3,) [m].

    Primitives other than spheres are also drawn as boxes.
    """
    half = np.where(size > 0.0, size, size[size > 0.0].min())
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * half
    # Two triangles per side, counter-clockwise seen from outside; corner index 4 x + 2 y + z.
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [face for a, b, c, d in sides for face in ((a, b, c), (a, c, d))]
    return corners, np.array(faces, dtype=np.int64)
