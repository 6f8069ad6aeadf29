# SPDX-License-Identifier: BSD-3-Clause
"""Push limits, compared with closed formulas, with integration and with invariants."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import surefoot
from surefoot.assess.condition import Condition
from surefoot.assess.pendulum_limits import Pendulum, force_limited_impulse, lip_impulse
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.quasi_static import quasi_static_force
from surefoot.assess.stance_model import StanceModel, direction_vector, stance_model

G = 9.81
# Mass [kg], height [m], distance to the lateral and the forward edge [m]; LIP push limits [N.s]:
# lateral and forward for an instantaneous push, lateral for a push of 0.1 s.
TABLE = {
    "a1": (13.7, 0.315, 0.129, 0.18, 9.9, 14.0, 12.9),
    "go1": (13.1, 0.335, 0.126, 0.18, 8.9, 12.9, 11.6),
    "go2": (16.1, 0.339, 0.142, 0.19, 12.3, 16.4, 15.9),
    "b1": (62.6, 0.551, 0.198, 0.345, 52.0, 91.0, 64.0),
}
A1 = Pendulum(13.7, 0.315, 0.129)


@pytest.mark.parametrize("name", TABLE)
def test_lip_push_limits_match_the_table(name: str) -> None:
    mass, height, side, front, lateral, fore, longer = TABLE[name]
    at_once = 1e-6
    assert lip_impulse(Pendulum(mass, height, side), at_once) == pytest.approx(lateral, rel=0.02)
    assert lip_impulse(Pendulum(mass, height, front), at_once) == pytest.approx(fore, rel=0.02)
    assert lip_impulse(Pendulum(mass, height, side), 0.1) == pytest.approx(longer, rel=0.02)


def test_long_push_limit_equals_the_tipping_force() -> None:
    force = lip_impulse(A1, 100.0) / 100.0
    assert force == pytest.approx(A1.mass * G * A1.edge_distance / A1.com_height, rel=1e-6)


@pytest.mark.parametrize(("friction", "impulse"), [(0.2, 8.5), (0.3, 9.5)])
def test_low_friction_push_limits_match_the_table(friction: float, impulse: float) -> None:
    got = force_limited_impulse(A1, friction * A1.mass * G, 1e-6)
    closed = A1.mass * math.sqrt(friction * G * (2 * A1.edge_distance - friction * A1.com_height))
    assert got == pytest.approx(closed, rel=1e-4) == pytest.approx(impulse, rel=0.02)


def test_sufficient_friction_does_not_reduce_the_limit() -> None:
    enough = A1.mass * G * A1.edge_distance / A1.com_height
    for duration in (0.02, 0.1, 0.5):
        assert force_limited_impulse(A1, 1.001 * enough, duration) == lip_impulse(A1, duration)
        assert force_limited_impulse(A1, 0.9 * enough, duration) < lip_impulse(A1, duration)


@pytest.mark.parametrize("max_brake_force", [20.0, 40.0, 100.0])
@pytest.mark.parametrize("duration", [0.02, 0.1, 0.5])
@pytest.mark.parametrize("push_height", [-0.1, 0.0, 0.1])
def test_push_limit_matches_an_integrated_pendulum(
    max_brake_force: float, duration: float, push_height: float
) -> None:
    limit = force_limited_impulse(A1, max_brake_force, duration, push_height)
    assert not tips(A1, max_brake_force, 0.99 * limit / duration, duration, push_height)
    assert tips(A1, max_brake_force, 1.01 * limit / duration, duration, push_height)


def tips(
    p: Pendulum, max_brake_force: float, force: float, duration: float, push_height: float
) -> bool:
    """Integrate a pushed pendulum in small steps; return whether it tips.

    It brakes with the largest force that the support edge and max_brake_force allow.
    """
    x, v, t, dt = 0.0, 0.0, 0.0, 2e-5
    while t < 20.0:
        pushed = force if t < duration else 0.0
        most = (p.mass * G * (p.edge_distance - x) - push_height * pushed) / p.com_height
        ground = min(max_brake_force, most)
        if v <= 0.0 and pushed <= ground:
            return False  # it stops or returns
        v += dt * (pushed - ground) / p.mass
        x, t = x + dt * v, t + dt
        if x > p.edge_distance:
            return True
    raise AssertionError("the pendulum neither tips nor stops within 20 s")


@pytest.fixture(params=["a1", "go1", "go2", "b1"])
def stance(request) -> StanceModel:
    return stance_model(surefoot.load_robot(request.param))


def test_pinned_pose_has_its_feet_on_the_ground(stance: StanceModel) -> None:
    assert np.abs(stance.contacts[:, 2]).max() < 1e-9
    assert 0.25 < stance.height < 0.55
    # The weight of the legs alone needs torques far below the limits.
    assert np.all(np.abs(stance.gravity_torque) < 0.3 * stance.torque_limit)
    for leg in range(4):
        own = np.zeros(12, dtype=bool)
        own[3 * leg : 3 * leg + 3] = True
        assert np.abs(stance.jacobians[leg][:, ~own]).max() < 1e-12


@pytest.mark.parametrize("direction_deg", [0.0, 33.0, 90.0, 180.0, 292.5])
def test_quasi_static_force_without_torque_limits_is_the_tipping_force(
    stance: StanceModel, direction_deg: float
) -> None:
    strong = replace(stance, torque_limit=np.full(12, 1e6))
    tipping = stance.mass * G * stance.edge_distance(direction_deg) / stance.height
    assert quasi_static_force(strong, direction_deg, 5.0) == pytest.approx(tipping, rel=1e-6)
    slides = 0.1 * stance.mass * G
    assert quasi_static_force(strong, direction_deg, 0.1) == pytest.approx(slides, rel=1e-6)


def test_weak_motors_reduce_the_quasi_static_force_until_infeasible(stance: StanceModel) -> None:
    strong = quasi_static_force(stance, 0.0, 0.8)
    enough = np.max(np.abs(standing_torques(stance)))
    weak = quasi_static_force(replace(stance, torque_limit=np.full(12, 1.2 * enough)), 0.0, 0.8)
    assert 0.0 < weak < strong
    with pytest.raises(surefoot.Error, match="expected a robot whose motors hold"):
        quasi_static_force(replace(stance, torque_limit=np.full(12, 0.3 * enough)), 0.0, 0.8)


def standing_torques(stance: StanceModel) -> np.ndarray:
    """Return approximate standing torques: a quarter of the weight on each foot [N.m]."""
    force = np.array([0.0, 0.0, stance.mass * G / 4])
    return stance.gravity_torque - sum(J.T @ force for J in stance.jacobians)


def test_push_limit_is_the_smaller_of_lip_and_quasi_static_limit() -> None:
    limits = PushLimits(surefoot.load_robot("go1"))
    usual = limits.push_limit(Condition("usual"), 90.0, 0.1, 0.0)
    assert usual.limit == min(usual.lip, usual.quasi_static)
    icy = limits.push_limit(Condition("icy", friction=0.2), 90.0, 0.1, 0.0)
    assert icy.limit == icy.quasi_static < icy.lip == usual.lip
    heavy = limits.push_limit(Condition("heavy", mass_share=0.2), 90.0, 0.1, 0.0)
    assert heavy.limit == pytest.approx(1.2 * usual.limit)


def test_push_far_below_the_centre_of_mass_is_refused() -> None:
    limits = PushLimits(surefoot.load_robot("go1"))
    low = limits.push_limit(Condition("usual"), 0.0, 0.1, -0.15)
    assert low.limit > limits.push_limit(Condition("usual"), 0.0, 0.1, 0.0).limit
    with pytest.raises(surefoot.Error, match=r"heights_m: got -0\.3, expected from -0\.2"):
        limits.push_limit(Condition("usual"), 0.0, 0.1, -0.3)


def test_directions_run_from_forward_towards_left() -> None:
    np.testing.assert_allclose(direction_vector(0.0), [1, 0, 0], atol=1e-12)
    np.testing.assert_allclose(direction_vector(90.0), [0, 1, 0], atol=1e-12)
