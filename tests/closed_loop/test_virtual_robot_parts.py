# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import surefoot
from surefoot.protocol import Button, WirelessRemote
from surefoot.virtual_robot import parse_shake, read_remote_script
from surefoot.virtual_robot.channel import Channel
from surefoot.virtual_robot.keyboard import BUTTON_HOLD_TIME, Keyboard
from surefoot.virtual_robot.real_time_pacer import MAX_CATCH_UP, RealTimePacer
from surefoot.virtual_robot.remote import Remote
from surefoot.virtual_robot.run_record import RunRecorder, summarise
from surefoot.virtual_robot.status_line import StatusLine
from virtual_robot_helpers import BLANK, CLIENT, SteppedRobot, servo

POSE = (0.0, 1.2, -2.0)


def test_channel_loss_rate_is_applied_and_counted() -> None:
    channel = Channel(20.0, 0.0, 0.0, np.random.default_rng(1))
    for k in range(5000):
        channel.put((bytes([k % 256]), CLIENT), 0.0)
    arrived = len(channel.take(0.0))
    assert arrived + channel.lost == 5000
    assert channel.lost == pytest.approx(1000, abs=100)


def test_a_channel_delays_within_its_jitter_and_keeps_the_order() -> None:
    channel = Channel(0.0, 0.004, 0.003, np.random.default_rng(2))
    sent = {k: 0.0005 * k for k in range(1000)}
    delays, order = [], []
    for step in range(6000):
        now = 0.0001 * step
        for k in [k for k, t in sent.items() if t <= now]:
            channel.put((k.to_bytes(2, "big"), CLIENT), sent.pop(k))
        for data, _ in channel.take(now):
            order.append(int.from_bytes(data, "big"))
            delays.append(now - 0.0005 * order[-1])
    assert order == list(range(1000))
    assert min(delays) >= 0.004 - 1e-9
    assert max(delays) <= 0.0071 + 1e-9
    assert max(delays) - min(delays) > 0.002


def test_delay_applies_in_both_directions() -> None:
    stepped = SteppedRobot(hung=True, delay=0.005)
    stepped.put_datagram(BLANK)
    stepped.run(0.005)
    assert stepped.robot.link.peer is None
    stepped.run(0.005)  # the first sample leaves after 6 ms and arrives 5 ms later
    assert not stepped.port.outbox
    stepped.run(0.001)
    assert len(stepped.port.outbox) == 1
    stepped.command(servo(POSE))
    stepped.run(0.005)
    assert stepped.robot.command is None
    stepped.run(0.001)
    assert stepped.robot.command is not None


def test_loss_applies_in_both_directions_and_is_counted() -> None:
    stepped = SteppedRobot(hung=True, drop=30.0)
    stepped.run(1.0, servo(POSE))
    lost_in, lost_out = stepped.robot.link.lost
    assert lost_in == pytest.approx(150, abs=45)
    assert lost_out == pytest.approx(300, abs=60)
    assert stepped.robot.link.commands == 500 - lost_in
    assert f"lost {lost_in} in, {lost_out} out" in StatusLine(stepped.robot).line(1.0)
    assert len(stepped.port.outbox) == stepped.robot.link.sent - lost_out
    assert stepped.robot.watchdog.intervals == []


def test_script_drives_the_remote(tmp_path: Path) -> None:
    script = tmp_path / "remote.txt"
    script.write_text(
        "# a comment\n0.010 press A\n0.012 lx 0.5  # half right\n\n"
        "0.020 release a\n0.015 press L2\n0.016 L2 1\n"
    )
    stepped = SteppedRobot(remote=read_remote_script(script))
    stepped.put_datagram(BLANK)
    stepped.run(0.03)
    states = stepped.states()
    remotes = [WirelessRemote.from_bytes(bytes(s.wirelessRemote)) for s in states]
    assert not remotes[8].pressed(Button.A) and remotes[9].pressed(Button.A)
    assert remotes[18].pressed(Button.A) and not remotes[19].pressed(Button.A)
    assert remotes[29].pressed(Button.L2)
    assert (remotes[10].lx, remotes[11].lx) == (0.0, 0.5)
    assert remotes[29].L2 == 1.0


@pytest.mark.parametrize(
    "line", ["1 press", "soon press A", "1 push A", "1 press Q", "1 lx 2", "1 lx nan", "-1 lx 0"]
)
def test_invalid_remote_script_error_names_the_line(tmp_path: Path, line: str) -> None:
    script = tmp_path / "remote.txt"
    script.write_text("0 press A\n" + line + "\n")
    with pytest.raises(surefoot.Error, match="line 2"):
        read_remote_script(script)


def test_keys_move_sticks_by_steps_and_hold_buttons_for_a_while() -> None:
    remote = Remote()
    keyboard = Keyboard(remote)
    keyboard.type_text("ddw\x1b[A?", 0.0)

    def seen() -> WirelessRemote:
        return WirelessRemote.from_bytes(remote.bytes or bytes(40))

    assert (seen().lx, seen().ly) == (0.5, 0.25)
    assert seen().pressed(Button.UP)
    keyboard.poll(BUTTON_HOLD_TIME)
    assert not seen().pressed(Button.UP)
    keyboard.type_text("dddddd", 1.0)
    assert seen().lx == 1.0
    keyboard.type_text(" ", 1.0)
    assert (seen().lx, seen().ly) == (0.0, 0.0)


@pytest.mark.parametrize(
    "text", ["", "FR_1", "FR_1:8:5", "FR_3:8:5@1", "12:8:5@1", "FR_1:x:5@1", "FR_1:8:5@1:2:3"]
)
def test_invalid_shake_is_refused(text: str) -> None:
    with pytest.raises(surefoot.Error, match="shake"):
        parse_shake(text)


@pytest.mark.parametrize(("name", "motor"), [("FR_0", 0), ("RL_calf", 11), ("7", 7)])
def test_shake_accepts_joint_names_and_numbers(name: str, motor: int) -> None:
    assert parse_shake(f"{name}:8:5@1").motor == motor


class FakeClock:
    def __init__(self) -> None:
        self.time = 100.0

    def now(self) -> float:
        return self.time

    def sleep(self, seconds: float) -> None:
        self.time += seconds


def test_pacing_recovers_from_short_delays() -> None:
    clock = FakeClock()
    pace = RealTimePacer(0.001, clock.now, clock.sleep)
    for k in range(1000):
        clock.time += 0.004 if k % 10 == 0 else 0.0002  # a slow cycle now and then
        pace.wait()
    assert clock.time - 100.0 == pytest.approx(1.0, abs=MAX_CATCH_UP)
    assert pace.slipped == 0.0
    assert pace.real_time_factor == pytest.approx(1.0, abs=0.01)


def test_pacing_reports_time_it_cannot_recover() -> None:
    clock = FakeClock()
    pace = RealTimePacer(0.001, clock.now, clock.sleep)
    for _ in range(1000):
        clock.time += 0.002
        pace.wait()
    assert pace.real_time_factor == pytest.approx(0.5, abs=0.01)
    assert pace.slipped == pytest.approx(1.0, abs=2 * MAX_CATCH_UP)


def test_record_contains_received_commands_and_motion() -> None:
    stepped = SteppedRobot(hung=True, log_rate=100.0, timeout=0.05)
    recorder = RunRecorder(stepped.robot)
    for k in range(300):
        if 100 <= k < 200:
            stepped.command(servo(POSE))
        stepped.robot.cycle()
        recorder.observe()
    record = summarise(stepped.robot, recorder, 0.98, 0.1)
    log = record["log"]
    assert (record["robot"], record["sdk"], record["commands"]) == ("go1", "go1-v3.8", 100)
    assert record["damping"] == [[0.249, None]]
    assert record["rejected"] == {}
    assert not record["fell"]
    assert len(log["time"]) == len(log["q"]) == len(log["damping"]) == 30
    assert (log["time"][0], log["time"][-1]) == (0.01, 0.3)
    assert log["command_q"][9] is None
    np.testing.assert_allclose(log["command_q"][10], POSE * 4, atol=1e-6)
    assert log["command_kp"][10] == [20.0] * 12
    assert log["damping"][24:] == [True] * 6 and not any(log["damping"][:24])
    assert np.abs(log["tau"]).max() > 1.0


def test_status_line_contains_rates_rejections_and_mode() -> None:
    stepped = SteppedRobot(hung=True)
    status = StatusLine(stepped.robot)
    assert "no command yet" in status.line(0.001)
    stepped.put_datagram(b"noise")
    stepped.run(0.5, servo(POSE))
    line = status.line(1.001)
    for text in (
        "commands 250 Hz, 250",
        "rejected 1 (wrong length 1: 5 bytes",
        "motors servo",
        "x 0.50",
    ):
        assert text in line
    assert "249 repeated" in line and "lost" not in line and "overtaken" not in line
    stepped.run(0.2)
    assert "DAMP" in status.line(1.3)
