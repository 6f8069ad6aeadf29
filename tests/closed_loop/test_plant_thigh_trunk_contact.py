# SPDX-License-Identifier: BSD-3-Clause
"""How far b1's hips turn their legs under its trunk, by the shapes of its URDF."""

from __future__ import annotations

import mujoco
import pytest
import surefoot
from surefoot.sim import Plant, PlantSettings

CONTACT_MARGIN = 0.03  # [rad] beyond hip_inward that thighs meet the trunk within
CONTACT_ANGLES = [
    0.1 * k for k in range(-4, 6)
]  # [rad] angles at which they do, of fore and hind thighs
ALL_THIGH_ANGLES = [0.1 * k for k in range(-10, 36)]  # [rad] their whole range


def touches_trunk(plant: Plant, leg: str, hip: float, thigh: float) -> bool:
    """Say whether the leg's thigh meets the trunk in a pose, high above the ground."""
    model, data = plant.model, plant.data
    plant.reset()
    data.qpos[2] += 1.0
    for joint, angle in (("hip", hip), ("thigh", thigh)):
        data.qpos[model.joint(f"{leg}_{joint}_joint").qposadr[0]] = angle
    mujoco.mj_forward(model, data)
    pair = {model.body(f"{leg}_thigh").id, model.body("trunk").id}
    return any({*model.geom_bodyid[contact.geom]} == pair for contact in data.contact)


@pytest.mark.parametrize("leg", ["FR", "FL", "RR", "RL"])
def test_thighs_touch_the_trunk_only_beyond_hip_inward(leg: str) -> None:
    plant = Plant("b1", PlantSettings())
    sign = 1.0 if leg[1] == "R" else -1.0
    inward = surefoot.load_robot("b1").config.hip_inward
    assert not any(touches_trunk(plant, leg, sign * inward, thigh) for thigh in ALL_THIGH_ANGLES)
    assert all(
        touches_trunk(plant, leg, sign * (inward + CONTACT_MARGIN), thigh)
        for thigh in CONTACT_ANGLES
    )
