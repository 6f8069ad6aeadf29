# SPDX-License-Identifier: BSD-3-Clause
"""The same log gives the same commands, byte for byte, in this process and in another."""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
from collections import Counter
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import surefoot
from plant_helpers import ROBOTS
from surefoot import BodyReference, Mode, RequestStatus, StandOptions, SupervisorOptions
from surefoot.cli import main
from surefoot.estimate import read_log
from surefoot.faults.joint_faults import power_level
from surefoot.low_cmd_layout import LOW_CMD
from surefoot.replay import Recorder, Tape, play, read_tape, write_tape
from surefoot.replay.play import field_at
from surefoot.sim import Plant, PlantSettings, Push

PLAYS = """
import hashlib, sys, surefoot
from surefoot.replay import play, read_tape
tape = read_tape(sys.argv[1])
print(hashlib.sha256(play(tape, surefoot.load_robot(tape.robot)).commands.tobytes()).hexdigest())
"""


@cache
def stood(robot: str) -> Tape:
    """Stand, be pushed and moved, and get other gains on the way."""
    plant = Plant(robot, PlantSettings(seed=3), [Push("lateral", 5.0, time=0.5)])
    recorder = Recorder(plant.robot, StandOptions(motor_damping=0.5, delay=0.002))
    gains = plant.robot.config.gains
    gains.base_kp_tilt *= 0.9
    state = plant.reset()
    for k in range(750):
        if k == 300:
            recorder.call("set_body_reference", BodyReference(height=-0.02, yaw=0.1))
        if k == 400:
            recorder.call("set_gains", gains)
        state = plant.step(recorder.update(state))
    assert not plant.truth.fell
    return recorder.tape()


@cache
def supervised(robot: str) -> Tape:
    """Lie, be armed, rise, stand, be asked for another pose, stopped, armed again."""
    plant = Plant(robot, PlantSettings(seed=3))
    state = plant.reset_lying(np.random.default_rng(3))
    recorder = Recorder(plant.robot, SupervisorOptions(power_level=power_level(robot)))
    supervisor, modes, stood = recorder.controller, [], 0
    while stood < 600:
        if not supervisor.armed and stood == 0 and len(modes) % 50 == 0:
            recorder.call("arm")
        elif supervisor.armed and supervisor.mode == Mode.PASSIVE:
            recorder.call("request", Mode.RISE)
        stood += supervisor.mode == Mode.STAND or stood >= 400
        if stood == 200:
            recorder.call("set_body_reference", BodyReference(roll=0.05))
        if stood == 400:
            recorder.call("stop")
        state = plant.step(recorder.update(state))
        modes.append(supervisor.mode)
        assert len(modes) < 10_000
    assert {Mode.PASSIVE, Mode.RISE, Mode.STAND, Mode.DAMPING} == set(modes)
    return recorder.tape()


def same_bytes(tape: Tape) -> None:
    result = play(tape, surefoot.load_robot(tape.robot))
    assert result.first is None and result.differing == 0 and result.same_build
    assert result.commands.tobytes() == tape.commands.tobytes()


@pytest.mark.parametrize("robot", ROBOTS)
def test_a_fresh_stand_controller_gives_the_same_commands(robot: str) -> None:
    tape = stood(robot)
    assert len(np.unique(tape.commands, axis=0)) == len(tape.commands)  # none is a constant
    same_bytes(tape)


@pytest.mark.parametrize("robot", ROBOTS)
def test_a_fresh_supervisor_gives_the_same_commands_from_lying_on(robot: str) -> None:
    tape = supervised(robot)
    answers = Counter((call.name, call.answer) for call in tape.calls)
    assert answers[("arm", "NOT_READY")] or answers[("arm", "NO_STATE")]
    assert answers[("request", "ACCEPTED")] == 1
    same_bytes(tape)


@pytest.mark.parametrize("make", [stood, supervised])
def test_so_does_another_process(tmp_path: Path, make) -> None:
    tape = make("go1")
    write_tape(tmp_path / "run.npz", tape)
    words = [sys.executable, "-c", PLAYS, str(tmp_path / "run.npz")]
    told = {subprocess.run(words, check=True, capture_output=True).stdout for _ in range(2)}
    assert told == {hashlib.sha256(tape.commands.tobytes()).hexdigest().encode() + b"\n"}


@pytest.mark.parametrize("make", [stood, supervised])
def test_a_file_keeps_all_of_a_tape(tmp_path: Path, make) -> None:
    tape = make("go1")
    write_tape(tmp_path / "run.npz", tape)
    again = read_tape(tmp_path / "run.npz")
    for name, value in vars(tape).items():
        np.testing.assert_array_equal(getattr(again, name), value)


def test_a_bit_in_a_report_shows_from_its_tick_on() -> None:
    tape = stood("go1")
    reports = tape.reports.copy()
    gyroscope_x = 38  # four bytes; the last bit of it is below what float32 torques show
    reports[500, gyroscope_x + 2] ^= 0x40
    result = play(replace(tape, reports=reports), surefoot.load_robot("go1"))
    assert result.first is not None and result.first.row == 500
    assert result.differing > 200


def test_the_first_field_that_differs_is_named_with_both_values() -> None:
    tape = stood("go1")
    commands = tape.commands.copy()
    motor = commands[400].view(LOW_CMD)[0]["motorCmd"][4]
    motor["tau"] = 1.5
    commands[600, 0] ^= 1
    first = (result := play(replace(tape, commands=commands), surefoot.load_robot("go1"))).first
    assert first is not None and result.differing == 2
    assert (first.row, first.field, first.logged) == (400, "motorCmd[4].tau", 1.5)
    assert first.replayed == tape.commands[400].view(LOW_CMD)[0]["motorCmd"][4]["tau"]
    assert first.tick == int.from_bytes(tape.reports[400, 885:889].tobytes(), "little")


@pytest.mark.parametrize(
    ("gone", "where"), [("arm", "request"), ("request", "motorCmd"), ("stop", "motorCmd")]
)
def test_calls_are_part_of_it(gone: str, where: str) -> None:
    tape = supervised("go1")
    calls = tuple(call for call in tape.calls if call.name != gone)
    result = play(replace(tape, calls=calls), surefoot.load_robot("go1"))
    assert result.first is not None and where in result.first.field


def test_options_and_gains_are_part_of_it() -> None:
    tape = stood("go1")
    for other in (
        replace(tape, options={**tape.options, "motor_damping": 0.4}),
        replace(tape, gains={**tape.gains, "base_kp_tilt": 1.01 * tape.gains["base_kp_tilt"]}),
    ):
        result = play(other, surefoot.load_robot("go1"))
        assert result.first is not None and result.first.row < 10


def test_every_byte_of_a_command_has_a_name() -> None:
    command = surefoot.LowCmd()
    command.motorCmd[19].Kd = 2.5
    name, kind, start = field_at(LOW_CMD, 22 + 19 * 33 + 18)
    assert name == ".motorCmd[19].Kd"
    assert command.raw[start : start + 4].view(kind)[0] == 2.5
    names = {field_at(LOW_CMD, byte)[0] for byte in range(LOW_CMD.itemsize)}
    assert {".head[1]", ".bandWidth", ".motorCmd[0].mode", ".wirelessRemote[39]", ".crc"} <= names
    assert len(names) == 2 + 1 + 1 + 2 + 2 + 1 + 20 * 9 + 4 + 40 + 2


def logged(path: Path, *more: str) -> list[str]:
    words = ["stand", "--duration", "0.6", "--push", "lateral:30%:0.1@0.2", "--seed", "2"]
    assert main([*words, "--reference", "roll=3@0.3", *more, "--log", str(path)]) == 0
    return ["replay", str(path)]


def test_the_command_says_identical(tmp_path: Path, capsys) -> None:
    words = logged(tmp_path / "run.npz", "--motor-damping", "0.5", "--form", "general")
    capsys.readouterr()
    assert main([*words, "--robot", "go1"]) == 0
    assert capsys.readouterr().out == "identical: 300 commands of a StandController on go1\n"
    assert main([*words, "--json", "-"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["identical"] and record["commands"] == 300 and record["first"] is None
    assert read_log(tmp_path / "run.npz").ignored == ()  # surefoot estimate does not mind


def test_the_command_says_what_differs(tmp_path: Path, capsys) -> None:
    logged(tmp_path / "run.npz")
    tape = read_tape(tmp_path / "run.npz")
    tape.commands[100].view(LOW_CMD)[0]["motorCmd"][2]["tau"] += 1.0
    write_tape(tmp_path / "other.npz", replace(tape, build="another"))
    capsys.readouterr()
    assert main(["replay", str(tmp_path / "other.npz")]) == 4
    said = capsys.readouterr().out
    for part in ("row 100 ", "motorCmd[2].tau: logged ", "1 of 300 commands", "build another"):
        assert part in said


def test_what_cannot_be_replayed_is_refused(tmp_path: Path, capsys) -> None:
    words = logged(tmp_path / "run.npz")
    arrays = dict(np.load(tmp_path / "run.npz"))
    np.savez(tmp_path / "sensors.npz", tick=arrays["tick"])
    np.savez(tmp_path / "cut.npz", **{**arrays, "replay_reports": arrays["replay_reports"][1:]})
    (tmp_path / "text.npz").write_text("no log")
    capsys.readouterr()
    for refused, part in (
        ([*words, "--robot", "a1"], "expected 'go1'"),
        (["replay", str(tmp_path / "run.csv")], "expected a .npz"),
        (["replay", str(tmp_path / "none.npz")], "cannot read"),
        (["replay", str(tmp_path / "sensors.npz")], "got no replay_reports"),
        (["replay", str(tmp_path / "cut.npz")], "299 reports and 300 commands"),
        (["replay", str(tmp_path / "text.npz")], "no NPZ file of a replay"),
    ):
        assert main(refused) == 2, refused
        assert part in capsys.readouterr().err


def test_a_call_that_no_tape_keeps_is_refused() -> None:
    recorder = Recorder(surefoot.load_robot("go1"), SupervisorOptions())
    with pytest.raises(surefoot.Error, match=r"^call: got 'bridge', expected one of arm"):
        recorder.call("bridge", 0.002)
    with pytest.raises(surefoot.Error, match="call: got 'reset', which Supervisor has not"):
        recorder.call("reset")
    with pytest.raises(surefoot.Error, match="call 'request': got 0 arguments, expected one"):
        recorder.call("request")
    assert recorder.call("arm") == RequestStatus.NO_STATE
    assert recorder.tape().reports.shape == (0, len(surefoot.LowState().raw))


def test_a_call_after_the_last_tick_is_part_of_it() -> None:
    plant = Plant("go1")
    recorder = Recorder(plant.robot, SupervisorOptions(start=surefoot.Start.STANDING))
    state = plant.reset()
    for _ in range(50):
        state = plant.step(recorder.update(state))
    recorder.call("request", Mode.RISE)
    tape = recorder.tape()
    assert play(tape, plant.robot).first is None
    wrong = replace(tape, calls=(replace(tape.calls[0], answer="ACCEPTED"),))
    first = play(wrong, plant.robot).first
    assert first is not None and first.row == 50 and first.field == "answer of request()"


def test_any_byte_that_is_wrong_is_told_as_a_damaged_log(tmp_path: Path) -> None:
    file = tmp_path / "run.npz"
    write_tape(file, stood("go1"))
    whole, rng, told = bytearray(file.read_bytes()), np.random.default_rng(1), 0
    for at in rng.integers(0, len(whole), 60):
        hurt = bytearray(whole)
        hurt[at] ^= 0x55
        file.write_bytes(hurt)
        try:
            read_tape(file)  # an unused byte may do no harm
        except surefoot.Error:
            told += 1
    assert told > 40
