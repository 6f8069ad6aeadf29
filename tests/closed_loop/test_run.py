# SPDX-License-Identifier: BSD-3-Clause
"""surefoot run with surefoot robot, in two processes."""

from __future__ import annotations

import json
import signal
import time
from pathlib import Path

import pytest
from surefoot import protocol
from virtual_robot_helpers import arm_again, start_controller, start_robot, wait_for

pytestmark = pytest.mark.real_time


@pytest.mark.parametrize("name", ["a1", "go1", "b1"])
def test_a_robot_stands_over_udp_in_its_own_generation(name: str, tmp_path: Path) -> None:
    robot, port = start_robot("--robot", name, "--json", str(tmp_path / "robot.json"))
    run = start_controller(
        port, "--robot", name, "--duration", "3", "--json", str(tmp_path / "run.json")
    )
    out, err = run.communicate(timeout=60)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    assert (run.returncode, err) == (0, ""), out
    result = json.loads((tmp_path / "run.json").read_text())
    record = json.loads((tmp_path / "robot.json").read_text())
    assert result["generation"] == protocol.default_generation(name)
    assert result["reason"] == "asked" and result["link"]["corrupt"] == 0
    assert record["rejected"] == {}
    # After the run, damping lowers a heavy robot before the robot's process ends.
    log = record["log"]
    pairs = zip(log["time"], log["command_kd"], strict=True)
    torque_until = max(time for time, kd in pairs if kd and max(kd) == 0.0)
    # The robot's clock starts with its first sample, one or two periods before or after the
    # controller's clock. The record has one row per 10 ms.
    assert torque_until > 2.95
    assert record["fell_at"] is None or record["fell_at"] > torque_until
    assert result["link"]["valid"] + result["link"]["lost"] > 2500
    assert result["greatest_power_w"] < 100.0


def test_killed_robot_is_stale_and_returns_only_after_arming(
    tmp_path: Path,
) -> None:
    robot, port = start_robot()
    run = start_controller(port, "--json", str(tmp_path / "run.json"))
    wait_for(run, "standing")
    time.sleep(0.5)
    robot.kill()
    wait_for(run, "damping: stale")
    again, _ = start_robot("--port", str(port))
    time.sleep(1.0)
    arm_again(run)
    time.sleep(0.5)
    run.send_signal(signal.SIGINT)
    _, err = run.communicate(timeout=20)
    again.kill()
    result = json.loads((tmp_path / "run.json").read_text())
    # The second robot sank while its motors damped. It did not stand to the end.
    assert (run.returncode, err) == (3, "")
    assert (result["dampings"] - result["pauses"], result["rearms"]) == (1, 1)


def test_killed_controller_leaves_damping_motors(tmp_path: Path) -> None:
    robot, port = start_robot("--json", str(tmp_path / "robot.json"))
    run = start_controller(port)
    wait_for(run, "standing")
    time.sleep(0.5)
    run.kill()
    time.sleep(0.5)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    record = json.loads((tmp_path / "robot.json").read_text())
    assert record["damping"], record.keys()


def test_remote_arrow_moves_the_body_and_button_b_damps(tmp_path: Path) -> None:
    script = tmp_path / "remote.txt"
    script.write_text("1.5 press DOWN\n3.5 press B\n")
    robot, port = start_robot("--remote", str(script), "--json", str(tmp_path / "robot.json"))
    run = start_controller(port, "--duration", "5", "--json", str(tmp_path / "run.json"))
    out, _ = run.communicate(timeout=60)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    result = json.loads((tmp_path / "run.json").read_text())
    assert (run.returncode, result["reason"]) == (3, "button"), out
    log = json.loads((tmp_path / "robot.json").read_text())["log"]
    heights = {round(t, 2): h for t, h in zip(log["time"], log["height"], strict=True)}
    assert heights[3.4] - heights[1.4] == pytest.approx(-0.03, abs=0.005)


def test_robot_stands_with_5_percent_loss_and_4_ms_delay(tmp_path: Path) -> None:
    robot, port = start_robot(
        "--drop", "5", "--delay-ms", "4", "--json", str(tmp_path / "robot.json")
    )
    run = start_controller(port, "--duration", "4", "--json", str(tmp_path / "run.json"))
    out, _ = run.communicate(timeout=60)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    result = json.loads((tmp_path / "run.json").read_text())
    record = json.loads((tmp_path / "robot.json").read_text())
    assert (run.returncode, result["reason"]) == (0, "asked"), out
    lost, came = result["link"]["lost"], result["link"]["valid"]
    assert 0.03 < lost / (lost + came) < 0.07
    # The run does not count samples lost before the first and after the last received one.
    assert lost <= record["lost_out"] < lost + 100
