# SPDX-License-Identifier: BSD-3-Clause
"""surefoot run refuses robots of another frame generation and invalid arguments."""

from __future__ import annotations

import json
import signal
import socket
import threading
from pathlib import Path

import pytest
import surefoot
from surefoot import protocol
from surefoot.cli import main
from virtual_robot_helpers import start_controller, start_robot

pytestmark = pytest.mark.real_time


class WrongGenerationRobot:
    """A fake robot that replies to every datagram with a LowState of one generation."""

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

    def __enter__(self) -> WrongGenerationRobot:
        self.thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.going = False
        self.thread.join()
        self.socket.close()


@pytest.mark.parametrize("wanted", protocol.GENERATIONS)
@pytest.mark.parametrize("spoken", protocol.GENERATIONS)
def test_run_generation_mismatch_names_both_generations(
    wanted: str, spoken: str, capsys: pytest.CaptureFixture[str]
) -> None:
    if wanted == spoken:
        pytest.skip("the generations are equal")
    with WrongGenerationRobot(spoken) as robot:
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
        (["--robot", "go2"], 2, "choose a generation"),
        (["--power-level", "11"], 2, "0 .. 10"),
        (["--rate", "5"], 2, "100 .. 1000"),
        (["--port", "70000"], 2, "70000"),
        (["--port", "9"], 1, "no answer from"),
    ],
)
def test_invalid_run_arguments_give_one_error_line(
    words: list[str], status: int, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", *words]) == status
    error = capsys.readouterr().err
    assert said in error and error.count("\n") == 1


def test_run_without_rise_refuses_a_lying_robot(tmp_path: Path) -> None:
    robot, port = start_robot("--lying", "--json", str(tmp_path / "robot.json"))
    run = start_controller(port, "--duration", "3", "--json", str(tmp_path / "run.json"))
    out, err = run.communicate(timeout=60)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    result = json.loads((tmp_path / "run.json").read_text())
    assert (run.returncode, result["reason"], result["stood"]) == (3, "not_standing", False), out
    assert "did not stand to the end" in out
    assert "expected a standing robot; use --rise" in err
    kd = json.loads((tmp_path / "robot.json").read_text())["log"]["command_kd"]
    assert all(min(values) > 0.0 for values in kd if values)
