# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import math

import numpy as np
import pytest
import surefoot
from surefoot import protocol
from surefoot.sim.hardware.motors import BRAKE_KD
from virtual_robot_helpers import BLANK, CLIENT, SteppedRobot, servo

POSE = (0.0, 1.2, -2.0)  # pose of the vendor's position example


def joints(stepped: SteppedRobot) -> np.ndarray:
    return stepped.robot.plant.data.qpos[stepped.robot.plant.handles.motor_q].copy()


@pytest.mark.parametrize(
    ("name", "sdk"),
    [("a1", None), ("go1", None), ("b1", None), ("go1", "go1-v3.4"), ("go2", "go1-v3.8")],
)
def test_samples_are_frames_of_the_generation_with_the_robot_state(
    name: str, sdk: str | None
) -> None:
    stepped = SteppedRobot(name, sdk=sdk)
    stepped.put_datagram(BLANK)
    stepped.run(0.02)
    size = protocol.frame_sizes(stepped.settings.generation)[1]
    assert {len(frame) for frame, _ in stepped.port.outbox} == {size}
    assert {address for _, address in stepped.port.outbox} == {CLIENT}
    states = stepped.states()
    assert np.diff([state.tick for state in states]).tolist() == [1] * 19
    state, config = states[-1], stepped.robot.plant.robot.config
    angles = [state.motorState[i].q for i in range(12)]
    np.testing.assert_allclose(angles, config.q_standing, atol=0.06)
    assert state.imu.accelerometer[2] == pytest.approx(9.81, abs=0.4)
    assert state.motorState[0].mode == 0x0A
    assert state.motorState[0].temperature == 35
    assert (state.footForce > 5).all()
    assert state.footForceEst.tolist() == [0, 0, 0, 0]
    if stepped.settings.generation != "a1-v3.3":  # its frames have no battery
        assert state.bms.SOC == 80


@pytest.mark.parametrize(
    ("name", "sdk"), [("a1", None), ("go1", None), ("go2", "go1-v3.8"), ("b1", None)]
)
def test_controller_stands_the_robot_from_its_frames_alone(name: str, sdk: str | None) -> None:
    stepped = SteppedRobot(name, sdk=sdk)
    controller = surefoot.StandController(stepped.robot.plant.robot)
    height = stepped.robot.height
    stepped.put_datagram(BLANK)
    for _ in range(500):
        stepped.run(0.002)
        stepped.command(controller.update(stepped.states()[-1]))
        assert controller.status == surefoot.Status.OK
    assert stepped.robot.height == pytest.approx(height, abs=0.002)
    assert stepped.robot.tilt < np.radians(0.5)
    assert stepped.robot.link.commands == 499
    assert stepped.robot.command is not None and not stepped.robot.command.kp.any()


def test_robot_sends_nothing_before_the_first_datagram() -> None:
    stepped = SteppedRobot()
    stepped.run(0.05)
    assert not stepped.port.outbox
    assert stepped.robot.height == pytest.approx(0.31, abs=0.02)


def test_robot_replies_to_the_last_sender() -> None:
    stepped = SteppedRobot()
    other = ("other", 1)
    stepped.put_datagram(BLANK)
    stepped.run(0.005)
    stepped.put_datagram(BLANK, other)
    stepped.run(0.005)
    stepped.put_datagram(b"noise")
    stepped.run(0.005)
    assert [address for _, address in stepped.port.outbox] == [CLIENT] * 5 + [other] * 10


def test_a_servo_command_moves_the_joints_of_a_hung_robot() -> None:
    stepped = SteppedRobot(hung=True)
    height = stepped.robot.height
    stepped.run(1.5, servo(POSE))
    np.testing.assert_allclose(joints(stepped), POSE * 4, atol=0.15)
    assert stepped.robot.height == pytest.approx(height, abs=1e-6)
    assert stepped.robot.tilt == pytest.approx(0.0, abs=1e-6)
    assert stepped.robot.link.commands == 750
    assert stepped.robot.fell_at is None


@pytest.mark.parametrize("position_off", [surefoot.PosStopF, 1e9])
def test_torque_acts_alone_with_the_position_loop_off(position_off: float) -> None:
    stepped = SteppedRobot(hung=True)
    cmd = surefoot.LowCmd()
    for i in range(12):
        # If the position loop were on, this stiffness would give full torque at any angle.
        cmd.motorCmd[i].q, cmd.motorCmd[i].Kp, cmd.motorCmd[i].tau = position_off, 50.0, 0.5
    stepped.run(0.03, cmd)
    np.testing.assert_allclose(stepped.robot.plant.motors.estimated_torque, 0.5, atol=1e-3)


def test_motors_damp_after_the_timeout_and_follow_commands_again() -> None:
    stepped = SteppedRobot(hung=True, timeout=0.05)
    stepped.run(0.1, servo(POSE))
    stepped.run(0.0478)  # the last command arrived 2 ms before this time
    assert not stepped.robot.watchdog.damping
    stepped.states()
    stepped.run(0.05)
    assert stepped.robot.watchdog.intervals == [(pytest.approx(0.148), None)]
    state = stepped.states()[-1]
    assert {state.motorState[i].mode for i in range(12)} == {0x00}
    law = stepped.robot.plant.motors.law
    assert (law.kd == BRAKE_KD).all() and not law.kp.any() and not law.offset.any()
    stepped.run(0.1, servo(POSE))
    assert len(stepped.robot.watchdog.intervals) == 1
    assert stepped.robot.watchdog.intervals[0][1] == pytest.approx(stepped.robot.time - 0.1)
    assert stepped.states()[-1].motorState[0].mode == 0x0A
    assert [line.partition("s: ")[2] for line in stepped.lines] == [
        "first valid command",
        "no valid command for 50 ms, motors damp",
        "commands are back, motors follow them",
    ]


def test_watchdog_is_idle_before_the_first_command_and_without_timeout() -> None:
    stepped = SteppedRobot(timeout=0.05)
    stepped.put_datagram(BLANK)
    stepped.run(0.2)
    assert stepped.robot.watchdog.intervals == []
    without_timeout = SteppedRobot(hung=True, timeout=0.0)
    without_timeout.command(servo(POSE))
    without_timeout.run(0.5)
    assert without_timeout.robot.watchdog.intervals == []


def test_robot_with_damping_motors_sinks_and_counts_as_fallen() -> None:
    stepped = SteppedRobot()
    cmd = surefoot.LowCmd()
    for i in range(12):
        cmd.motorCmd[i].mode = 0x00
    stepped.run(2.5, cmd)
    assert stepped.robot.fell_at is not None
    assert stepped.robot.height < 0.2
    assert "the robot fell" in stepped.lines[-1]


def with_changed_byte(frame: bytes, at: int, value: int) -> bytes:
    changed = bytearray(frame)
    changed[at] = value
    return bytes(changed)


def with_crc(frame: bytes) -> bytes:
    return frame[:-4] + protocol.crc32(frame[:-4]).to_bytes(4, "little")


def test_invalid_datagrams_are_counted_by_reason() -> None:
    stepped = SteppedRobot()
    good = protocol.encode_low_cmd(surefoot.LowCmd())
    nan = good[:23] + np.float32(math.nan).tobytes() + good[27:]
    bad = {
        "blank": BLANK,
        "wrong generation": protocol.encode_low_cmd(surefoot.LowCmd(), "go1-v3.4"),
        "wrong length": good[:-1],
        "wrong head": with_crc(with_changed_byte(good, 0, 0x00)),
        "wrong level": with_crc(with_changed_byte(good, 2, 0xEE)),
        "wrong crc": with_changed_byte(good, 100, good[100] ^ 1),
        "not finite": with_crc(nan),
    }
    for reason, frame in bad.items():
        stepped.put_datagram(frame, (reason, 1))
        stepped.run(0.001)
    assert stepped.robot.link.rejected.counts == dict.fromkeys(bad, 1)
    assert stepped.robot.link.commands == 0
    assert stepped.robot.command is None
    answered = {address[0] for _, address in stepped.port.outbox}
    assert answered == set(bad) - {"wrong length"}


def test_random_datagrams_of_any_length_are_rejected() -> None:
    stepped = SteppedRobot()
    rng = np.random.default_rng(3)
    for size in [0, 1, 3, 602, 610, 614, 2048, *rng.integers(0, 1500, 100).tolist()]:
        stepped.put_datagram(rng.bytes(size))
    stepped.run(0.02)
    assert stepped.robot.link.received == sum(stepped.robot.link.rejected.counts.values()) == 107


def test_flood_is_read_in_part_and_the_newest_command_applies() -> None:
    stepped = SteppedRobot(hung=True)
    for k in range(1000):
        cmd = surefoot.LowCmd()
        cmd.motorCmd[0].tau = k / 64
        stepped.command(cmd)
    stepped.robot.cycle()
    read = stepped.robot.link.received
    assert 10 <= read <= 100
    assert stepped.robot.command is not None
    assert stepped.robot.command.tau[0] == (read - 1) / 64


def test_overtaken_and_repeated_commands_are_counted() -> None:
    stepped = SteppedRobot(hung=True)
    first, second = servo(POSE), servo((0.0, 1.0, -2.0))
    for cmd in (first, second, first):
        stepped.command(cmd)
    stepped.robot.cycle()
    link = stepped.robot.link
    assert (link.commands, link.overtaken, link.repeated) == (3, 2, 0)
    for cmd in (first, first, second):
        stepped.command(cmd)
        stepped.robot.cycle()
    assert (link.commands, link.overtaken, link.repeated) == (6, 2, 2)


def test_shaken_leg_raises_the_motor_power() -> None:
    from surefoot.virtual_robot import parse_shake

    shakes = (parse_shake("FR_1:20:6@0.3:0.4"), parse_shake("FL_thigh:20:6@0.3:0.4"))
    stepped = SteppedRobot(hung=True, shakes=shakes)
    power = []
    for _ in range(1000):
        stepped.command(servo((0.0, 0.8, -1.6)))
        stepped.robot.cycle()
        power.append(stepped.robot.power)
    assert max(power[:300]) < 15.0
    assert max(power[300:700]) > 60.0
    assert max(power[850:]) < 15.0
    assert abs(joints(stepped)[4] - 0.8) < 0.15


def test_equal_seeds_give_equal_samples() -> None:
    runs = []
    for seed in (4, 4, 5):
        stepped = SteppedRobot(hung=True, seed=seed, drop=10.0, jitter=0.003)
        stepped.run(0.1, servo(POSE))
        runs.append(stepped.port.outbox)
    assert runs[0] == runs[1]
    assert runs[0] != runs[2]


def test_ticks_count_milliseconds_at_500_hz() -> None:
    stepped = SteppedRobot(rate=500.0)
    stepped.put_datagram(BLANK)
    stepped.run(0.02)
    assert np.diff([state.tick for state in stepped.states()]).tolist() == [2] * 9


def test_other_sender_gets_no_samples_while_commands_arrive() -> None:
    stepped, stranger = SteppedRobot(), ("stranger", 1)
    stepped.run(0.01, surefoot.LowCmd())
    stepped.put_datagram(bytes([7] * 614), stranger)
    stepped.run(0.002)
    assert {address for _, address in stepped.port.outbox} == {CLIENT}
    stepped.run(0.2)  # longer than the timeout, without commands
    stepped.put_datagram(bytes([7] * 614), stranger)
    stepped.run(0.002)
    assert stepped.port.outbox[-1][1] == stranger
