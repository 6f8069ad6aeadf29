"""Pinned standing pose of a plant, from MuJoCo instead of the controller's model."""

from __future__ import annotations

import mujoco
import numpy as np

from surefoot.assess.stance_model import UP, StanceModel
from surefoot.sim import Plant


def plant_stance(plant: Plant) -> StanceModel:
    """Compute the stance model with the masses, the feet and the kinematics of a plant."""
    model, handles, config = plant.model, plant.handles, plant.robot.config
    data = mujoco.MjData(model)
    data.qpos[:7] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
    data.qpos[handles.joint_q] = data.qpos[handles.motor_q] = config.q_standing
    mujoco.mj_forward(model, data)
    contacts = data.xpos[handles.foot_bodies] - handles.foot_radius * UP
    jacobians = np.zeros((4, 3, 12))
    for leg, body in enumerate(handles.foot_bodies):
        J = np.zeros((3, model.nv))
        mujoco.mj_jac(model, data, J, None, contacts[leg], int(body))
        jacobians[leg] = J[:, handles.joint_v]
    ground = float(contacts[:, 2].min())
    return StanceModel(
        mass=float(model.body_subtreemass[handles.root]),
        com=data.subtree_com[handles.root] - ground * UP,
        contacts=contacts - ground * UP,
        jacobians=jacobians,
        gravity_torque=data.qfrc_bias[handles.joint_v].copy(),
        torque_limit=np.array(config.tau_max),
    )
