"""Loads a URDF as a MuJoCo robot with a free base, and corrects parts that MuJoCo cannot read."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from surefoot._core import Error
from surefoot.robot.loading import RobotDescription


def load_urdf(description: RobotDescription) -> mujoco.MjSpec:
    """Read the URDF, add a free joint to its base; raise Error if the URDF or a mesh is missing."""
    if not description.urdf.is_file():
        raise Error(f"URDF not found: got '{description.urdf}', expected a file")
    spec = mujoco.MjSpec.from_file(str(description.urdf))
    # Fixed links stay separate bodies, because feet and IMU are fixed links.
    spec.compiler.fusestatic = False
    for mesh in spec.meshes:
        mesh.file = str(find_mesh(mesh.file, description.mesh_root))
    for body in spec.bodies:
        _repair_inertia(body)
    root_body(spec).add_freejoint(name="surefoot_base")
    return spec


def root_body(spec: mujoco.MjSpec) -> mujoco.MjsBody:
    """Return the robot's base: the first body of the world."""
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


def _repair_inertia(body: mujoco.MjsBody) -> None:
    # The massless base link of go1 and b1 has all six inertia entries 1e-6. This is not positive
    # definite: Pinocchio accepts it, MuJoCo rejects it. The diagonal alone is valid.
    xx, yy, zz, xy, xz, yz = body.fullinertia
    if np.isnan(xx):
        return
    moments = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if moments[0] <= 1e-12:  # [kg.m^2] numerical: far below the moments of any link
        body.fullinertia = [xx, yy, zz, 0.0, 0.0, 0.0]
