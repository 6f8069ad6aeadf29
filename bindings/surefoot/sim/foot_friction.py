"""Friction between feet and ground, from the contacts of a standing robot."""

from __future__ import annotations

import math

import mujoco

from surefoot.sim.model.mujoco_handles import Handles


def foot_friction(data: mujoco.MjData, handles: Handles) -> float:
    """Return the smallest sliding friction coefficient of the feet on the ground.

    MuJoCo derives it from both geoms or from a contact pair, so it is read from the contacts.

    Args:
        data: MuJoCo's state, of a robot that stands.
        handles: Indices into the model.

    Returns:
        The coefficient; 0 for contacts of condim 1; NaN if no foot touches the ground.
    """
    ground, feet = {*handles.ground_geoms, *handles.terrain_geoms}, set(handles.foot_geoms.tolist())
    values = [
        0.0 if contact.dim == 1 else float(min(contact.friction[:2]))
        for contact in data.contact
        if ground & set(contact.geom.tolist()) and feet & set(contact.geom.tolist())
    ]
    return min(values, default=math.nan)
