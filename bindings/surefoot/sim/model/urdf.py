"""Loads a URDF as a MuJoCo robot with a free base, and corrects parts that MuJoCo cannot read."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from surefoot._core import Error
from surefoot.robot.loading import RobotDescription
from surefoot.robot.urdf import read_urdf

MESH_SUFFIXES = (".stl", ".obj", ".msh")  # formats that MuJoCo reads


def load_urdf(description: RobotDescription) -> mujoco.MjSpec:
    """Read the URDF and add a free joint to its base.

    Raises:
        Error: The URDF or a mesh is missing or invalid.
    """
    urdf = read_urdf(description.urdf, description.table)
    try:
        spec = mujoco.MjSpec.from_string(urdf.text)
    except ValueError as problem:
        raise Error(f"URDF '{description.urdf}': MuJoCo rejects it: {one_line(problem)}") from None
    # Fixed links stay separate bodies, because feet and IMU are fixed links.
    spec.compiler.fusestatic = False
    for mesh in spec.meshes:
        path = find_mesh(mesh.file, description.mesh_root)
        check_mesh(path)
        mesh.file = str(path)
    for body in spec.bodies:
        _set_inertia(body)
    root_body(spec).add_freejoint(name="surefoot_base")
    return spec


def one_line(problem: Exception) -> str:
    """Return the text of MuJoCo's error in one line."""
    return "; ".join(line.strip() for line in str(problem).splitlines() if line.strip())


def root_body(spec: mujoco.MjSpec) -> mujoco.MjsBody:
    """Return the robot's base: the body with a free joint, else the first body of the world."""
    free = mujoco.mjtJoint.mjJNT_FREE
    for body in spec.worldbody.bodies:
        if any(joint.type == free for joint in body.joints):
            return body
    return spec.worldbody.first_body()


def find_mesh(name: str, mesh_root: Path) -> Path:
    """Return the file of a ``package://`` or relative mesh path; raise Error if it is missing."""
    if Path(name).is_absolute():
        return Path(name)
    parts = Path(name.removeprefix("package://")).parts
    for folder in (mesh_root, *mesh_root.parents):
        # The first part is the name of the package. Its folder may have another name.
        for candidate in (folder.joinpath(*parts[1:]), folder.joinpath(*parts)):
            if candidate.is_file():
                return candidate
    raise Error(f"mesh not found: got '{name}', expected a file below '{mesh_root}'")


def check_mesh(path: Path) -> None:
    """Raise Error if MuJoCo cannot read a mesh; the message says how to make one that it can."""
    try:
        head = path.open("rb").read(512)
    except OSError as problem:
        raise Error(f"mesh: cannot read '{path}': {problem.strerror}") from None
    if head.startswith(b"version https://git-lfs"):
        raise Error(f"mesh '{path}': got a Git LFS pointer, expected a mesh; run: git lfs pull")
    if path.suffix.lower() == ".stl" and head.lstrip().startswith(b"solid") and b"facet" in head:
        raise Error(f"mesh '{path}': got an ASCII STL, expected a binary one; convert it")
    if path.suffix.lower() not in MESH_SUFFIXES:
        raise Error(
            f"mesh '{path}': got format '{path.suffix}' in a <collision>, expected "
            f"{', '.join(MESH_SUFFIXES)}; convert it, or use a box, cylinder or sphere"
        )


def _set_inertia(body: mujoco.MjsBody) -> None:
    """Give a body exactly the mass of its link, as Pinocchio does.

    MuJoCo would guess the mass of a link without <inertial> from its collision geometry, and
    rejects negligible inertias that are invalid (read_urdf() rejects all others): the base link of
    go1 and b1 has six entries 1e-6, CAD exports have 1e-27. The diagonal alone is valid.
    """
    if not body.explicitinertial:
        body.explicitinertial, body.mass, body.ipos = True, 0.0, [0.0, 0.0, 0.0]
        return
    xx, yy, zz, xy, xz, yz = body.fullinertia
    if np.isnan(xx):
        return
    moments, axes = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if max(xx, yy, zz) <= 1e-12:  # [kg.m^2] numerical: far below the moments of any link
        body.fullinertia, body.inertia = [np.nan, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    elif moments[0] <= 1e-12:
        body.fullinertia = [xx, yy, zz, 0.0, 0.0, 0.0]
    elif moments[0] + moments[1] < moments[2]:  # by rounding only
        moments[:2] *= 1.0 + 2.0 * (moments[2] / (moments[0] + moments[1]) - 1.0)
        m = axes @ np.diag(moments) @ axes.T
        body.fullinertia = [m[0, 0], m[1, 1], m[2, 2], m[0, 1], m[0, 2], m[1, 2]]
