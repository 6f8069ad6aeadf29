"""Adds the URDF's visual meshes to a MuJoCo model, for pictures only."""

from __future__ import annotations

import contextlib
import functools
import xml.etree.ElementTree as ET
from pathlib import Path

import mujoco
import numpy as np

from surefoot._core import Error
from surefoot.geometry.rotations import Array
from surefoot.robot.loading import RobotDescription
from surefoot.robot.urdf_numbers import read_numbers
from surefoot.robot.xml_file import read_xml
from surefoot.sim.model.collada import Faces, read_collada
from surefoot.sim.model.urdf import check_mesh, find_mesh

VISUAL_GROUP = 2  # geom group of visual meshes; MuJoCo shows groups 0 .. 2
HIDDEN_GROUP = 3  # geom group that MuJoCo does not show
# Number of cells along a mesh's diagonal when its vertices are merged. Chosen: with fewer cells,
# steps are visible. With more cells, more of the 440,000 triangles of go1 and b1 remain, which load
# slowly.
MERGE_CELLS = 250
_LINK_COLOURS = {  # key: a part of the link's name
    "hip": (0.20, 0.21, 0.23, 1.0),
    "thigh": (0.55, 0.58, 0.62, 1.0),
    "calf": (0.16, 0.17, 0.19, 1.0),
    "foot": (0.10, 0.10, 0.11, 1.0),
    "camera": (0.08, 0.08, 0.09, 1.0),
    "ultraSound": (0.08, 0.08, 0.09, 1.0),
}
_TRUNK_COLOUR = (0.72, 0.74, 0.77, 1.0)


def add_visuals(spec: mujoco.MjSpec, description: RobotDescription) -> None:
    """Add all visual meshes of the URDF, and hide the collision geometry of legs and trunk.

    Meshes that are missing or cannot be read are skipped. If none is left, the collision geometry
    stays visible.
    """
    spec.compiler.discardvisual = False
    added = 0
    for link in read_xml(description.urdf, "URDF").iter("link"):
        for visual in link.findall("visual"):
            with contextlib.suppress(Error):
                added += _add_visual(spec, link.get("name", ""), visual, description.mesh_root)
    if added:
        _hide_collisions(spec)


def _add_visual(spec: mujoco.MjSpec, link: str, visual: ET.Element, mesh_root: Path) -> bool:
    mesh = visual.find("geometry/mesh")
    body = spec.body(link)
    if mesh is None or body is None:
        return False
    path = find_mesh(mesh.get("filename", ""), mesh_root)
    scale = _numbers(mesh, "scale", 1.0)
    origin = visual.find("origin")
    position, rpy = _numbers(origin, "xyz", 0.0), _numbers(origin, "rpy", 0.0)
    name = f"visual {path} {scale}"
    if name not in {mesh_spec.name for mesh_spec in spec.meshes}:
        _add_mesh(spec, name, path, scale)
    body.add_geom(
        type=mujoco.mjtGeom.mjGEOM_MESH,
        meshname=name,
        pos=position,
        quat=_quaternion(rpy),
        contype=0,
        conaffinity=0,
        group=VISUAL_GROUP,
        density=0.0,
        rgba=_link_colour(link),
    )
    return True


def _add_mesh(spec: mujoco.MjSpec, name: str, path: Path, scale: list[float]) -> None:
    collada = path.suffix.lower() == ".dae"
    if collada:
        vertices, faces = load_mesh(path)
    else:
        check_mesh(path)
    mesh = spec.add_mesh(name=name, scale=scale)
    # A visual mesh may be open and then has no volume.
    mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
    if collada:
        mesh.uservert, mesh.userface = vertices.ravel(), faces.ravel()
    else:
        mesh.file = str(path)


@functools.cache
def load_mesh(path: Path) -> tuple[Array, Faces]:
    """Return vertices (n, 3) and faces (k, 3) of a .dae file; close vertices are merged. Cached.

    Raises:
        Error: The file cannot be read.
    """
    try:
        return merge_vertices(*read_collada(path))
    except (ET.ParseError, ValueError, LookupError, OSError) as problem:
        raise Error(f"mesh: cannot read '{path}': {problem}") from None


def merge_vertices(vertices: Array, faces: Faces) -> tuple[Array, Faces]:
    """Replace the vertices in each cell of a fine grid by their mean, and drop degenerate faces."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    cell = max(float(np.linalg.norm(high - low)) / MERGE_CELLS, 1e-9)
    keys = np.round((vertices - low) / cell).astype(np.int64)
    _, new_index, count = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
    new_index = new_index.ravel()
    merged = np.zeros((len(count), 3))
    np.add.at(merged, new_index, vertices)
    merged /= count[:, None]
    faces = new_index[faces]
    a, b, c = faces.T
    faces = faces[(a != b) & (b != c) & (a != c)]
    # Remove duplicate triangles, because they flicker. Triangles of opposite orientation stay: thin
    # walls need both.
    corners = (np.argmin(faces, axis=1)[:, None] + np.arange(3)) % 3
    rotated = np.take_along_axis(faces, corners, axis=1)
    return merged, np.unique(rotated, axis=0)


def _hide_collisions(spec: mujoco.MjSpec) -> None:
    for geom in spec.geoms:
        if "_collision_" in geom.name:
            geom.group = HIDDEN_GROUP
        elif geom.priority == 1:  # feet: show the sphere that touches the ground
            geom.rgba = _LINK_COLOURS["foot"]


def _link_colour(link: str) -> tuple[float, float, float, float]:
    return next((colour for part, colour in _LINK_COLOURS.items() if part in link), _TRUNK_COLOUR)


def _numbers(element: ET.Element | None, name: str, default: float) -> list[float]:
    if element is None or name not in element.attrib:
        return [default] * 3
    return read_numbers(element, name, 3, "<visual>")


def _quaternion(rpy: list[float]) -> Array:
    quaternion = np.zeros(4)
    mujoco.mju_euler2Quat(quaternion, np.array(rpy), "XYZ")  # URDF: fixed axes x, y, z
    return quaternion
