# SPDX-License-Identifier: BSD-3-Clause
"""Keys of surefoot run that change the velocity of a walking robot."""

from __future__ import annotations

import pytest
import surefoot
from surefoot.cli.run_velocity import SPEED_STEP, TURN_STEP, KeyVelocity


def test_keys_add_steps_and_0_stops() -> None:
    keys = KeyVelocity()
    assert keys.handle_line("iij")
    assert keys.value == pytest.approx((2 * SPEED_STEP, 0.0, TURN_STEP))
    assert keys.handle_line("kgl")
    assert keys.value == pytest.approx((SPEED_STEP, -SPEED_STEP, 0.0))
    assert keys.velocity.vy == pytest.approx(-SPEED_STEP)
    assert keys.handle_line("0")
    assert keys.value == (0.0, 0.0, 0.0)


def test_v_sets_the_velocity_and_wrong_numbers_change_nothing() -> None:
    keys = KeyVelocity()
    assert keys.handle_line("v 0.3 0 -0.5")
    assert str(keys) == "0.30 0.00 m/s -0.50 rad/s"
    for line in ("v 1", "v a b c", "v nan 0 0", "v"):
        with pytest.raises(surefoot.Error, match="expected three numbers: VX VY YAW"):
            keys.handle_line(line)
    assert keys.value == (0.3, 0.0, -0.5)


def test_other_lines_are_not_about_the_velocity() -> None:
    assert not KeyVelocity().handle_line("hello")


def test_a_key_acts_at_once_on_a_velocity_beyond_the_limits() -> None:
    keys = KeyVelocity()
    keys.handle_line("v -9 0.1 0")
    keys.reduce_to(surefoot.WalkVelocity(-0.5, 0.1, 0.0))
    keys.handle_line("i")
    assert keys.value == pytest.approx((-0.5 + SPEED_STEP, 0.1, 0.0))
