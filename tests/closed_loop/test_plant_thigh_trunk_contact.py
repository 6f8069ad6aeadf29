# SPDX-License-Identifier: BSD-3-Clause
"""Contact of b1's thighs with its trunk at inward hip angles, by its URDF's shapes."""

from __future__ import annotations

import mujoco
import pytest
import surefoot
from surefoot.sim import Plant, PlantSettings

pytestmark = pytest.mark.slow

CONTACT_MARGIN = 0.03  # [rad] beyond hip_inward at which the thighs touch the trunk
CONTACT_ANGLES = [
    0.1 * k for k in range(-4, 6)
]  # [rad] thigh angles at which front and rear thighs touch it
ALL_THIGH_ANGLES = [0.1 * k for k in range(-10, 36)]  # [rad] range of the thighs


def touches_trunk(plant: Plant, leg: str, hip: float, thigh: float) -> bool:
    """Return whether the leg's thigh touches the trunk in a pose, high above the ground."""
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
