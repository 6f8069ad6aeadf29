# SPDX-License-Identifier: BSD-3-Clause
"""Where a hip's leg comes under the trunk, by the shapes of the model."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
import surefoot
from surefoot.sim import Plant, PlantSettings

MEETS = 0.03  # [rad] beyond hip_inward that b1's thighs meet its trunk within
THIGHS = np.arange(-0.4, 1.1, 0.1)  # [rad] of the hind legs' that bear, fold or trail


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
def test_b1s_thighs_stay_clear_of_its_trunk_up_to_hip_inward_and_not_much_further(leg: str) -> None:
    plant = Plant("b1", PlantSettings())
    inward = surefoot.load_robot("b1").config.hip_inward * (1.0 if leg[1] == "R" else -1.0)
    for thigh in THIGHS:
        assert not touches_trunk(plant, leg, inward, thigh)
        if thigh < 0.7:
            assert touches_trunk(plant, leg, inward + np.sign(inward) * MEETS, thigh)
