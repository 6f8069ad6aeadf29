"""Reads an MJCF file, and refuses elements that the plant cannot simulate."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import mujoco
import numpy as np

from surefoot._core import Error
from surefoot.robot.xml_file import read_xml
from surefoot.sim.model.urdf import one_line

GRAVITY = (0.0, 0.0, -9.81)  # [m/s^2] of the controller's model
# [m/s^2] Chosen: accepts 9.80665 and 9.8. A larger error would look like a wrong accelerometer.
_GRAVITY_TOLERANCE = 0.05
_NEEDED = {
    "contact": mujoco.mjtDisableBit.mjDSBL_CONTACT,
    "constraint": mujoco.mjtDisableBit.mjDSBL_CONSTRAINT,
    "gravity": mujoco.mjtDisableBit.mjDSBL_GRAVITY,
    "damper": mujoco.mjtDisableBit.mjDSBL_DAMPER,
    "spring": mujoco.mjtDisableBit.mjDSBL_SPRING,
    "frictionloss": mujoco.mjtDisableBit.mjDSBL_FRICTIONLOSS,
    "limit": mujoco.mjtDisableBit.mjDSBL_LIMIT,
}


def read_mjcf(path: Path) -> tuple[mujoco.MjSpec, mujoco.MjModel]:
    """Read an MJCF file with its includes and meshes, whose paths are relative to the file.

    Returns:
        The specification, and its compiled model. Elements of both have the same ids.

    Raises:
        Error: The file, an include or a mesh is missing or invalid, or an element is not supported;
            the message names the element.
    """
    read_xml(path, "MJCF", "mujoco")
    try:
        spec = mujoco.MjSpec.from_file(str(path.absolute()))
        _check_elements(spec)
        spec.compiler.discardvisual = spec.compiler.fusestatic = False  # keep all ids and bodies
        spec.compiler.alignfree = False  # the base's frame is that of the file
        return spec, spec.compile()
    except ValueError as problem:
        raise Error(
            f"MJCF '{path}': MuJoCo rejects it: {one_line(problem)}; expected includes "
            "and meshes relative to the file"
        ) from None
    except Error as problem:
        raise Error(f"MJCF '{path}': {problem}") from None


def _check_elements(spec: mujoco.MjSpec) -> None:
    for kind, name in _unsupported(spec):
        raise Error(
            f"{kind} '{name}': got a {kind}, expected none, because the controller's robot is a "
            "tree of twelve joints; remove it"
        )
    for name, bit in _NEEDED.items():
        if spec.option.disableflags & int(bit):
            raise Error(f"flag '{name}': got disable, expected enable; remove it from <flag>")
    gravity = np.array(spec.option.gravity)
    if not np.abs(gravity - GRAVITY).max() <= _GRAVITY_TOLERANCE:
        raise Error(
            f"option gravity: got {' '.join(f'{g:g}' for g in gravity)}, expected 0 0 -9.81; "
            "remove the attribute"
        )


def _unsupported(spec: mujoco.MjSpec) -> Iterator[tuple[str, str]]:
    """Yield kind and name of the elements that the plant cannot simulate."""
    active = [equality for equality in spec.equalities if equality.active]
    kinds = (("tendon", spec.tendons), ("equality constraint", active), ("flex", spec.flexes))
    for kind, elements in kinds:
        for k, element in enumerate(elements):
            yield kind, element.name or f"number {k + 1}, without a name"
