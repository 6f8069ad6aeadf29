# SPDX-License-Identifier: BSD-3-Clause
"""Limits of pushes against closed formulas, against integration, and against what must hold."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import surefoot
from surefoot.assess.condition import Condition
from surefoot.assess.limits import Pendulum, braked_impulse, lip_impulse
from surefoot.assess.pinned import Pinned, direction, pin
from surefoot.assess.push_limits import Limits
from surefoot.assess.quasi_static import quasi_static_force

G = 9.81
# Mass, height, distances to the edge; impulses sideways and forward at once, sideways in 0.1 s.
TABLE = {
    "a1": (13.7, 0.315, 0.129, 0.18, 9.9, 14.0, 12.9),
    "go1": (13.1, 0.335, 0.126, 0.18, 8.9, 12.9, 11.6),
    "go2": (16.1, 0.339, 0.142, 0.19, 12.3, 16.4, 15.9),
    "b1": (62.6, 0.551, 0.198, 0.345, 52.0, 91.0, 64.0),
}
A1 = Pendulum(13.7, 0.315, 0.129)


@pytest.mark.parametrize("name", TABLE)
def test_the_pendulum_has_the_limits_of_the_table(name: str) -> None:
    mass, height, side, front, lateral, fore, longer = TABLE[name]
    at_once = 1e-6
    assert lip_impulse(Pendulum(mass, height, side), at_once) == pytest.approx(lateral, rel=0.02)
    assert lip_impulse(Pendulum(mass, height, front), at_once) == pytest.approx(fore, rel=0.02)
    assert lip_impulse(Pendulum(mass, height, side), 0.1) == pytest.approx(longer, rel=0.02)


def test_a_long_push_is_the_force_that_tips() -> None:
    force = lip_impulse(A1, 100.0) / 100.0
    assert force == pytest.approx(A1.mass * G * A1.distance / A1.height, rel=1e-6)


@pytest.mark.parametrize(("friction", "impulse"), [(0.2, 8.5), (0.3, 9.5)])
def test_slippery_ground_has_the_limits_of_the_table(friction: float, impulse: float) -> None:
    got = braked_impulse(A1, friction * A1.mass * G, 1e-6)
    closed = A1.mass * math.sqrt(friction * G * (2 * A1.distance - friction * A1.height))
    assert got == pytest.approx(closed, rel=1e-4) == pytest.approx(impulse, rel=0.02)


def test_friction_that_is_never_needed_limits_nothing() -> None:
    enough = A1.mass * G * A1.distance / A1.height
    for duration in (0.02, 0.1, 0.5):
        assert braked_impulse(A1, 1.001 * enough, duration) == lip_impulse(A1, duration)
        assert braked_impulse(A1, 0.9 * enough, duration) < lip_impulse(A1, duration)


@pytest.mark.parametrize("brake", [20.0, 40.0, 100.0])
@pytest.mark.parametrize("duration", [0.02, 0.1, 0.5])
@pytest.mark.parametrize("lift", [-0.1, 0.0, 0.1])
def test_the_limit_is_where_an_integrated_pendulum_tips(
    brake: float, duration: float, lift: float
) -> None:
    limit = braked_impulse(A1, brake, duration, lift)
    assert not tips(A1, brake, 0.99 * limit / duration, duration, lift)
    assert tips(A1, brake, 1.01 * limit / duration, duration, lift)


def tips(p: Pendulum, brake: float, force: float, duration: float, lift: float) -> bool:
    """Push a pendulum that brakes as hard as its edge and B allow, in small steps."""
    x, v, t, dt = 0.0, 0.0, 0.0, 2e-5
    while t < 20.0:
        pushed = force if t < duration else 0.0
        most = (p.mass * G * (p.distance - x) - lift * pushed) / p.height
        ground = min(brake, most)
        if v <= 0.0 and pushed <= ground:
            return False  # it stands still, or comes back
        v += dt * (pushed - ground) / p.mass
        x, t = x + dt * v, t + dt
        if x > p.distance:
            return True
    raise AssertionError("neither tips nor stops")


@pytest.fixture(params=["a1", "go1", "go2", "b1"])
def pinned(request) -> Pinned:
    return pin(surefoot.load_robot(request.param))


def test_the_pinned_pose_rests_on_feet_that_carry_it(pinned: Pinned) -> None:
    assert np.abs(pinned.contacts[:, 2]).max() < 1e-9
    assert 0.25 < pinned.height < 0.55
    # Virtual work: a foot that carries nothing is carried by its leg alone, far below the limit.
    assert np.all(np.abs(pinned.gravity_torque) < 0.3 * pinned.torque_limit)
    for leg in range(4):
        own = np.zeros(12, dtype=bool)
        own[3 * leg : 3 * leg + 3] = True
        assert np.abs(pinned.jacobians[leg][:, ~own]).max() < 1e-12


@pytest.mark.parametrize("degrees", [0.0, 33.0, 90.0, 180.0, 292.5])
def test_without_limits_the_static_force_is_that_which_tips(pinned: Pinned, degrees: float) -> None:
    strong = replace(pinned, torque_limit=np.full(12, 1e6))
    tipping = pinned.mass * G * pinned.reach(degrees) / pinned.height
    assert quasi_static_force(strong, degrees, 5.0) == pytest.approx(tipping, rel=1e-6)
    slides = 0.1 * pinned.mass * G
    assert quasi_static_force(strong, degrees, 0.1) == pytest.approx(slides, rel=1e-6)


def test_weak_motors_make_the_static_force_small_and_then_impossible(pinned: Pinned) -> None:
    strong = quasi_static_force(pinned, 0.0, 0.8)
    enough = np.max(np.abs(standing_torques(pinned)))
    weak = quasi_static_force(replace(pinned, torque_limit=np.full(12, 1.2 * enough)), 0.0, 0.8)
    assert 0.0 < weak < strong
    with pytest.raises(surefoot.Error, match="expected a robot whose motors hold"):
        quasi_static_force(replace(pinned, torque_limit=np.full(12, 0.3 * enough)), 0.0, 0.8)


def standing_torques(pinned: Pinned) -> np.ndarray:
    """Torques of a stand with a quarter of the weight on each foot, roughly."""
    force = np.array([0.0, 0.0, pinned.mass * G / 4])
    return pinned.gravity_torque - sum(J.T @ force for J in pinned.jacobians)


def test_the_own_limit_is_the_smaller_of_both_and_knows_friction_and_mass() -> None:
    limits = Limits(surefoot.load_robot("go1"))
    usual = limits.of(Condition("usual"), 90.0, 0.1, 0.0)
    assert usual.own == min(usual.lip, usual.quasi_static)
    icy = limits.of(Condition("icy", friction=0.2), 90.0, 0.1, 0.0)
    assert icy.own == icy.quasi_static < icy.lip == usual.lip
    heavy = limits.of(Condition("heavy", mass_share=0.2), 90.0, 0.1, 0.0)
    assert heavy.own == pytest.approx(1.2 * usual.own)


def test_a_push_as_good_as_on_the_ground_has_no_limit() -> None:
    limits = Limits(surefoot.load_robot("go1"))
    low = limits.of(Condition("usual"), 0.0, 0.1, -0.15)
    assert low.own > limits.of(Condition("usual"), 0.0, 0.1, 0.0).own
    with pytest.raises(surefoot.Error, match=r"heights_m: got -0\.3, expected from -0\.2"):
        limits.of(Condition("usual"), 0.0, 0.1, -0.3)


def test_directions_run_from_forward_towards_left() -> None:
    np.testing.assert_allclose(direction(0.0), [1, 0, 0], atol=1e-12)
    np.testing.assert_allclose(direction(90.0), [0, 1, 0], atol=1e-12)
