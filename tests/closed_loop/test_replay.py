# SPDX-License-Identifier: BSD-3-Clause
"""A replay gives the recorded commands, byte for byte, in this process and in another."""

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
from surefoot import (
    BodyReference,
    ControllerOptions,
    Gait,
    Mode,
    RequestStatus,
    Start,
    SupervisorOptions,
    WalkVelocity,
)
from surefoot.cli import main
from surefoot.estimate import read_log
from surefoot.messages.low_cmd_layout import LOW_CMD
from surefoot.replay import Recorder, Recording, play, read_recording, write_recording
from surefoot.replay.play import field_at
from surefoot.robot.power_level import power_level
from surefoot.sim import Plant, PlantSettings, Push

pytestmark = pytest.mark.slow

PLAY_SCRIPT = """
import hashlib, sys, surefoot
from surefoot.replay import play, read_recording
tape = read_recording(sys.argv[1])
print(hashlib.sha256(play(tape, surefoot.load_robot(tape.robot)).commands.tobytes()).hexdigest())
"""


@cache
def stood(robot: str) -> Recording:
    """Record a stand with a push, a body reference and a change of gains."""
    plant = Plant(robot, PlantSettings(seed=3), [Push("lateral", 5.0, time=0.5)])
    recorder = Recorder(plant.robot, ControllerOptions(motor_damping=0.5, delay=0.002))
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
    return recorder.recording()


@cache
def supervised(robot: str) -> Recording:
    """Record a supervisor from lying: arm, rise, stand, body reference, stop."""
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
    return recorder.recording()


@cache
def walked(robot: str) -> Recording:
    """Record a supervised walk: velocities, a change of the gait, a stop."""
    plant = Plant(robot, PlantSettings(walking_sensors=True, soft_soles=True, seed=3))
    options = SupervisorOptions(power_level=10, start=Start.STANDING)
    recorder = Recorder(plant.robot, options)
    state = plant.reset()
    for k in range(1500):
        if k == 250:
            recorder.call("request", Mode.WALK)
        if k == 700:
            recorder.call("gait", Gait.TROT)
        if k == 1100:
            recorder.call("request", Mode.STAND)
        if 250 < k < 1100 and k % 20 == 0:
            recorder.call("set_velocity", WalkVelocity(0.3 if k < 700 else 0.0, 0.0, 0.2))
        state = plant.step(recorder.update(state))
    assert recorder.controller.mode == Mode.STAND
    return recorder.recording()


def same_bytes(recording: Recording) -> None:
    result = play(recording, surefoot.load_robot(recording.robot))
    assert result.first is None and result.differing == 0 and result.same_build
    assert result.commands.tobytes() == recording.commands.tobytes()


@pytest.mark.parametrize("robot", ROBOTS)
def test_new_stand_controller_replays_the_same_commands(robot: str) -> None:
    recording = stood(robot)
    assert len(np.unique(recording.commands, axis=0)) == len(recording.commands)  # all differ
    same_bytes(recording)


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_new_supervisor_replays_the_same_commands_from_lying(robot: str) -> None:
    recording = supervised(robot)
    answers = Counter((call.name, call.answer) for call in recording.calls)
    assert answers[("arm", "NOT_READY")] or answers[("arm", "NO_STATE")]
    assert answers[("request", "ACCEPTED")] == 1
    same_bytes(recording)


def test_new_supervisor_replays_the_same_commands_of_a_walk() -> None:
    same_bytes(walked("go1"))


@pytest.mark.parametrize("make", [stood, supervised])
def test_another_process_gives_the_same_commands(tmp_path: Path, make) -> None:
    recording = make("go1")
    write_recording(tmp_path / "run.npz", recording)
    words = [sys.executable, "-c", PLAY_SCRIPT, str(tmp_path / "run.npz")]
    told = {subprocess.run(words, check=True, capture_output=True).stdout for _ in range(2)}
    assert told == {hashlib.sha256(recording.commands.tobytes()).hexdigest().encode() + b"\n"}


@pytest.mark.parametrize("make", [stood, supervised, walked])
def test_recording_file_round_trips_all_fields(tmp_path: Path, make) -> None:
    recording = make("go1")
    write_recording(tmp_path / "run.npz", recording)
    again = read_recording(tmp_path / "run.npz")
    for name, value in vars(recording).items():
        np.testing.assert_array_equal(getattr(again, name), value)


def test_changed_sample_bit_changes_commands_from_its_tick_on() -> None:
    recording = stood("go1")
    samples = recording.samples.copy()
    gyroscope_x = 38  # offset of four bytes; the last bits have no effect on float32 torques
    samples[500, gyroscope_x + 2] ^= 0x40
    result = play(replace(recording, samples=samples), surefoot.load_robot("go1"))
    assert result.first is not None and result.first.row == 500
    assert result.differing > 200


def test_first_differing_field_is_named_with_both_values() -> None:
    recording = stood("go1")
    commands = recording.commands.copy()
    motor = commands[400].view(LOW_CMD)[0]["motorCmd"][4]
    motor["tau"] = 1.5
    commands[600, 0] ^= 1
    first = (
        result := play(replace(recording, commands=commands), surefoot.load_robot("go1"))
    ).first
    assert first is not None and result.differing == 2
    assert (first.row, first.field, first.logged) == (400, "motorCmd[4].tau", 1.5)
    assert first.replayed == recording.commands[400].view(LOW_CMD)[0]["motorCmd"][4]["tau"]
    assert first.tick == int.from_bytes(recording.samples[400, 885:889].tobytes(), "little")


@pytest.mark.parametrize(
    ("gone", "where"), [("arm", "request"), ("request", "motorCmd"), ("stop", "motorCmd")]
)
def test_removed_calls_change_the_replay(gone: str, where: str) -> None:
    recording = supervised("go1")
    calls = tuple(call for call in recording.calls if call.name != gone)
    result = play(replace(recording, calls=calls), surefoot.load_robot("go1"))
    assert result.first is not None and where in result.first.field


def test_changed_options_or_gains_change_the_replay() -> None:
    recording = stood("go1")
    for other in (
        replace(recording, options={**recording.options, "motor_damping": 0.4}),
        replace(
            recording,
            gains={**recording.gains, "base_kp_tilt": 1.01 * recording.gains["base_kp_tilt"]},
        ),
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


def write_stand_log(path: Path, *more: str) -> list[str]:
    words = ["stand", "--duration", "0.6", "--push", "lateral:30%:0.1@0.2", "--seed", "2"]
    assert main([*words, "--reference", "roll=3@0.3", *more, "--log", str(path)]) == 0
    return ["replay", str(path)]


def test_replay_command_reports_identical_commands(tmp_path: Path, capsys) -> None:
    words = write_stand_log(tmp_path / "run.npz", "--motor-damping", "0.5", "--form", "general")
    capsys.readouterr()
    assert main([*words, "--robot", "go1"]) == 0
    assert capsys.readouterr().out == "identical: 300 commands of a StandController on go1\n"
    assert main([*words, "--json", "-"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["identical"] and record["commands"] == 300 and record["first"] is None
    assert read_log(tmp_path / "run.npz").ignored == ()  # surefoot estimate reads it too


def test_replay_command_reports_the_first_difference(tmp_path: Path, capsys) -> None:
    write_stand_log(tmp_path / "run.npz")
    recording = read_recording(tmp_path / "run.npz")
    recording.commands[100].view(LOW_CMD)[0]["motorCmd"][2]["tau"] += 1.0
    write_recording(tmp_path / "other.npz", replace(recording, build="another"))
    capsys.readouterr()
    assert main(["replay", str(tmp_path / "other.npz")]) == 4
    said = capsys.readouterr().out
    for part in (
        "row 100 ",
        "motorCmd[2].tau: logged ",
        "1 of 300 commands",
        "build: got a log of another",
    ):
        assert part in said


def test_invalid_replay_files_are_refused(tmp_path: Path, capsys) -> None:
    words = write_stand_log(tmp_path / "run.npz")
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
        (["replay", str(tmp_path / "cut.npz")], "got 299 samples and 300 commands"),
        (["replay", str(tmp_path / "text.npz")], "expected an NPZ log"),
    ):
        assert main(refused) == 2, refused
        assert part in capsys.readouterr().err


def test_unrecordable_call_is_refused() -> None:
    recorder = Recorder(surefoot.load_robot("go1"), SupervisorOptions())
    with pytest.raises(surefoot.Error, match=r"^call: got 'bridge', expected one of arm"):
        recorder.call("bridge", 0.002)
    with pytest.raises(surefoot.Error, match="call: got 'reset', expected a method of Supervisor"):
        recorder.call("reset")
    with pytest.raises(surefoot.Error, match="call 'request': got 0 arguments, expected one"):
        recorder.call("request")
    assert recorder.call("arm") == RequestStatus.NO_STATE
    assert recorder.recording().samples.shape == (0, len(surefoot.LowState().raw))


def test_call_after_the_last_tick_is_replayed() -> None:
    plant = Plant("go1")
    recorder = Recorder(plant.robot, SupervisorOptions(start=surefoot.Start.STANDING))
    state = plant.reset()
    for _ in range(50):
        state = plant.step(recorder.update(state))
    recorder.call("request", Mode.RISE)
    recording = recorder.recording()
    assert play(recording, plant.robot).first is None
    wrong = replace(recording, calls=(replace(recording.calls[0], answer="ACCEPTED"),))
    first = play(wrong, plant.robot).first
    assert first is not None and first.row == 50 and first.field == "answer of request()"


def test_corrupt_recording_byte_raises_an_error(tmp_path: Path) -> None:
    file = tmp_path / "run.npz"
    write_recording(file, stood("go1"))
    whole, rng, told = bytearray(file.read_bytes()), np.random.default_rng(1), 0
    for at in rng.integers(0, len(whole), 60):
        corrupted = bytearray(whole)
        corrupted[at] ^= 0x55
        file.write_bytes(corrupted)
        try:
            read_recording(file)  # a corrupt unused byte may have no effect
        except surefoot.Error:
            told += 1
    assert told > 40
