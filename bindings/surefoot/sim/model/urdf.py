"""A URDF as a floating MuJoCo robot: what MuJoCo cannot read in it is put right."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from surefoot._core import Error
from surefoot.robot.loading import RobotDescription


def load_urdf(description: RobotDescription) -> mujoco.MjSpec:
    """Read the URDF and set its base free; raises Error if it or a mesh is missing."""
    if not description.urdf.is_file():
        raise Error(f"URDF not found: got '{description.urdf}', expected a file")
    spec = mujoco.MjSpec.from_file(str(description.urdf))
    # Fixed links stay bodies of their own: feet and IMU are among them.
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
    """Find the file of a ``package://`` or relative mesh path; raises Error."""
    if Path(name).is_absolute():
        return Path(name)
    parts = Path(name.removeprefix("package://")).parts
    for folder in (mesh_root, *mesh_root.parents):
        # The first part names the package; its folder may or may not carry that name.
        for candidate in (folder.joinpath(*parts[1:]), folder.joinpath(*parts)):
            if candidate.is_file():
                return candidate
    raise Error(f"mesh not found: got '{name}', expected a file below '{mesh_root}'")


def _repair_inertia(body: mujoco.MjsBody) -> None:
    # go1's and b1's massless base link has all six entries 1e-6: not positive definite, which
    # Pinocchio never notices and MuJoCo refuses. The diagonal alone is valid.
    xx, yy, zz, xy, xz, yz = body.fullinertia
    if np.isnan(xx):
        return
    moments = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if moments[0] <= 1e-12:
        body.fullinertia = [xx, yy, zz, 0.0, 0.0, 0.0]
