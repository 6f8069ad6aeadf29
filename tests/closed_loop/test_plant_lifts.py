# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import numpy as np
import pytest
import surefoot
from plant_helpers import ROBOTS
from surefoot.sim import Lift, Plant, PlantSettings
from surefoot.sim.physics.external_lift import LIFT_PARTS


def loads(robot: str, lift: Lift, seconds: float) -> tuple[np.ndarray, np.ndarray, float]:
    """Stand during a lift; return times (n,), loads over weight (n, 4) and the height change."""
    plant = Plant(robot, PlantSettings(seed=2, foot_force="est"))
    controller = surefoot.StandController(plant.robot, plant.robot.config.gains)
    plant.add_lift(lift)
    state, rows, times = plant.reset(), [], []
    height = plant.truth.q[2]
    for _ in range(round(500 * seconds)):
        state = plant.step(controller.update(state))
        truth = plant.truth
        assert not truth.fell
        times.append(truth.time)
        rows.append(truth.foot_forces[2] / (9.81 * plant.robot.mass))
    return np.array(times), np.array(rows), plant.truth.q[2] - height


def greatest_change(share: np.ndarray, window: int = 10) -> float:
    return float(np.abs(share[window:] - share[:-window]).max())


@pytest.mark.parametrize("robot", ROBOTS)
def test_lifted_trunk_unloads_all_feet_and_loads_them_again(robot: str) -> None:
    # Legs in the air extend further down, by 15 % of the standing height.
    lifted = 0.12 if robot == "b1" else 0.06
    time, share, height = loads(robot, Lift("trunk", 1.0, height=lifted), 4.0)
    held = (time > 1.25) & (time < 1.5)
    assert np.all(share[held] == 0.0)
    assert share[time < 1.0].min() > 0.1
    assert share[-1].min() > 0.1
    assert abs(height) < 0.01
    assert all(greatest_change(share[:, leg]) > 0.2 for leg in range(4))


def test_lowered_trunk_is_loaded_before_the_lift_releases() -> None:
    lift = Lift("trunk", 1.0, 1.0, height=0.06, speed=0.3, ramp=0.1, lowering=0.2)
    assert [lift.desired_height(1.0 + t) for t in (0.1, 0.5, 1.0, 1.05)] == pytest.approx(
        [0.03, 0.06, 0.0, 0.0], abs=1e-12
    )
    time, share, height = loads("go1", lift, 4.0)
    assert np.all(share[(time > 1.3) & (time < 1.6)] == 0.0)
    assert share[(time > 1.97) & (time < 2.0)].sum(axis=1).mean() > 0.1
    assert share[-1].min() > 0.1
    assert abs(height) < 0.01


@pytest.mark.parametrize("part", LIFT_PARTS[1:])
def test_lifted_foot_is_unloaded_while_the_others_carry(part: str) -> None:
    time, share, height = loads("go1", Lift(part, 1.0), 4.0)
    held = (time > 1.1) & (time < 1.5)
    leg = LIFT_PARTS.index(part) - 1
    others = [k for k in range(4) if k != leg]
    assert np.all(share[held, leg] == 0.0)
    assert share[held][:, others].mean(axis=0).min() > 0.15
    assert share[-1].min() > 0.1
    assert abs(height) < 0.01


def test_lift_repeats_after_reset() -> None:
    plant = Plant("go1", PlantSettings(seed=2, foot_force="est"))
    plant.add_lift(Lift("trunk", 0.1, height=0.06))
    controller = surefoot.StandController(plant.robot, plant.robot.config.gains)
    for _ in range(2):
        controller.reset()
        state = plant.reset()
        for _ in range(200):
            state = plant.step(controller.update(state))
        assert np.all(plant.truth.foot_forces[2] == 0.0)


@pytest.mark.parametrize(
    ("field", "value"),
    [("part", "tail"), ("time", -1.0), ("height", 0.0), ("duration", 0.01), ("lowering", 0.0)],
)
def test_invalid_lift_error_names_the_field(field: str, value: object) -> None:
    good = {"part": "trunk", "time": 1.0}
    with pytest.raises(surefoot.Error, match=rf"^{field}: got "):
        Lift(**{**good, field: value})  # type: ignore[arg-type]
