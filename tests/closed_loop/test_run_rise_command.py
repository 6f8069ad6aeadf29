# SPDX-License-Identifier: BSD-3-Clause
"""surefoot run --rise with surefoot robot --lying, in two processes: keys, signals, options."""

from __future__ import annotations

import json
import os
import pty
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from surefoot.cli import main
from virtual_robot_helpers import start_controller, start_robot, wait_for

pytestmark = pytest.mark.real_time

LYING = ("--lying", "--seed", "9")


class Terminal:
    """surefoot run in its own terminal, in which the test presses keys."""

    def __init__(self, port: int, *words: str) -> None:
        command = [sys.executable, "-m", "surefoot.cli", "run", "--port", str(port), *words]
        self.pid, self.keys = pty.fork()
        if self.pid == 0:
            os.execv(sys.executable, command)
        self._screen = b""

    def press(self, keys: str) -> None:
        os.write(self.keys, keys.encode())

    def shows(self, words: str, seconds: float = 30.0) -> str:
        """Read lines until one has the words; return that line."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            line, found, rest = self._screen.partition(b"\r\n")
            if not found:
                self._screen += os.read(self.keys, 4096)
                continue
            self._screen = rest
            if words in line.decode():
                return line.decode()
        raise AssertionError(f"'{words}' was not shown in {seconds:g} s")

    def arm(self) -> None:
        """Wait until the robot is ready, then arm it."""
        self.shows(" ready")
        self.press("a\n")
        self.shows("ready, armed")

    def begin_rise(self) -> None:
        """Arm the robot and let it rise until its legs fold."""
        self.arm()
        self.press("u\n")
        self.shows(" rising")
        time.sleep(0.5)

    def status(self) -> int:
        """Wait for the process to end; return its exit status."""
        try:
            while os.read(self.keys, 4096):
                pass
        except OSError:  # the other end is closed
            os.close(self.keys)
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


@contextmanager
def lying_robot(*words: str) -> Iterator[tuple[subprocess.Popen[str], int]]:
    robot, port = start_robot(*LYING, *words)
    try:
        yield robot, port
    finally:
        robot.kill()
        robot.wait(timeout=20)


def test_operator_keys_arm_rise_and_sit_the_robot() -> None:
    with lying_robot() as (_, port):
        terminal = Terminal(port, "--rise")
        terminal.shows(" passive")
        terminal.press("u\n")
        terminal.shows("up refused: not armed")
        terminal.arm()
        terminal.press("wave\n")
        terminal.shows("'wave': unknown key: x + Enter damps, d sits down, a + Enter arms, u rises")
        terminal.press("a\n")
        terminal.shows("armed already: u rises")
        terminal.press("q\n")
        terminal.shows("joints [rad] FR ")
        terminal.press("u\n")
        terminal.shows(" rising")
        terminal.shows(" standing")
        time.sleep(0.5)  # until the torques have faded in
        terminal.press("\x04u\n")  # Ctrl-D does not end the run
        terminal.shows("keys still work")
        terminal.shows("up refused: not while standing: w walks, d sits down")
        terminal.press("d\n")
        terminal.shows(" sitting")
        terminal.shows(" passive")
        terminal.press("x\n")
        terminal.shows(" damping: asked")
        terminal.press("\x03")
        terminal.shows("ended")
        assert terminal.status() == 0


@pytest.mark.parametrize("typed", ["dxX\n"])
def test_any_line_containing_x_damps(typed: str) -> None:
    with lying_robot() as (_, port):
        terminal = Terminal(port, "--rise")
        terminal.begin_rise()
        terminal.press(typed)
        terminal.shows(" damping: asked")
        terminal.press("\x03")
        terminal.shows("robot did not stand to the end")
        assert terminal.status() == 3


def test_ctrl_backslash_exits_with_status_3() -> None:
    with lying_robot() as (_, port):
        terminal = Terminal(port, "--rise")
        terminal.begin_rise()
        terminal.press("\x1c")
        terminal.shows("robot did not stand to the end")
        assert terminal.status() == 3


def test_hung_terminal_ends_the_rise_and_its_keys_are_ignored() -> None:
    with lying_robot() as (_, port):
        terminal = Terminal(port, "--rise")
        terminal.begin_rise()
        terminal.press("\x13")  # Ctrl-S: the terminal accepts no more output
        time.sleep(3.5)  # longer than the operator timeout and the pause before the next output
        terminal.press("u\n")
        time.sleep(0.5)
        terminal.press("\x11")
        terminal.shows("keys typed meanwhile are ignored")
        terminal.shows("fault operator")
        terminal.shows(" passive")
        terminal.press("\x03")
        terminal.shows("ended")
        assert terminal.status() == 3  # it did not stand to the end


def test_automatic_rise_stands_for_its_duration_and_sits_down(tmp_path: Path) -> None:
    with lying_robot("--json", str(tmp_path / "robot.json")) as (robot, port):
        words = ("--rise", "--yes", "--duration", "1", "--json", str(tmp_path / "run.json"))
        run = start_controller(port, *words)
        out, err = run.communicate(timeout=60)
        robot.send_signal(signal.SIGTERM)
        robot.wait(timeout=20)
    assert (run.returncode, err) == (0, ""), out
    phases = re.findall(r"s (passive|rising|standing|sitting|ended)$", out, re.MULTILINE)
    assert phases == ["passive", "rising", "standing", "sitting", "passive", "ended"]
    result = json.loads((tmp_path / "run.json").read_text())
    assert (result["reason"], result["mode"], result["stood"]) == ("asked", "PASSIVE", True)
    record = json.loads((tmp_path / "robot.json").read_text())
    assert record["lying"] and not record["fell"] and record["rejected"] == {}
    assert record["log"]["height"][-1] < 0.1 < 0.25 < max(record["log"]["height"])


def test_first_ctrl_c_sits_down_and_the_second_damps(tmp_path: Path) -> None:
    with lying_robot() as (_, port):
        run = start_controller(port, "--rise", "--yes", "--json", str(tmp_path / "run.json"))
        wait_for(run, " standing")
        time.sleep(0.5)
        run.send_signal(signal.SIGINT)
        wait_for(run, " sitting")
        run.send_signal(signal.SIGINT)
        wait_for(run, " ended")
        run.communicate(timeout=20)
    result = json.loads((tmp_path / "run.json").read_text())
    assert (result["reason"], result["mode"]) == ("asked", "SIT")


def test_failed_arming_checks_are_printed() -> None:
    with lying_robot("--drop", "5") as (_, port):
        run = start_controller(port, "--rise", "--yes", "--duration", "1")
        line = wait_for(run, "not ready")
        assert re.search(r"not ready: link: \S+ % of the samples missing, expected below 1 %", line)
        time.sleep(2.0)
        run.send_signal(signal.SIGUSR1)
        wait_for(run, "not re-armed: arming checks fail")
        run.send_signal(signal.SIGINT)
        out, _ = run.communicate(timeout=20)
    assert run.returncode == 3 and "rising" not in out


def test_hung_robot_sits_down_and_exits_with_status_3() -> None:
    robot, port = start_robot("--hung")
    run = start_controller(port, "--rise", "--yes", "--duration", "1")
    out, _ = run.communicate(timeout=60)
    robot.kill()
    robot.wait(timeout=20)
    assert run.returncode == 3, out
    phases = re.findall(r"s (passive|rising|standing|sitting|ended)$", out, re.MULTILINE)
    assert phases == ["passive", "rising", "sitting", "passive", "ended"]
    assert out.count("fault hanging") == 1


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--rise"], "--yes"),
        (["--yes"], "--rise"),
        (["--rise", "--yes", "--power-level", "0"], "power_level"),
        (["--real-robot", "--host", "192.168.123.10"], "--rise"),
        (["--rise", "--yes", "--host", "192.168.123.10"], "--real-robot"),
        (["--rise", "--yes", "--real-robot", "--no-remote"], "to stop the robot"),
        (["--predict-ms", "60"], "--predict-ms: got 60, expected 0 .. 50 [ms]"),
    ],
)
def test_invalid_rise_arguments_give_one_error_line(
    words: list[str],
    said: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("surefoot.cli.run_checks.has_keyboard", bool)
    assert main(["run", *words]) == 2
    error = capsys.readouterr().err
    assert said in error and error.count("\n") == 1
