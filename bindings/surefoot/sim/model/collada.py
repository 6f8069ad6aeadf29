"""Reader for the triangles of a COLLADA (.dae) file, the format of most visual meshes.

MuJoCo does not read this format. Pinocchio's geometry library reads meshes of several materials
incorrectly.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import numpy.typing as npt

from surefoot.geometry.rotations import Array

Faces = npt.NDArray[np.int64]


def read_collada(path: Path) -> tuple[Array, Faces]:
    """Return vertices (n, 3) and faces (k, 3) of the whole scene, with node transforms applied.

    Materials, normals and polygons of more than three corners are ignored. up_axis is also ignored,
    as by other URDF tools.
    """
    root = ET.parse(path).getroot()
    meshes = {
        "#" + geometry.get("id", ""): _read_mesh(mesh)
        for geometry in root.iterfind("{*}library_geometries/{*}geometry")
        if (mesh := geometry.find("{*}mesh")) is not None
    }
    vertices: list[Array] = [np.zeros((0, 3))]
    faces: list[Faces] = [np.zeros((0, 3), dtype=np.int64)]
    for scene in root.iterfind("{*}library_visual_scenes/{*}visual_scene"):
        for url, transform in _mesh_instances(scene, np.eye(4)):
            if url in meshes:
                points, triangles = meshes[url]
                faces.append(triangles + sum(map(len, vertices)))
                vertices.append(points @ transform[:3, :3].T + transform[:3, 3])
    return np.concatenate(vertices), np.concatenate(faces)


def _mesh_instances(node: ET.Element, transform: Array) -> list[tuple[str, Array]]:
    found = [
        (instance.get("url", ""), transform) for instance in node.iterfind("{*}instance_geometry")
    ]
    for child in node.iterfind("{*}node"):
        local = np.eye(4)
        for matrix in child.iterfind("{*}matrix"):
            local = local @ np.array(_text(matrix).split(), dtype=float).reshape(4, 4)
        found += _mesh_instances(child, transform @ local)
    return found


def _read_mesh(mesh: ET.Element) -> tuple[Array, Faces]:
    points = mesh.find("{*}vertices/{*}input[@semantic='POSITION']")
    name = "" if points is None else points.get("source", "")[1:]
    array = mesh.find(f"{{*}}source[@id='{name}']/{{*}}float_array")
    vertices = np.fromstring(_text(array), sep=" ").reshape(-1, 3)
    faces = [np.zeros((0, 3), dtype=np.int64)]
    for triangles in mesh.iterfind("{*}triangles"):
        inputs = triangles.findall("{*}input")
        offsets = {entry.get("semantic"): int(entry.get("offset", "0")) for entry in inputs}
        indices = np.fromstring(_text(triangles.find("{*}p")), dtype=np.int64, sep=" ")
        corners = indices.reshape(-1, max(offsets.values()) + 1)[:, offsets["VERTEX"]]
        faces.append(corners.reshape(-1, 3))
    return vertices, np.concatenate(faces)


def _text(element: ET.Element | None) -> str:
    return "" if element is None else element.text or ""
