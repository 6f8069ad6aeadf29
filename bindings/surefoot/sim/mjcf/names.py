"""Names of a compiled model's elements, for messages and tables."""

from __future__ import annotations

import mujoco


def element_name(model: mujoco.MjModel, kind: mujoco.mjtObj, index: int) -> str:
    """Return the name of an element, or words for an element without a name."""
    name: str | None = mujoco.mj_id2name(model, kind, index)
    return name or f"number {index} of the file, without a name"


def joint_name(model: mujoco.MjModel, joint: int) -> str:
    """Return the name of a joint as element_name() does."""
    return element_name(model, mujoco.mjtObj.mjOBJ_JOINT, joint)


def body_name(model: mujoco.MjModel, body: int) -> str:
    """Return the name of a body as element_name() does."""
    return element_name(model, mujoco.mjtObj.mjOBJ_BODY, body)


def geom_name(model: mujoco.MjModel, geom: int) -> str:
    """Return the name of a geom as element_name() does."""
    return element_name(model, mujoco.mjtObj.mjOBJ_GEOM, geom)
