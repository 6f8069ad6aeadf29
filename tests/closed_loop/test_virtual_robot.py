# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import math

import numpy as np
import pytest
import surefoot
from surefoot import protocol
from surefoot.sim.motors import BRAKE_KD
from virtual_robot_helpers import BLANK, CLIENT, Bench, servo

POSE = (0.0, 1.2, -2.0)  # of the vendor's position example


def joints(bench: Bench) -> np.ndarray:
    return bench.robot.plant.data.qpos[bench.robot.plant.handles.motor_q].copy()


@pytest.mark.parametrize(
    ("name", "sdk"),
    [("a1", None), ("go1", None), ("b1", None), ("go1", "go1-v3.4"), ("go2", "go1-v3.8")],
)
def test_reports_are_frames_of_the_generation_and_say_how_the_robot_stands(
    name: str, sdk: str | None
) -> None:
    bench = Bench(name, sdk=sdk)
    bench.hear(BLANK)
    bench.run(0.02)
    size = protocol.frame_sizes(bench.settings.generation)[1]
    assert {len(frame) for frame, _ in bench.port.outbox} == {size}
    assert {address for _, address in bench.port.outbox} == {CLIENT}
    states = bench.states()
    assert np.diff([state.tick for state in states]).tolist() == [1] * 19
    state, config = states[-1], bench.robot.plant.robot.config
    angles = [state.motorState[i].q for i in range(12)]
    np.testing.assert_allclose(angles, config.q_standing, atol=0.06)
    assert state.imu.accelerometer[2] == pytest.approx(9.81, abs=0.4)
    assert state.motorState[0].mode == 0x0A
    assert state.motorState[0].temperature == 35
    assert (state.footForce > 5).all()
    assert state.footForceEst.tolist() == [0, 0, 0, 0]
    if bench.settings.generation != "a1-v3.3":  # its frames have no battery
        assert state.bms.SOC == 80


@pytest.mark.parametrize(
    ("name", "sdk"), [("a1", None), ("go1", None), ("go2", "go1-v3.8"), ("b1", None)]
)
def test_a_controller_that_sees_nothing_but_its_frames_stands_it_on_torques(
    name: str, sdk: str | None
) -> None:
    bench = Bench(name, sdk=sdk)
    controller = surefoot.StandController(bench.robot.plant.robot)
    height = bench.robot.height
    bench.hear(BLANK)
    for _ in range(500):
        bench.run(0.002)
        bench.command(controller.update(bench.states()[-1]))
        assert controller.status == surefoot.Status.OK
    assert bench.robot.height == pytest.approx(height, abs=0.002)
    assert bench.robot.tilt < np.radians(0.5)
    assert bench.robot.link.commands == 499
    assert bench.robot.command is not None and not bench.robot.command.kp.any()


def test_it_says_nothing_before_somebody_spoke() -> None:
    bench = Bench()
    bench.run(0.05)
    assert not bench.port.outbox
    assert bench.robot.height == pytest.approx(0.31, abs=0.02)


def test_it_answers_whoever_spoke_last() -> None:
    bench = Bench()
    other = ("other", 1)
    bench.hear(BLANK)
    bench.run(0.005)
    bench.hear(BLANK, other)
    bench.run(0.005)
    bench.hear(b"noise")
    bench.run(0.005)
    assert [address for _, address in bench.port.outbox] == [CLIENT] * 5 + [other] * 10


def test_a_servo_command_moves_the_joints_of_a_hung_robot() -> None:
    bench = Bench(hung=True)
    height = bench.robot.height
    bench.run(1.5, servo(POSE))
    np.testing.assert_allclose(joints(bench), POSE * 4, atol=0.15)
    assert bench.robot.height == pytest.approx(height, abs=1e-6)
    assert bench.robot.tilt == pytest.approx(0.0, abs=1e-6)
    assert bench.robot.link.commands == 750
    assert bench.robot.fell_at is None


@pytest.mark.parametrize("position_off", [surefoot.PosStopF, 1e9])
def test_a_torque_acts_alone_where_the_position_loop_is_off(position_off: float) -> None:
    bench = Bench(hung=True)
    cmd = surefoot.LowCmd()
    for i in range(12):
        # A stiffness that would turn any angle into full torque, were it listened to.
        cmd.motorCmd[i].q, cmd.motorCmd[i].Kp, cmd.motorCmd[i].tau = position_off, 50.0, 0.5
    bench.run(0.03, cmd)
    np.testing.assert_allclose(bench.robot.plant.motors.believed, 0.5, atol=1e-3)


def test_motors_damp_when_commands_stop_and_obey_when_they_come_back() -> None:
    bench = Bench(hung=True, timeout=0.05)
    bench.run(0.1, servo(POSE))
    bench.run(0.0478)  # the last command came 2 ms before the silence
    assert not bench.robot.watchdog.damping
    bench.states()
    bench.run(0.05)
    assert bench.robot.watchdog.intervals == [(pytest.approx(0.148), None)]
    state = bench.states()[-1]
    assert {state.motorState[i].mode for i in range(12)} == {0x00}
    law = bench.robot.plant.motors.law
    assert (law.kd == BRAKE_KD).all() and not law.kp.any() and not law.offset.any()
    bench.run(0.1, servo(POSE))
    assert len(bench.robot.watchdog.intervals) == 1
    assert bench.robot.watchdog.intervals[0][1] == pytest.approx(bench.robot.time - 0.1)
    assert bench.states()[-1].motorState[0].mode == 0x0A
    assert [line.partition("s: ")[2] for line in bench.lines] == [
        "first valid command",
        "no valid command for 50 ms, motors damp",
        "commands are back, motors obey",
    ]


def test_nothing_is_missed_before_the_first_command_nor_without_a_timeout() -> None:
    bench = Bench(timeout=0.05)
    bench.hear(BLANK)
    bench.run(0.2)
    assert bench.robot.watchdog.intervals == []
    patient = Bench(hung=True, timeout=0.0)
    patient.command(servo(POSE))
    patient.run(0.5)
    assert patient.robot.watchdog.intervals == []


def test_a_robot_whose_motors_damp_sinks_to_the_ground_and_that_counts_as_a_fall() -> None:
    bench = Bench()
    cmd = surefoot.LowCmd()
    for i in range(12):
        cmd.motorCmd[i].mode = 0x00
    bench.run(2.5, cmd)
    assert bench.robot.fell_at is not None
    assert bench.robot.height < 0.2
    assert "the robot fell" in bench.lines[-1]


def damaged(frame: bytes, at: int, value: int) -> bytes:
    changed = bytearray(frame)
    changed[at] = value
    return bytes(changed)


def sealed(frame: bytes) -> bytes:
    return frame[:-4] + protocol.crc32(frame[:-4]).to_bytes(4, "little")


def test_what_is_no_command_is_counted_by_reason_and_answered_if_it_looks_like_one() -> None:
    bench = Bench()
    good = protocol.encode_low_cmd(surefoot.LowCmd())
    nan = good[:23] + np.float32(math.nan).tobytes() + good[27:]
    bad = {
        "blank": BLANK,
        "wrong generation": protocol.encode_low_cmd(surefoot.LowCmd(), "go1-v3.4"),
        "wrong length": good[:-1],
        "wrong head": sealed(damaged(good, 0, 0x00)),
        "wrong level": sealed(damaged(good, 2, 0xEE)),
        "wrong crc": damaged(good, 100, good[100] ^ 1),
        "not finite": sealed(nan),
    }
    for reason, frame in bad.items():
        bench.hear(frame, (reason, 1))
        bench.run(0.001)
    assert bench.robot.link.rejected == dict.fromkeys(bad, 1)
    assert bench.robot.link.commands == 0
    assert bench.robot.command is None
    answered = {address[0] for _, address in bench.port.outbox}
    assert answered == set(bad) - {"wrong length"}


def test_noise_of_any_length_does_no_harm() -> None:
    bench = Bench()
    rng = np.random.default_rng(3)
    for size in [0, 1, 3, 602, 610, 614, 2048, *rng.integers(0, 1500, 100).tolist()]:
        bench.hear(rng.bytes(size))
    bench.run(0.02)
    assert bench.robot.link.received == sum(bench.robot.link.rejected.values()) == 107


def test_of_a_flood_a_part_is_read_and_the_newest_valid_command_wins() -> None:
    bench = Bench(hung=True)
    for k in range(1000):
        cmd = surefoot.LowCmd()
        cmd.motorCmd[0].tau = k / 64
        bench.command(cmd)
    bench.robot.cycle()
    read = bench.robot.link.received
    assert 10 <= read <= 100
    assert bench.robot.command is not None
    assert bench.robot.command.tau[0] == (read - 1) / 64


def test_commands_that_no_motor_saw_and_commands_that_say_nothing_new_are_counted() -> None:
    bench = Bench(hung=True)
    first, second = servo(POSE), servo((0.0, 1.0, -2.0))
    for cmd in (first, second, first):
        bench.command(cmd)
    bench.robot.cycle()
    link = bench.robot.link
    assert (link.commands, link.overtaken, link.repeated) == (3, 2, 0)
    for cmd in (first, first, second):
        bench.command(cmd)
        bench.robot.cycle()
    assert (link.commands, link.overtaken, link.repeated) == (6, 2, 2)


def test_a_shaken_leg_costs_the_motors_power_while_it_is_shaken() -> None:
    from surefoot.virtual_robot import parse_shake

    shakes = (parse_shake("FR_1:20:6@0.3:0.4"), parse_shake("FL_thigh:20:6@0.3:0.4"))
    bench = Bench(hung=True, shakes=shakes)
    power = []
    for _ in range(1000):
        bench.command(servo((0.0, 0.8, -1.6)))
        bench.robot.cycle()
        power.append(bench.robot.power)
    assert max(power[:300]) < 15.0
    assert max(power[300:700]) > 60.0
    assert max(power[850:]) < 15.0
    assert abs(joints(bench)[4] - 0.8) < 0.15


def test_the_same_seed_gives_the_same_reports() -> None:
    runs = []
    for seed in (4, 4, 5):
        bench = Bench(hung=True, seed=seed, drop=10.0, jitter=0.003)
        bench.run(0.1, servo(POSE))
        runs.append(bench.port.outbox)
    assert runs[0] == runs[1]
    assert runs[0] != runs[2]


def test_slower_reports_have_ticks_that_count_milliseconds() -> None:
    bench = Bench(rate=500.0)
    bench.hear(BLANK)
    bench.run(0.02)
    assert np.diff([state.tick for state in bench.states()]).tolist() == [2] * 9


def test_a_stranger_does_not_take_the_reports_of_who_commands() -> None:
    bench, stranger = Bench(), ("stranger", 1)
    bench.run(0.01, surefoot.LowCmd())
    bench.hear(bytes([7] * 614), stranger)
    bench.run(0.002)
    assert {address for _, address in bench.port.outbox} == {CLIENT}
    bench.run(0.2)  # longer than the timeout: nobody commands any more
    bench.hear(bytes([7] * 614), stranger)
    bench.run(0.002)
    assert bench.port.outbox[-1][1] == stranger
