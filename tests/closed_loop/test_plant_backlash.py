# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import dataclasses
import math

import mujoco
import numpy as np
import pytest
import surefoot
from plant_helpers import ROBOTS, float_without_gravity, pd_command
from surefoot.robot.loading import describe_robot
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.sim.physics.standing_pose import HOLD_KD, HOLD_KP

BACKLASH_DEG = 1.0  # [deg]
# Without friction, lag and delay the motion has a closed form.
FRICTIONLESS = PlantSettings(sensors="ideal", backlash_deg=BACKLASH_DEG, joint_friction_scale=0.0)


def floating(settings: PlantSettings = FRICTIONLESS) -> Plant:
    """Return go1 at rest in the air, without gravity, every rotor in the middle of its backlash."""
    plant = Plant("go1", settings)
    plant.data.qpos[plant.handles.motor_q] = plant.data.qpos[plant.handles.joint_q]
    float_without_gravity(plant)
    return plant


def torque_command(tau: float) -> surefoot.LowCmd:
    cmd = surefoot.LowCmd()
    for i in range(12):
        cmd.motorCmd[i].tau = tau
    return cmd


def gap(plant: Plant) -> np.ndarray:
    """Return how far each rotor is ahead of its joint [deg]."""
    qpos, handles = plant.data.qpos, plant.handles
    return np.degrees(qpos[handles.motor_q] - qpos[handles.joint_q])


def test_zero_backlash_adds_no_coordinates() -> None:
    plant = Plant("go1", PlantSettings(backlash_deg=0.0))
    assert (plant.model.nq, plant.model.nv, plant.model.ntendon) == (19, 18, 0)
    np.testing.assert_array_equal(plant.handles.motor_q, plant.handles.joint_q)
    np.testing.assert_array_equal(plant.handles.motor_v, plant.handles.joint_v)


def test_armature_friction_and_damping_act_on_the_rotors() -> None:
    plain, loose = Plant("go1"), Plant("go1", PlantSettings(backlash_deg=BACKLASH_DEG))
    for name in ("dof_armature", "dof_frictionloss", "dof_damping"):
        values = getattr(loose.model, name)
        expected = getattr(plain.model, name)[plain.handles.joint_v]
        np.testing.assert_array_equal(values[loose.handles.motor_v], expected)
        np.testing.assert_array_equal(values[loose.handles.joint_v], 0.0)


@pytest.mark.parametrize("tau", [-0.1, 0.1])
def test_torque_within_the_backlash_moves_only_the_rotor(tau: float) -> None:
    plant = floating()
    armature = plant.model.dof_armature[plant.handles.motor_v]
    plant.step(torque_command(tau))  # moves 0.1 % of the gap: half a step does not matter
    plant.step(torque_command(tau))
    np.testing.assert_allclose(plant.data.qvel[plant.handles.motor_v], tau * 0.004 / armature)
    np.testing.assert_array_equal(plant.truth.dq, 0.0)
    assert np.abs(gap(plant)).max() < BACKLASH_DEG / 2


def test_time_to_cross_the_backlash_matches_the_rotor_inertia() -> None:
    plant, tau = floating(), 0.05
    times = np.zeros(12)
    for _ in range(60):
        still = np.abs(plant.truth.dq) < 1e-3  # impacts in other legs move it later
        plant.step(torque_command(tau))
        times[still & (np.abs(plant.truth.dq) >= 1e-3) & (times == 0.0)] = plant.time
    armature = plant.model.dof_armature[plant.handles.motor_v]
    expected = np.sqrt(2.0 * math.radians(BACKLASH_DEG / 2.0) * armature / tau)
    first = np.argsort(expected)[:8]  # hips and thighs; thighs move the calves
    np.testing.assert_allclose(times[first], expected[first] - plant.time + 0.12, atol=0.004)


def test_gear_impact_conserves_momentum_and_hardly_bounces() -> None:
    plant = floating()
    model, data, handles = plant.model, plant.data, plant.handles
    rotor, knee = handles.motor_v[2], handles.joint_v[2]
    data.qvel[rotor] = 3.0
    mujoco.mj_step1(model, data)
    before, mass = data.qvel.copy(), np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, mass)
    for _ in range(6):  # 3 ms to cross the backlash, the rest to separate
        plant.step(torque_command(0.0))
    assert 0.0 <= data.qvel[knee] - data.qvel[rotor] < 0.15 * 3.0
    # The impulse of the impact acts on rotor and knee only, with opposite signs.
    impulse = mass @ (data.qvel - before)
    assert impulse[knee] > 1e-3
    assert impulse[rotor] == pytest.approx(-impulse[knee], rel=0.02)
    others = np.delete(impulse, [rotor, knee])
    assert np.abs(others).max() < 0.1 * impulse[knee]


def test_energy_never_increases_at_gear_impacts() -> None:
    plant = floating()
    model, data = plant.model, plant.data
    data.qvel[plant.handles.motor_v] = np.random.default_rng(0).normal(0.0, 5.0, 12)
    mujoco.mj_step1(model, data)
    energies = []
    for _ in range(200):
        mass = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, mass)
        energies.append(0.5 * data.qvel @ mass @ data.qvel)
        plant.step(torque_command(0.0))
    assert (np.diff(energies) < 1e-3 * energies[0]).all()
    assert energies[-1] < 0.9 * energies[0]


def test_encoders_measure_the_rotors() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal", backlash_deg=BACKLASH_DEG))
    state = plant.step(pd_command(plant, HOLD_KP, HOLD_KD))
    data, handles = plant.data, plant.handles
    q = [state.motorState[i].q for i in range(12)]
    dq = [state.motorState[i].dq for i in range(12)]
    np.testing.assert_allclose(q, data.qpos[handles.motor_q], rtol=1e-6)
    np.testing.assert_allclose(dq, data.qvel[handles.motor_v], atol=1e-6)
    assert np.degrees(np.abs(q - data.qpos[handles.joint_q])).max() > 0.4 * BACKLASH_DEG
    np.testing.assert_array_equal(plant.truth.dq, data.qvel[handles.joint_v])


@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("play", [0.5, 5.0])
def test_loaded_gears_close_the_backlash_and_carry_the_weight(name: str, play: float) -> None:
    plant = Plant(name, PlantSettings(backlash_deg=play))
    for _ in range(200):
        plant.step(pd_command(plant, HOLD_KP, HOLD_KD))
    calves = slice(2, None, 3)
    np.testing.assert_allclose(gap(plant)[calves], play / 2.0, atol=0.01)
    assert np.abs(gap(plant)).max() < play / 2.0 + 0.02
    weight = plant.robot.mass * 9.81
    assert plant.truth.foot_forces[2].sum() == pytest.approx(weight, rel=0.01)
    assert not plant.truth.fell


def test_backlash_of_0_001_deg_equals_none() -> None:
    paths = []
    for play in (0.0, 0.001):
        plant = Plant("go1", dataclasses.replace(FRICTIONLESS, backlash_deg=play))
        float_without_gravity(plant)
        for _ in range(50):
            plant.step(torque_command(0.02))
        paths.append(plant.data.qpos[plant.handles.joint_q].copy())
    moved = np.abs(paths[0] - Plant("go1", FRICTIONLESS).robot.config.q_standing).max()
    assert moved > 0.01
    np.testing.assert_allclose(paths[1], paths[0], atol=0.02 * moved)


def test_half_the_physics_step_changes_sway_with_backlash_below_3_percent() -> None:
    peaks = []
    for physics_dt in (0.0005, 0.00025):
        plant = Plant("go1", PlantSettings(physics_dt=physics_dt, backlash_deg=BACKLASH_DEG))
        plant.add_push(Push("lateral", 0.5 * plant.lip_push_limit("lateral"), 0.1, 0.1))
        cmd, start, path = pd_command(plant), plant.truth.com, []
        for _ in range(200):
            plant.step(cmd)
            path.append(plant.truth.com - start)
        peaks.append(np.linalg.norm(path, axis=1).max())
    assert peaks[0] > 0.02
    assert peaks[0] == pytest.approx(peaks[1], rel=0.03)


def test_backlash_without_rotor_inertia_is_refused() -> None:
    with pytest.raises(surefoot.Error, match=r"backlash_deg: got 1 .* rotor inertia of 0 .*hip"):
        Plant("go1", PlantSettings(backlash_deg=1.0, armature_scale=0.0))
    go1 = describe_robot("go1")
    assert Plant(go1, PlantSettings(armature_scale=0.0)).model.dof_armature.max() == 0.0
