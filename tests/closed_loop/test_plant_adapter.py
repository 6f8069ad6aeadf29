# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import mujoco
import numpy as np
import pinocchio
import pytest
from plant_helpers import ROBOTS
from surefoot.geometry.rotations import (
    matrix_from_wxyz,
    rpy_from_wxyz,
    slope_quaternion,
    wxyz_from_rotation_vector,
)
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.pinocchio_adapter import PinocchioAdapter


@pytest.fixture(params=ROBOTS)
def pair(request: pytest.FixtureRequest) -> tuple[Plant, pinocchio.Model, PinocchioAdapter]:
    plant = Plant(request.param, PlantSettings(sensors="ideal"))
    model = pinocchio.Model()
    model.loadFromString(plant.robot.serialized_model())
    return plant, model, PinocchioAdapter(plant.model, model)


def random_state(model: pinocchio.Model) -> tuple[np.ndarray, np.ndarray]:
    pinocchio.seed(3)
    q = pinocchio.randomConfiguration(model, -np.ones(model.nq), np.ones(model.nq))
    return q, np.random.default_rng(3).normal(size=model.nv)


def test_q_and_v_survive_the_round_trip(
    pair: tuple[Plant, pinocchio.Model, PinocchioAdapter],
) -> None:
    _, model, adapter = pair
    q, v = random_state(model)
    qpos, qvel = adapter.qpos_from_pinocchio(q), adapter.qvel_from_pinocchio(q, v)
    np.testing.assert_array_equal(adapter.q_from_mujoco(qpos), q)
    np.testing.assert_allclose(adapter.v_from_mujoco(qpos, qvel), v, atol=1e-14)


def test_foot_positions_and_velocities_match_pinocchio(
    pair: tuple[Plant, pinocchio.Model, PinocchioAdapter],
) -> None:
    plant, model, adapter = pair
    q, v = random_state(model)
    mj_data, data = mujoco.MjData(plant.model), model.createData()
    mj_data.qpos[:] = adapter.qpos_from_pinocchio(q)
    mj_data.qvel[:] = adapter.qvel_from_pinocchio(q, v)
    mujoco.mj_forward(plant.model, mj_data)
    pinocchio.forwardKinematics(model, data, q, v)
    pinocchio.updateFramePlacements(model, data)
    world = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
    for body, frame in zip(plant.handles.foot_bodies, plant.robot.foot_frame_ids, strict=True):
        np.testing.assert_allclose(mj_data.xpos[body], data.oMf[frame].translation, atol=1e-12)
        jacobian = np.zeros((3, plant.model.nv))
        mujoco.mj_jacBody(plant.model, mj_data, jacobian, None, body)
        velocity = pinocchio.getFrameVelocity(model, data, frame, world).linear
        np.testing.assert_allclose(jacobian @ mj_data.qvel, velocity, atol=1e-12)


def test_truth_joints_use_the_pinocchio_order(
    pair: tuple[Plant, pinocchio.Model, PinocchioAdapter],
) -> None:
    plant, _, _ = pair
    truth = plant.truth
    standing = truth.q[list(plant.robot.motor_to_q)]
    np.testing.assert_allclose(standing, plant.data.qpos[plant.handles.motor_q])
    np.testing.assert_allclose(truth.v[list(plant.robot.motor_to_v)], truth.dq)


def test_quaternions_follow_the_right_hand_rule() -> None:
    quarter_turn = wxyz_from_rotation_vector([0.0, 0.0, np.pi / 2])
    np.testing.assert_allclose(matrix_from_wxyz(quarter_turn) @ [1, 0, 0], [0, 1, 0], atol=1e-15)
    matrix = np.zeros(9)
    quaternion = wxyz_from_rotation_vector([0.3, -0.7, 1.1])
    mujoco.mju_quat2Mat(matrix, quaternion)
    np.testing.assert_allclose(matrix_from_wxyz(quaternion), matrix.reshape(3, 3), atol=1e-15)


def test_roll_pitch_yaw_match_pinocchio() -> None:
    quaternion = wxyz_from_rotation_vector([0.3, -0.7, 1.1])
    expected = pinocchio.rpy.matrixToRpy(matrix_from_wxyz(quaternion))
    np.testing.assert_allclose(rpy_from_wxyz(quaternion), expected, atol=1e-12)


def test_the_ground_rises_towards_its_heading() -> None:
    plane = matrix_from_wxyz(slope_quaternion(10.0, 30.0))
    uphill = np.array([np.cos(np.radians(30.0)), np.sin(np.radians(30.0)), 0.0])
    assert plane[:, 2] @ uphill == pytest.approx(-np.sin(np.radians(10.0)))
    assert plane[2, 2] == pytest.approx(np.cos(np.radians(10.0)))
