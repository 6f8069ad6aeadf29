# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import numpy as np
import pytest
import surefoot
from surefoot.sim.hardware.motors import BRAKE_KD, MotorLaw, Motors, command_law
from surefoot.sim.hardware.wire_format import WireFormat

CONFIG = surefoot.load_robot("go1").config
DT = 0.0005


def random_command(rng: np.random.Generator) -> surefoot.LowCmd:
    cmd = surefoot.LowCmd()
    for i in range(12):
        motor = cmd.motorCmd[i]
        motor.q, motor.dq, motor.tau = rng.normal(size=3)
        motor.Kp, motor.Kd = rng.uniform(0.0, 5.0), rng.uniform(0.0, 0.3)
    return cmd


def ideal_torque(cmd: surefoot.LowCmd, q: np.ndarray, dq: np.ndarray) -> np.ndarray:
    motors = Motors(CONFIG, DT, 0.0, None)
    motors.law = command_law(WireFormat("go1", real=False).read(cmd))
    return motors.step(q, dq)


def test_motor_torque_follows_the_sdk_law() -> None:
    rng = np.random.default_rng(0)
    cmd, q, dq = random_command(rng), rng.normal(size=12), rng.normal(size=12)
    expected = [
        m.tau + m.Kp * (m.q - q[i]) + m.Kd * (m.dq - dq[i])
        for i, m in enumerate(cmd.motorCmd[i] for i in range(12))
    ]
    assert np.abs(expected).max() < CONFIG.tau_max.min()
    np.testing.assert_allclose(ideal_torque(cmd, q, dq), expected, rtol=1e-6, atol=1e-6)


def test_pos_stop_and_vel_stop_disable_their_terms() -> None:
    cmd = surefoot.LowCmd()
    q, dq = np.full(12, 0.5), np.full(12, 2.0)
    for i in range(12):
        motor = cmd.motorCmd[i]
        motor.Kp, motor.Kd, motor.tau = 10.0, 1.0, 0.25
        assert (motor.q, motor.dq) == (surefoot.PosStopF, surefoot.VelStopF)
    cmd.motorCmd[1].q = 0.0
    cmd.motorCmd[2].dq = 0.0
    torque = ideal_torque(cmd, q, dq)
    assert torque[0] == pytest.approx(0.25)
    assert torque[1] == pytest.approx(0.25 - 10.0 * 0.5)
    assert torque[2] == pytest.approx(0.25 - 1.0 * 2.0)


def test_a_motor_out_of_servo_mode_brakes() -> None:
    cmd = random_command(np.random.default_rng(1))
    cmd.motorCmd[4].mode = 0x00
    torque = ideal_torque(cmd, np.zeros(12), np.full(12, 2.0))
    assert torque[4] == pytest.approx(-BRAKE_KD * 2.0)


def test_non_finite_command_gives_zero_torque() -> None:
    cmd = surefoot.LowCmd()
    for name in ("q", "dq", "tau", "Kp", "Kd"):
        for i in range(12):
            setattr(cmd.motorCmd[i], name, float("nan"))
    np.testing.assert_array_equal(ideal_torque(cmd, np.ones(12), np.ones(12)), np.zeros(12))


def test_torque_limits_match_the_torque_speed_curve() -> None:
    motors = Motors(CONFIG, DT, 0.0, None)
    for fraction in np.linspace(-1.3, 1.3, 27):
        dq = fraction * np.array(CONFIG.no_load_speed)
        least, most = motors.limits(dq)
        for i in range(12):
            up = surefoot.motor_torque_limit(CONFIG, i, dq[i], 1.0)
            down = surefoot.motor_torque_limit(CONFIG, i, dq[i], -1.0)
            assert most[i] == pytest.approx(up, abs=1e-9)
            assert least[i] == pytest.approx(-down, abs=1e-9)


@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_excess_torque_is_clipped_to_the_torque_speed_curve(sign: float) -> None:
    motors = Motors(CONFIG, DT, 0.0, None)
    motors.law = MotorLaw(np.full(12, sign * 1e6), np.zeros(12), np.zeros(12))
    fast = sign * 0.75 * np.array(CONFIG.no_load_speed)  # halfway from corner to no-load
    np.testing.assert_allclose(motors.step(np.zeros(12), fast), 0.5 * sign * CONFIG.tau_max)
    np.testing.assert_allclose(motors.step(np.zeros(12), -fast), sign * CONFIG.tau_max)


def test_motor_lag_does_not_depend_on_the_step() -> None:
    for steps in (4, 40):
        motors = Motors(CONFIG, 0.004 / steps, 0.002, None)
        motors.law = MotorLaw(np.ones(12), np.zeros(12), np.zeros(12))
        for _ in range(steps):
            torque = motors.step(np.zeros(12), np.zeros(12))
        np.testing.assert_allclose(torque, 1.0 - np.exp(-2.0))


def test_real_motors_have_a_constant_unreported_torque_error() -> None:
    motors = Motors(CONFIG, DT, 0.0, np.random.default_rng(5))
    motors.law = MotorLaw(np.full(12, 2.0), np.zeros(12), np.zeros(12))
    first = motors.step(np.zeros(12), np.zeros(12))
    second = motors.step(np.zeros(12), np.zeros(12))
    np.testing.assert_array_equal(first, second)
    np.testing.assert_allclose(motors.estimated_torque, 2.0)
    assert np.abs(first / 2.0 - 1.0).max() <= 0.05
    assert len(set(first.tolist())) == 12
