# SPDX-License-Identifier: BSD-3-Clause
"""The examples over UDP with a virtual robot, judged by the robot's log."""

from __future__ import annotations

import contextlib
import json
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from example_builds import build_examples
from surefoot import protocol
from virtual_robot_helpers import restore_sigint, start_robot, wait_for

pytestmark = pytest.mark.real_time

ROOT = Path(__file__).parents[2]
KEYS = ("time", "q", "dq", "height", *(f"command_{x}" for x in ("q", "dq", "tau", "kp", "kd")))


def command(name: str, language: str) -> list[str]:
    if language == "python":
        return [sys.executable, str(ROOT / "examples" / f"{name}.py")]
    return [str(build_examples() / name), str(build_examples() / "go1.robot")]


def run_example(
    name: str, language: str, tmp_path: Path, seconds: float, *robot_words: str
) -> tuple[int, str, dict[str, np.ndarray], dict[str, Any]]:
    """Run an example; return exit status, output, the robot's log as arrays, and its record."""
    words = command(name, language)  # build before the robot starts
    file = tmp_path / "robot.json"
    robot, port = start_robot(*robot_words, "--json", str(file))
    done = subprocess.run(
        [*words, "--port", str(port), "--duration", str(seconds)],
        capture_output=True,
        text=True,
        timeout=60,
    )
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    record = json.loads(file.read_text())
    rows = record["log"]
    first = next(k for k, q in enumerate(rows["command_q"]) if q is not None)
    log = {key: np.array(rows[key][first:], dtype=float) for key in KEYS}
    log["time"] -= log["time"][0]
    return done.returncode, done.stdout + done.stderr, log, record


languages = pytest.mark.parametrize("language", ["python", "cpp"])


@languages
def test_position_example_reaches_the_pose_and_swings_the_calf(
    language: str, tmp_path: Path
) -> None:
    status, said, log, record = run_example("example_position", language, tmp_path, 4.0, "--hung")
    assert status == 0, said
    assert record["rejected"] == {}
    # The target moves to the pose in small steps.
    steps = np.abs(np.diff(log["command_q"][log["time"] < 0.75, :3], axis=0))
    steps = steps[(steps < 10).all(axis=1)]
    assert steps.max() < 0.05
    # With 5 N.m/rad, the leg's weight and friction leave a position error.
    assert np.abs(log["q"][(log["time"] > 0.7) & (log["time"] < 0.78), 1] - 1.2).max() < 0.25
    late = (log["time"] > 1.0) & (log["time"] < 3.9)
    target, calf = log["command_q"][late, 2], log["q"][late, 2]
    assert target.min() == pytest.approx(-2.6, abs=0.01)
    assert target.max() == pytest.approx(-1.4, abs=0.01)
    assert calf.min() < -2.4 and calf.max() > -1.6
    turns = np.flatnonzero(np.diff(np.sign(target + 2.0)))
    # The example counts its own periods and loses some on a machine that has just compiled.
    assert np.diff(log["time"][late][turns]).mean() == pytest.approx(0.5 / 0.45, abs=0.08)


@languages
def test_torque_example_brings_the_thigh_to_zero_within_5_nm(language: str, tmp_path: Path) -> None:
    status, said, log, _ = run_example("example_torque", language, tmp_path, 5.0, "--hung")
    assert status == 0, said
    on = (log["time"] > 1.1) & (log["time"] < 4.9)
    assert np.abs(log["command_tau"][on, 1]).max() <= 5.0
    assert (log["command_kp"][on, 1] == 0).all() and (log["command_kd"][on, 1] == 0).all()
    assert np.abs(log["q"][(log["time"] > 3.5) & (log["time"] < 4.9), 1]).max() < 0.15


@languages
def test_velocity_example_follows_a_sine(language: str, tmp_path: Path) -> None:
    status, said, log, _ = run_example("example_velocity", language, tmp_path, 4.0, "--hung")
    assert status == 0, said
    on = (log["time"] > 1.2) & (log["time"] < 3.9)
    wanted, dq = log["command_dq"][on, 1], log["dq"][on, 1]
    assert wanted.max() == pytest.approx(2.0, abs=0.02)
    assert np.corrcoef(wanted, dq)[0, 1] > 0.9
    assert 1.2 < dq.max() < 2.5


@languages
def test_shaken_leg_trips_the_power_protection_and_ends_the_example(
    language: str, tmp_path: Path
) -> None:
    status, said, log, _ = run_example(
        "example_torque", language, tmp_path, 6.0, "--hung", "--shake", "FR_1:20:6@2:3"
    )
    assert status == 255, said
    assert "power protection" in said
    assert log["command_kd"][:, 0].max() > 0.0  # the example sent damping before it ended


@languages
def test_the_stand_example_stands(language: str, tmp_path: Path) -> None:
    status, said, log, _record = run_example("example_stand", language, tmp_path, 3.0)
    assert status == 0, said
    standing = log["height"][(log["time"] > 0.2) & (log["time"] < 2.8)]
    assert np.ptp(standing) < 0.01


def test_the_custom_planner_example_moves_the_body_on_a_circle(tmp_path: Path) -> None:
    status, said, log, _record = run_example("custom_planner", "cpp", tmp_path, 8.0)
    assert status == 0, said
    late = (log["time"] > 4.5) & (log["time"] < 7.8)
    assert np.ptp(log["height"][late]) < 0.02
    hips = log["q"][late][:, [0, 3, 6, 9]]
    assert (np.ptp(hips, axis=0) > 0.05).all()  # 4 cm to the side


@languages
@pytest.mark.parametrize("name", ["example_torque", "example_stand"])
@pytest.mark.parametrize("ending", ["silent robot", "Ctrl-C"])
def test_example_ends_with_a_damping_command(language: str, name: str, ending: str) -> None:
    hung = ["--hung"] if name == "example_torque" else []
    words = command(name, language)
    # With a silent robot a Runner keeps damping; the other examples end.
    stays = "stand" in words[0] and ending != "Ctrl-C"
    seconds = "3" if stays else "30"
    robot, port = start_robot(*hung)
    example = subprocess.Popen(
        [*words, "--port", str(port), "--duration", seconds],
        stdout=subprocess.PIPE,
        text=True,
        preexec_fn=restore_sigint,
    )
    began = time.monotonic()
    wait_for(robot, "first valid command")
    time.sleep(0.5)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listener:
        if ending == "Ctrl-C":
            example.send_signal(signal.SIGINT)
        else:
            robot.kill()
            robot.wait(timeout=20)
            listener.bind(("127.0.0.1", port))  # receives in place of the robot
            example.wait(timeout=20)
            listener.setblocking(False)
            heard = b""
            with contextlib.suppress(BlockingIOError):
                while True:
                    heard = listener.recv(2000)
            last = protocol.decode_low_cmd(heard, "go1-v3.8")
            assert all(last.motorCmd[k].Kd > 0 and last.motorCmd[k].tau == 0 for k in range(12))
        example.wait(timeout=20)
    robot.kill()
    robot.wait(timeout=20)
    assert time.monotonic() - began < 15.0
    assert example.returncode == (0 if ending == "Ctrl-C" else 3 if stays else 1)


@languages
def test_example_without_a_robot_reports_an_error(language: str) -> None:
    done = subprocess.run(
        [*command("example_torque", language), "--port", "9"],
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 1
    assert "no robot" in done.stdout + done.stderr
