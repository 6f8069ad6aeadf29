# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import json
import signal
import socket
from pathlib import Path

import numpy as np
import pytest
from surefoot.cli import main
from virtual_robot_helpers import UdpClient, servo, start_robot

pytestmark = pytest.mark.real_time

POSE = (0.0, 1.2, -2.0)


@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGINT])
def test_udp_client_drives_the_robot_and_a_signal_writes_the_record(
    how: signal.Signals, tmp_path: Path
) -> None:
    file = tmp_path / "robot.json"
    process, port = start_robot("--hung", "--json", str(file))
    states = UdpClient(port).run(1.5, servo(POSE))
    process.send_signal(how)
    out, err = process.communicate(timeout=20)
    assert (process.returncode, err) == (0, "")
    assert "first valid command" in out and "power" in out
    angles = [states[-1].motorState[i].q for i in range(12)]
    np.testing.assert_allclose(angles, POSE * 4, atol=0.2)
    ticks = np.diff([state.tick for state in states])
    assert (ticks >= 1).all() and np.median(ticks) == 1
    record = json.loads(file.read_text())
    assert record["commands"] > 300 and record["rejected"] == {}
    assert record["real_time_factor"] > 0.5
    assert len(record["log"]["q"]) == len(record["log"]["time"]) > 100


def test_robot_process_ends_after_its_duration(tmp_path: Path) -> None:
    file = tmp_path / "robot.json"
    process, _ = start_robot("--duration", "0.3", "--json", str(file), "--log-rate", "50")
    assert process.wait(timeout=20) == 0
    record = json.loads(file.read_text())
    assert record["duration"] == pytest.approx(0.3)
    assert len(record["log"]["time"]) == 15


def test_robot_port_in_use_gives_one_error_line_and_status_1(capsys) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        port = taken.getsockname()[1]
        assert main(["robot", "--port", str(port), "--duration", "1"]) == 1
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert f"127.0.0.1:{port}" in error and "in use" in error


BAD = {
    "unknown robot": (["--robot", "go7"], "go7"),
    "unknown generation": (["--sdk", "go9"], "go1-v3.8"),
    "no generation": (["--robot", "go2"], "generation"),
    "no address": (["--bind", "999.1.1.1"], "bind"),
    "a foreign address": (["--bind", "192.0.2.1"], "bind"),
    "no port": (["--port", "70000"], "port"),
    "too fast": (["--rate", "2000"], "rate"),
    "period not in whole milliseconds": (["--rate", "333"], "rate"),
    "loss above 100 %": (["--drop", "101"], "drop"),
    "negative delay": (["--delay-ms", "-1"], "delay"),
    "infinite jitter": (["--jitter-ms", "inf"], "jitter"),
    "negative timeout": (["--timeout-ms", "-5"], "timeout"),
    "bad shake": (["--shake", "tail:1:1@1"], "shake"),
    "missing script": (["--remote", "nowhere.txt"], "nowhere.txt"),
    "zero duration": (["--duration", "0"], "duration"),
    "negative seed": (["--seed", "-1"], "seed"),
    "record on stdout": (["--json", "-"], "--json"),
    "window and none": (["--view", "--headless"], "not allowed"),
}


@pytest.mark.parametrize("case", BAD)
def test_invalid_robot_argument_gives_one_error_line_and_status_2(case: str, capsys) -> None:
    words, expected = BAD[case]
    assert main(["robot", "--port", "0", "--duration", "0.01", *words]) == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert expected in error


def test_view_without_a_display_gives_status_2(monkeypatch, capsys) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    assert main(["robot", "--port", "0", "--view"]) == 2
    assert "no display" in capsys.readouterr().err
