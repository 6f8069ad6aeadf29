# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import numpy as np
import pytest
import surefoot
from surefoot.messages.low_state_layout import LOW_STATE
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.hardware.wire_format import WireFormat, default_low_state


def test_commands_are_read_at_the_sdk_offsets() -> None:
    cmd = surefoot.LowCmd()
    for i in range(12):
        motor = cmd.motorCmd[i]
        motor.mode, motor.q, motor.dq, motor.tau = i, 100.0 + i, 200.0 + i, 300.0 + i
        motor.Kp, motor.Kd = 400.0 + i, 500.0 + i
    command = WireFormat("go1", real=False).read(cmd)
    numbers = np.arange(12.0)
    np.testing.assert_array_equal(command.mode, numbers)
    for offset, values in ((100, command.q), (200, command.dq), (300, command.tau)):
        np.testing.assert_array_equal(values, offset + numbers)
    for offset, values in ((400, command.kp), (500, command.kd)):
        np.testing.assert_array_equal(values, offset + numbers)


def test_a_command_read_is_a_copy() -> None:
    cmd = surefoot.LowCmd()
    command = WireFormat("go1", real=False).read(cmd)
    cmd.motorCmd[0].mode, cmd.motorCmd[0].tau = 0, 9.0
    assert command.mode[0] == 0x0A
    assert command.tau[0] == 0.0


@pytest.mark.parametrize(("name", "unit", "most"), [("go1", 256, 127.99), ("b1", 128, 255.99)])
def test_the_wire_truncates_torque_toward_zero_and_saturates(
    name: str, unit: int, most: float
) -> None:
    wire = WireFormat(name, real=True)
    values = np.array([1.9 / unit, -1.9 / unit, 1e4, -1e4] + [0.0] * 8)
    expected = [1.0 / unit, -1.0 / unit, most, -most]
    np.testing.assert_allclose(wire.torque(values)[:4], expected, atol=0.01 * 0.9)
    np.testing.assert_array_equal(wire.torque(values)[:2], expected[:2])


def test_the_wire_truncates_gains() -> None:
    cmd = surefoot.LowCmd()
    cmd.motorCmd[0].Kp, cmd.motorCmd[0].Kd = 1.049, 0.06
    cmd.motorCmd[1].Kp, cmd.motorCmd[1].Kd = -3.0, 0.13
    command = WireFormat("go1", real=True).read(cmd)
    assert (command.kp[0], command.kd[0]) == (33 / 32, 0.0)
    assert (command.kp[1], command.kd[1]) == (0.0, 2 / 16)


def test_state_array_layout_matches_the_sdk() -> None:
    raw = np.array(default_low_state().raw)
    frame = raw.view(LOW_STATE)
    for k, name in enumerate(("q", "dq", "ddq", "tauEst")):
        frame["motorState"][name][0, :12] = 10.0 * k + np.arange(12)
    for k, name in enumerate(("quaternion", "gyroscope", "accelerometer", "rpy")):
        frame[name][:] = 100.0 + k
    frame["footForce"][:], frame["footForceEst"][:] = [1, 2, 3, 4], [5, 6, 7, 8]
    frame["tick"][0] = 2**32 - 1
    state = surefoot.LowState.from_bytes(raw.tobytes())
    for i in range(12):
        motor = state.motorState[i]
        assert (motor.q, motor.dq, motor.ddq, motor.tauEst) == (i, 10 + i, 20 + i, 30 + i)
        assert (motor.mode, motor.temperature) == (0x0A, 35)
    for k, name in enumerate(("quaternion", "gyroscope", "accelerometer", "rpy")):
        assert set(getattr(state.imu, name).tolist()) == {100.0 + k}
    assert state.footForce.tolist() == [1, 2, 3, 4]
    assert state.footForceEst.tolist() == [5, 6, 7, 8]
    assert state.tick == 2**32 - 1
    assert state.imu.temperature == 45


def test_state_has_header_battery_and_empty_slots_of_a_real_robot() -> None:
    state = Plant("go1").reset()
    assert state.head.tolist() == [0xFE, 0xEF]
    assert state.levelFlag == surefoot.LOWLEVEL
    assert state.bms.SOC > 0
    assert min(state.bms.cell_vol[:6]) > 3000
    for i in range(12, 20):
        motor = state.motorState[i]
        assert (motor.mode, motor.q, motor.dq, motor.tauEst) == (0, 0.0, 0.0, 0.0)


def test_ticks_count_milliseconds_and_wrap() -> None:
    plant = Plant("go1", PlantSettings(control_rate=500.0), tick0=2**32 - 3)
    ticks = [plant.reset().tick]
    ticks += [plant.step(surefoot.LowCmd()).tick for _ in range(3)]
    assert ticks == [2**32 - 3, 2**32 - 1, 1, 3]
