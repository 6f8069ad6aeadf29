# SPDX-License-Identifier: BSD-3-Clause
"""Python API of the protections; tests/cpp/test_power_protection.cpp has the truth table."""

from __future__ import annotations

import inspect
import math

import numpy as np
import pytest
from surefoot import (
    FL_0,
    FR_2,
    RL_2,
    ControllerOptions,
    Error,
    LowCmd,
    LowState,
    PosStopF,
    Safety,
    StandController,
    Status,
)


def state_with_power(watts: float, motor: int = 0) -> LowState:
    state = LowState()
    state.motorState[motor].tauEst, state.motorState[motor].dq = 10.0, watts / 10.0
    return state


def test_lasting_overload_trips_on_the_6th_call_and_recovers(body) -> None:
    safety, cmd = Safety(body.robot), LowCmd()
    before = cmd.to_bytes()
    said = [safety.power_protect(cmd, state_with_power(101.0), 1) for _ in range(12)]
    assert said == [1] * 5 + [-1] * 7
    assert safety.power_counter == 10
    assert safety.power == pytest.approx(101.0)
    assert [safety.power_protect(cmd, state_with_power(0.0), 1) for _ in range(6)] == [-1] * 4 + [
        1
    ] * 2
    assert cmd.to_bytes() == before


def test_power_level_is_100_w_on_every_robot(body) -> None:
    for level in (1, 5, 10):
        safety = Safety(body.robot)
        for _ in range(10):
            assert safety.power_protect(LowCmd(), state_with_power(100.0 * level), level) == 1
        trips = [
            safety.power_protect(LowCmd(), state_with_power(100.0 * level + 1), level)
            for _ in "123456"
        ]
        assert trips[-1] == -1


@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_non_finite_power_trips_at_once(go1, bad: float) -> None:
    assert Safety(go1.robot).power_protect(LowCmd(), state_with_power(bad), 10) == -1


def test_position_protection_names_a_joint_near_its_limit(body) -> None:
    safety, config = Safety(body.robot), body.robot.config
    state = body.resting_sample(0)
    assert safety.position_protect(LowCmd(), state) == 1
    assert safety.position_motor == -1
    state.motorState[FL_0].q = config.q_upper[FL_0] - 0.08
    assert safety.position_protect(LowCmd(), state) == -1
    assert safety.position_motor == FL_0
    assert safety.position_angle == pytest.approx(config.q_upper[FL_0] - 0.08)
    assert safety.position_protect(LowCmd(), state, 0.07) == 1
    assert safety.position_protect(cmd=LowCmd(), state=state, limit=10) == -1
    state.motorState[RL_2].q = math.nan
    assert safety.position_protect(LowCmd(), state, -1.0) == -1
    assert safety.position_motor == RL_2


def test_positions_are_clamped_and_stop_values_are_kept(body) -> None:
    safety, config = Safety(body.robot), body.robot.config
    for q, limited in [
        (9.0, config.q_upper[FR_2]),
        (-9.0, config.q_lower[FR_2]),
        (-1.6, -1.6),
        (PosStopF, PosStopF),
        (1e9, 1e9),
        (math.nan, math.nan),
    ]:
        cmd = LowCmd()
        cmd.motorCmd[FR_2].q = q
        safety.position_limit(cmd)
        np.testing.assert_equal(cmd.motorCmd[FR_2].q, np.float32(limited))
    cmd = LowCmd()
    safety.position_limit(cmd)
    assert cmd.to_bytes() == LowCmd().to_bytes()


def test_reset_clears_the_power_counter(go1) -> None:
    safety = Safety(go1.robot)
    for _ in range(10):
        safety.power_protect(LowCmd(), state_with_power(5000.0), 1)
    safety.reset()
    assert (safety.power, safety.power_counter) == (0.0, 0)


def test_docstrings_state_differences_from_the_vendor_library() -> None:
    for method in (Safety.power_protect, Safety.position_protect, Safety.position_limit):
        assert "vendor" in inspect.getdoc(method)


def test_controller_applies_its_power_limit_and_reports_power(go1) -> None:
    gains, report = go1.robot.config.gains, go1.resting_sample(2)
    for i in range(12):
        report.motorState[i].dq = -0.4
    free = StandController(go1.robot)
    command = free.update(report)
    torques = [command.motorCmd[i].tau for i in range(12)]
    assert free.command_power == pytest.approx(0.4 * np.abs(torques).sum(), rel=1e-5)
    assert (free.power_scale, free.status) == (1.0, Status.OK)
    limited = StandController(
        go1.robot, gains, ControllerOptions(power_limit=0.9 * free.command_power)
    )
    limited.update(report)
    assert 0.5 < limited.power_scale < 1.0
    assert limited.status == Status.SATURATED
    assert limited.command_power == pytest.approx(0.9 * free.command_power)
    too_low = StandController(
        go1.robot, gains, ControllerOptions(power_limit=0.1 * free.command_power)
    )
    assert too_low.update(report).to_bytes() == command.to_bytes()
    assert (too_low.command_power, too_low.power_scale) == (free.command_power, 1.0)
    assert ControllerOptions().power_limit == math.inf


@pytest.mark.parametrize("wrong", [0.0, -5.0, math.nan])
def test_power_limit_must_be_positive(go1, wrong: float) -> None:
    with pytest.raises(Error, match="power_limit"):
        StandController(go1.robot, go1.robot.config.gains, ControllerOptions(power_limit=wrong))
