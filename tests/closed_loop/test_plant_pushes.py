# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import math

import mujoco
import numpy as np
import pytest
from plant_helpers import float_without_gravity, pd_command
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.sim.lip_push_limit import distance_to_edge, max_lip_impulse

IDEAL = PlantSettings(sensors="ideal", payload_kg=2.0, payload_position=(0.1, 0.03, 0.1))


def momentum_after(push: Push) -> tuple[np.ndarray, np.ndarray]:
    """Push a floating robot; return its linear momentum and its angular momentum about the CoM."""
    plant = Plant("go1", IDEAL, [push])
    float_without_gravity(plant)
    no_torque = pd_command(plant, kp=0.0, kd=0.0)
    for _ in range(100):
        plant.step(no_torque)
    mujoco.mj_subtreeVel(plant.model, plant.data)
    root = plant.handles.root
    mass = plant.model.body_subtreemass[root]
    return mass * plant.truth.com_velocity, plant.data.subtree_angmom[root].copy()


@pytest.mark.parametrize(
    ("direction", "unit"),
    [("forward", [1, 0, 0]), ("lateral", [0, 1, 0]), (-90.0, [0, -1, 0]), (180.0, [-1, 0, 0])],
)
def test_push_gives_its_linear_impulse_without_rotation(
    direction: str | float, unit: list[int]
) -> None:
    # Neither end of the pulse falls on a physics step.
    linear, angular = momentum_after(Push(direction, 5.0, duration=0.0507, time=0.0303))
    np.testing.assert_allclose(linear, 5.0 * np.array(unit), atol=5e-3)
    np.testing.assert_allclose(angular, 0.0, atol=1e-3)


def test_push_above_the_centre_of_mass_adds_its_moment() -> None:
    linear, angular = momentum_after(Push("lateral", 5.0, 0.05, 0.0, height=0.1))
    np.testing.assert_allclose(linear, [0.0, 5.0, 0.0], atol=5e-3)
    np.testing.assert_allclose(angular, [-0.5, 0.0, 0.0], atol=5e-3)


def test_push_acts_only_during_its_duration() -> None:
    plant = Plant("go1", IDEAL, [Push("lateral", 2.0, 0.02, 0.01)])
    cmd, strength = pd_command(plant), []
    for _ in range(30):
        plant.step(cmd)
        strength.append(float(np.linalg.norm(plant.push_force[0])))
    np.testing.assert_allclose(strength, [0.0] * 5 + [100.0] * 10 + [0.0] * 15, atol=1e-9)


def test_forward_push_uses_the_heading_at_its_start() -> None:
    plant = Plant("go1", IDEAL)
    plant.data.qpos[3:7] = [math.cos(0.5), 0.0, 0.0, math.sin(0.5)]  # yaw 1 rad
    plant.add_push(Push("forward", 1.0, 0.01, plant.time + 0.002))
    for _ in range(2):
        plant.step(pd_command(plant))
    force = plant.push_force[0]
    assert math.atan2(force[1], force[0]) == pytest.approx(1.0, abs=0.02)


def test_simultaneous_pushes_add_up() -> None:
    plant = Plant("go1", IDEAL, [Push("lateral", 1.0, 0.1), Push("forward", 2.0, 0.1)])
    plant.step(pd_command(plant))
    np.testing.assert_allclose(plant.push_force[0], [20.0, 10.0, 0.0], atol=0.05)


def test_lip_push_limit_matches_the_closed_formula() -> None:
    # g / h = 10, w = 3.16228: J = 10 * 3.16228 * 0.1 * 0.316228 / (1 - exp(-0.316228)).
    assert max_lip_impulse(10.0, 0.981, 0.1, 0.1) == pytest.approx(3.68859, rel=1e-5)
    assert max_lip_impulse(10.0, 0.981, 0.1, 1e-6) == pytest.approx(3.16228, rel=1e-5)


def test_edge_distance_uses_the_convex_hull_of_the_feet() -> None:
    corners = np.array([[0.2, -0.1], [0.2, 0.1], [-0.2, 0.1], [-0.2, -0.1]])
    ahead, left = np.array([1.0, 0.0]), np.array([0.0, 1.0])
    for points in (corners, corners[[2, 0, 3, 1]], np.vstack([corners, [0.15, 0.0]])):
        assert distance_to_edge(points, np.array([0.05, 0.02]), ahead) == pytest.approx(0.15)
        assert distance_to_edge(points, np.array([0.05, 0.02]), left) == pytest.approx(0.08)
    diagonal = np.array([1.0, 1.0]) / math.sqrt(2.0)
    assert distance_to_edge(corners, np.zeros(2), diagonal) == pytest.approx(0.1 * math.sqrt(2.0))
    assert distance_to_edge(corners, np.array([0.3, 0.0]), ahead) == 0.0


def test_lip_push_limit_uses_the_true_mass_and_feet() -> None:
    plant = Plant("go1", IDEAL)
    truth = plant.truth
    left = max(truth.p_world_feet[1]) - truth.com[1]
    expected = max_lip_impulse(plant.robot.mass + 2.0, truth.com[2], left, 0.2)
    assert plant.lip_push_limit("lateral", 0.2) == pytest.approx(expected, rel=0.01)
    assert plant.lip_push_limit(-90.0) > plant.lip_push_limit(
        "lateral"
    )  # the payload is on the left


def test_lip_push_limit_projects_the_feet_vertically_on_a_slope() -> None:
    uphill = Plant("go1", PlantSettings(sensors="ideal", slope_deg=10.0))
    level = Plant("go1", PlantSettings(sensors="ideal"))
    assert uphill.lip_push_limit(180.0) < 0.85 * level.lip_push_limit(180.0)
    assert uphill.lip_push_limit("forward") > 1.1 * level.lip_push_limit("forward")
