# SPDX-License-Identifier: BSD-3-Clause
"""surefoot run and surefoot robot as processes that speak DDS on loopback."""

from __future__ import annotations

import itertools
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import surefoot

pytestmark = pytest.mark.real_time

_domains = itertools.count(200)
ERROR = 2  # exit status after a wrong argument
NO_LIBRARY = "libddsc (Cyclone DDS): got none of "  # beginning of the error where it is missing


@pytest.fixture
def domain() -> Iterator[int]:
    """A domain of this test alone; the test is skipped where libddsc is missing."""
    domain = next(_domains)
    try:
        surefoot.DdsNetwork("lo", domain)
    except surefoot.Error as problem:
        if not str(problem).startswith(NO_LIBRARY):
            raise
        pytest.skip(str(problem))
    yield domain


class Command:
    """A process of surefoot."""

    def __init__(self, *arguments: object) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-u", "-m", "surefoot", *map(str, arguments)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self._lines: list[str] = []

    def wait_for(self, text: str) -> None:
        """Wait until the process prints a text."""
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self._lines.append(line)
            if text in line:
                return
        pytest.fail(f"'{text}' was not printed:\n{''.join(self._lines)}")

    def kill(self) -> None:
        os.kill(self._process.pid, signal.SIGKILL)

    def finish(self) -> tuple[int, str]:
        """Wait for the end; return the exit status and the whole output."""
        output, _ = self._process.communicate(timeout=60)
        return self._process.returncode, "".join(self._lines) + output


def robot(domain: int, *arguments: object) -> Command:
    command = Command("robot", "--sdk", "go2", "--domain", domain, *arguments)
    command.wait_for("listening on DDS domain")
    return command


def run(domain: int, *arguments: object) -> Command:
    return Command("run", "--sdk", "go2", "--domain", domain, *arguments)


def read(path: Path) -> dict[str, Any]:
    return dict(json.loads(path.read_text()))


def test_go2_rises_stands_and_sits_and_its_sport_service_is_given_back(
    domain: int, tmp_path: Path
) -> None:
    robot_file, run_file = tmp_path / "robot.json", tmp_path / "run.json"
    there = robot(domain, "--lying", "--duration", 30, "--json", robot_file)
    here = run(
        domain, "--rise", "--yes", "--duration", 1, "--power-level", 5, "--give-back",
        "--json", run_file,
    )  # fmt: skip
    status, output = here.finish()
    assert status == 0, output
    for line in (
        "mode 'normal' is active, releasing it",
        "the low level is free",
        "mode 'normal' is active again",
    ):
        assert line in output
    there._process.send_signal(signal.SIGINT)
    _, robot_output = there.finish()
    record = read(robot_file)
    assert record["rejected"] == {"blank": 0, "wrong crc": 0, "not finite": 0}
    assert record["commands"] > 3000
    assert read(run_file)["stood_to_end"]
    assert robot_output.count("motor servo") + robot_output.count("motors servo") > 3


def test_robot_damps_20_ms_after_the_last_command(domain: int, tmp_path: Path) -> None:
    there = robot(
        domain, "--duration", 20, "--no-motion-switcher", "--json", tmp_path / "r.json",
        "--log-rate", 500,
    )  # fmt: skip
    here = run(domain, "--no-motion-switcher")
    here.wait_for("standing")
    time.sleep(1.0)
    here.kill()
    there.wait_for("motors damp")
    there._process.send_signal(signal.SIGINT)
    there.finish()
    record = read(tmp_path / "r.json")
    assert len(record["damping"]) == 1
    log, start = record["log"], record["damping"][0][0]
    times, torques = log["time"], log["command_tau"]
    # The torques of a standing robot change with every command.
    last_command = max(
        times[k] for k in range(1, len(times)) if times[k] < start and torques[k] != torques[k - 1]
    )
    assert 0.016 <= start - last_command <= 0.024


def test_second_robot_and_commander_are_refused_and_run_damps_20_ms_after_the_last_state(
    domain: int,
) -> None:
    there = robot(domain, "--no-motion-switcher")
    first = run(domain, "--no-motion-switcher", "--duration", 30)
    first.wait_for("standing")
    second_robot = Command("robot", "--sdk", "go2", "--domain", domain)
    second = run(domain, "--no-motion-switcher")
    status, output = second_robot.finish()
    assert status == ERROR
    assert f"process python (pid {there._process.pid})" in output
    status, output = second.finish()
    assert status == ERROR
    assert f"rt/lowcmd: got 1 other writer(s) (process python (pid {first._process.pid})" in output
    there.kill()
    first.wait_for("no valid LowState for 0.1 s from process python")
    first._process.send_signal(signal.SIGINT)
    _, output = first.finish()
    found = re.search(r"damping: stale: no LowState for (\d+) ms", output)
    assert found is not None, output
    assert 20 <= int(found[1]) <= 40
    assert output.count("damping: ") == 1, output  # the second commander caused none
    there.finish()


def test_run_damps_and_cannot_be_armed_when_the_sport_service_begins_again(domain: int) -> None:
    there = robot(domain)
    here = run(domain, "--duration", 30)
    here.wait_for("standing")
    program = (
        "import surefoot\n"
        "from surefoot.motion_switcher import MotionSwitcher\n"
        f"MotionSwitcher(surefoot.DdsNetwork('lo', {domain})).select_mode('normal')\n"
    )
    subprocess.run([sys.executable, "-c", program], check=True, timeout=30)
    here.wait_for("damping: conflict")
    here._process.send_signal(signal.SIGUSR1)
    here.wait_for("not re-armed")
    time.sleep(0.3)
    here._process.send_signal(signal.SIGINT)
    status, output = here.finish()
    assert status == 3
    assert re.search(r"not re-armed: arming checks fail: .*\bconflict\b", output), output
    assert "damping: conflict: another program commands the robot" in output
    assert "writer of rt/lowcmd found: process python" in output
    there.kill()
    there.finish()


def test_missing_motion_switcher_is_an_error_of_a_simulation(domain: int) -> None:
    status, output = run(domain).finish()
    assert status == ERROR
    assert "motion switcher: got no answer" in output
    assert "--no-motion-switcher" in output


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (("--interface", "nosuch0"), "network interface 'nosuch0': got no such interface"),
        (("--libddsc", "/nowhere.so"), "pip install 'surefoot[dds]'"),
        (("--domain", 231), "DDS domain: got 231, expected 0 .. 230"),
        (("--robot", "go2", "--sdk", "b2"), "--sdk: got b2 with robot go2, expected go2"),
        (
            ("--rise", "--yes", "--real-robot", "--no-motion-switcher", "--interface", "lo"),
            "--no-motion-switcher: got --real-robot, expected a simulation",
        ),
    ],
)
def test_bad_argument_is_refused_in_one_line(
    domain: int, arguments: tuple[object, ...], text: str
) -> None:
    status, output = run(domain, *arguments).finish()
    assert status == ERROR
    assert text in output.splitlines()[-1]
