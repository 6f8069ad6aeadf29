"""Halving the physics step changes no peak of a run by more than 5 %."""

from __future__ import annotations

import numpy as np
import pytest
import surefoot
from surefoot.sim import Plant, PlantSettings, Push

pytestmark = pytest.mark.slow


def _peaks(robot: str, physics_dt: float) -> np.ndarray:
    """Return the largest sway [m], torque [N.m] and foot load [N] of a pushed robot.

    Loads are averaged over 10 ms, because a foot that lands again causes a spike of 1 ms.
    """
    plant = Plant(robot, PlantSettings(sensors="ideal", foot_force="est", physics_dt=physics_dt))
    plant.add_push(Push("lateral", 0.5 * plant.lip_push_limit("lateral"), 0.1, 0.2))
    controller = surefoot.StandController(plant.robot)
    state, start = plant.reset(), plant.truth.com
    peaks, recent = np.zeros(3), np.zeros((5, 4))
    for _ in range(500):
        state = plant.step(controller.update(state))
        truth = plant.truth
        recent = np.vstack([recent[1:], truth.foot_forces[2]])
        sway, torque = np.linalg.norm(truth.com - start), np.abs(truth.tau).max()
        now = (sway, torque, recent.mean(axis=0).max())
        peaks = np.maximum(peaks, now)
    return peaks


@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_half_the_physics_step_changes_a_pushed_stand_below_5_percent(robot: str) -> None:
    np.testing.assert_allclose(_peaks(robot, 0.00025), _peaks(robot, 0.0005), rtol=0.05)
