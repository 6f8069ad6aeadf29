# SPDX-License-Identifier: BSD-3-Clause
"""surefoot run against surefoot robot, two processes; and against robots of the wrong kind."""

from __future__ import annotations

import json
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
import surefoot
from surefoot import protocol
from surefoot.cli import main
from virtual_robot_helpers import start


def controller(port: int, *words: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "surefoot.cli", "run", "--port", str(port), *words]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def wait_for(process: subprocess.Popen[str], words: str) -> None:
    assert process.stdout is not None
    while words not in (line := process.stdout.readline()):
        assert line, f"ended without '{words}'"


@pytest.mark.parametrize("name", ["a1", "go1", "b1"])
def test_a_robot_stands_over_udp_in_its_own_generation(name: str, tmp_path: Path) -> None:
    robot, port = start("--robot", name, "--json", str(tmp_path / "robot.json"))
    run = controller(port, "--robot", name, "--duration", "3", "--json", str(tmp_path / "run.json"))
    out, err = run.communicate(timeout=60)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    assert (run.returncode, err) == (0, ""), out
    result = json.loads((tmp_path / "run.json").read_text())
    record = json.loads((tmp_path / "robot.json").read_text())
    assert result["generation"] == protocol.default_generation(name)
    assert result["reason"] == "asked" and result["link"]["corrupt"] == 0
    assert not record["fell"] and record["rejected"] == {}
    assert result["link"]["valid"] + result["link"]["lost"] > 2500
    assert result["greatest_power_w"] < 100.0


def test_a_robot_that_dies_is_stale_and_comes_back_only_when_it_is_armed_again(
    tmp_path: Path,
) -> None:
    robot, port = start()
    run = controller(port, "--json", str(tmp_path / "run.json"))
    wait_for(run, "standing")
    time.sleep(0.5)
    robot.kill()
    wait_for(run, "damping: stale")
    again, _ = start("--port", str(port))
    time.sleep(1.0)
    run.send_signal(signal.SIGUSR1)
    wait_for(run, " standing")
    time.sleep(0.5)
    run.send_signal(signal.SIGINT)
    _, err = run.communicate(timeout=20)
    again.kill()
    result = json.loads((tmp_path / "run.json").read_text())
    assert (run.returncode, err) == (0, "")
    assert (result["dampings"], result["rearms"]) == (1, 1)


def test_a_controller_that_dies_leaves_motors_that_damp(tmp_path: Path) -> None:
    robot, port = start("--json", str(tmp_path / "robot.json"))
    run = controller(port)
    wait_for(run, "standing")
    time.sleep(0.5)
    run.kill()
    time.sleep(0.5)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    record = json.loads((tmp_path / "robot.json").read_text())
    assert record["damping"], record.keys()


class Impostor:
    """Answers whoever sends with LowStates of one generation, as a robot does."""

    def __init__(self, generation: str) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.settimeout(0.05)
        self.port = self.socket.getsockname()[1]
        self.generation = generation
        self.heard: list[bytes] = []
        self.going = True
        self.thread = threading.Thread(target=self.answer)

    def answer(self) -> None:
        state = surefoot.LowState()
        while self.going:
            try:
                data, sender = self.socket.recvfrom(2000)
            except TimeoutError:
                continue
            self.heard.append(data)
            state.tick += 1
            self.socket.sendto(protocol.encode_low_state(state, self.generation), sender)

    def __enter__(self) -> Impostor:
        self.thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.going = False
        self.thread.join()
        self.socket.close()


@pytest.mark.parametrize("wanted", protocol.GENERATIONS)
@pytest.mark.parametrize("spoken", protocol.GENERATIONS)
def test_a_robot_of_another_generation_is_refused_by_both_names(
    wanted: str, spoken: str, capsys: pytest.CaptureFixture[str]
) -> None:
    if wanted == spoken:
        pytest.skip("not a wrong pair")
    with Impostor(spoken) as robot:
        status = main(["run", "--port", str(robot.port), "--sdk", wanted, "--duration", "5"])
    said = capsys.readouterr().err
    assert status == 1
    assert wanted in said and spoken in said and said.count("\n") == 1
    commands = [protocol.decode_low_cmd(data, wanted) for data in robot.heard]
    assert all(c.motorCmd[k].Kd > 0 and c.motorCmd[k].tau == 0 for c in commands for k in range(12))


@pytest.mark.parametrize(
    ("words", "status", "said"),
    [
        (["--host", "192.168.123.10"], 2, "beyond this machine"),
        (["--host", "no.such.host.invalid"], 2, "no.such.host.invalid"),
        (["--sdk", "go1"], 2, "go1-v3.8"),
        (["--robot", "go2"], 2, "name a generation"),
        (["--power-level", "11"], 2, "0 .. 10"),
        (["--rate", "5"], 2, "100 .. 1000"),
        (["--port", "70000"], 2, "70000"),
        (["--port", "9"], 1, "nobody answers"),
    ],
)
def test_what_cannot_be_run_is_one_clear_line(
    words: list[str], status: int, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", *words]) == status
    error = capsys.readouterr().err
    assert said in error and error.count("\n") == 1


def test_sticks_move_the_body_and_a_button_damps(tmp_path: Path) -> None:
    script = tmp_path / "remote.txt"
    script.write_text("1.5 press DOWN\n3.5 press B\n")
    robot, port = start("--remote", str(script), "--json", str(tmp_path / "robot.json"))
    run = controller(port, "--duration", "5", "--json", str(tmp_path / "run.json"))
    out, _ = run.communicate(timeout=60)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    result = json.loads((tmp_path / "run.json").read_text())
    assert (run.returncode, result["reason"]) == (3, "button"), out
    log = json.loads((tmp_path / "robot.json").read_text())["log"]
    heights = {round(t, 2): h for t, h in zip(log["time"], log["height"], strict=True)}
    assert heights[3.4] - heights[1.4] == pytest.approx(-0.03, abs=0.005)


def test_loss_and_delay_are_stood_and_loss_is_told_truly(tmp_path: Path) -> None:
    robot, port = start("--drop", "5", "--delay-ms", "4", "--json", str(tmp_path / "robot.json"))
    run = controller(port, "--duration", "4", "--json", str(tmp_path / "run.json"))
    out, _ = run.communicate(timeout=60)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    result = json.loads((tmp_path / "run.json").read_text())
    record = json.loads((tmp_path / "robot.json").read_text())
    assert (run.returncode, result["reason"]) == (0, "asked"), out
    lost, came = result["link"]["lost"], result["link"]["valid"]
    assert 0.03 < lost / (lost + came) < 0.07
    # The robot lost a few more before the first and after the last that came.
    assert lost <= record["lost_out"] < lost + 100
