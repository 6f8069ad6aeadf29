# SPDX-License-Identifier: BSD-3-Clause
"""Moving ground, a torque scale of all motors, and a reseeded plant."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest
from plant_helpers import pd_command
from surefoot import Error, LowCmd
from surefoot.sim import Flaws, Plant, PlantSettings, Push
from surefoot.sim.model.moving_ground import BLOCK, set_ground_speed
from surefoot.sim.truth import has_fallen


def stand(plant: Plant, seconds: float, speed: float) -> None:
    hold = pd_command(plant, 20.0, 0.6)
    for _ in range(round(500 * seconds)):
        set_ground_speed(plant.model, plant.data, speed)
        plant.step(hold)


@pytest.mark.parametrize("heading", [0.0, 90.0, 200.0])
def test_platform_tilts_toward_its_heading_and_moves_the_feet(heading: float) -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal", platform_heading_deg=heading))
    plant.reset()
    before = plant.truth.p_world_feet.copy()
    stand(plant, 2.0, math.radians(5.0))
    stand(plant, 0.5, 0.0)
    ground = plant.data.geom_xmat[plant.handles.ground_geom].reshape(3, 3)
    angle = math.radians(heading)
    tilt = math.radians(10.0)
    downhill = -math.sin(tilt) * np.array([math.cos(angle), math.sin(angle)])
    np.testing.assert_allclose(ground[:, 2], [*downhill, math.cos(tilt)], atol=1e-5)
    moved = plant.truth.p_world_feet - before
    ahead = before[0] * math.cos(angle) + before[1] * math.sin(angle)
    np.testing.assert_allclose(moved[2], math.tan(tilt) * ahead, atol=4e-3)
    assert np.linalg.norm(moved[:2], axis=0).max() < 0.012
    assert not plant.truth.fell and plant.truth.contact.all()


@pytest.mark.parametrize(("foot", "leg"), [("FR", 0), ("RL", 3)])
def test_block_raises_its_foot_and_carries_its_load(foot: str, leg: int) -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal", block_foot=foot))
    plant.reset()
    before = plant.truth.p_world_feet[2].copy()
    assert before[leg] - np.delete(before, leg).mean() == pytest.approx(0.001, abs=2e-4)
    stand(plant, 0.3, 0.02)
    stand(plant, 0.3, 0.0)
    rise = plant.truth.p_world_feet[2] - before
    assert rise[leg] == pytest.approx(0.006, abs=3e-4)
    weight = plant.truth.foot_forces[2].sum()
    assert weight == pytest.approx(plant.robot.mass * 9.81, rel=0.05)
    assert plant.truth.foot_forces[2, leg] > 1.0 and not plant.truth.fell


def test_calf_contact_with_the_block_is_a_fall_and_foot_contact_is_not() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal", block_foot="FR"))
    plant.reset()
    block = plant.model.geom(BLOCK).id
    foot = int(plant.handles.foot_geoms[0])
    calf = plant.model.geom("FR_calf_collision_0").id
    for other, fell in ((foot, False), (calf, True)):
        touching = SimpleNamespace(
            xmat=plant.data.xmat, contact=SimpleNamespace(geom=np.array([[block, other]]))
        )
        assert has_fallen(touching, plant.handles) is fell  # type: ignore[arg-type]


def test_moving_ground_cannot_be_combined_with_other_ground_options() -> None:
    for more in ({"slope_deg": 5.0}, {"hung": True}, {"soft_ground_sink": 0.01}):
        for moving in ({"block_foot": "FR"}, {"platform_heading_deg": 0.0}):
            with pytest.raises(Error, match="moving ground"):
                PlantSettings(**more, **moving)
    with pytest.raises(Error, match="moving ground"):
        PlantSettings(block_foot="FR", platform_heading_deg=0.0)
    with pytest.raises(Error, match="valid names: FR, FL, RR, RL"):
        PlantSettings(block_foot="FX")


def test_torque_scale_applies_to_every_motor() -> None:
    torques = []
    for scale in (1.0, 0.9):
        flaws = Flaws(torque_error=0.0, torque_scale=scale)
        plant = Plant("go1", PlantSettings(flaws=flaws, motor_lag=0.0))
        plant.reset()
        command = LowCmd()
        for i in range(12):
            command.motorCmd[i].tau = 2.0
        for _ in range(3):
            plant.step(command)
        torques.append(plant.motors.torque.copy())
    np.testing.assert_allclose(torques[1], 0.9 * torques[0], rtol=1e-12)
    assert torques[0] == pytest.approx(2.0)


def test_reseeded_plant_equals_a_new_plant() -> None:
    push = Push("lateral", 5.0, 0.1, 0.05)
    used = Plant("go1", PlantSettings(seed=3), [Push("forward", 9.0)])
    used.reset()
    for _ in range(20):
        used.step(pd_command(used))
    used.reseed(7, [push])
    fresh = Plant("go1", PlantSettings(seed=7), [push])
    for plant in (used, fresh):
        state = plant.reset()
        for _ in range(100):
            state = plant.step(pd_command(plant))
        plant.last = state.raw.copy()
    assert (used.last == fresh.last).all()
    assert (used.data.qpos == fresh.data.qpos).all()
