# SPDX-License-Identifier: BSD-3-Clause
"""Every command in a hostile process: closed streams, Ctrl-C, wrong MUJOCO_GL, other locales."""

from __future__ import annotations

import os
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_list import ARGUMENTS, call, command_line, command_names

pytestmark = pytest.mark.slow

COMMANDS = sorted(ARGUMENTS)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("commands")
    words = [sys.executable, "-m", "surefoot", "stand", "--duration", "0.5", "--log"]
    subprocess.run([*words, str(path / "run.npz")], check=True, capture_output=True)
    return path


@pytest.fixture(scope="module")
def results(folder) -> dict[str, subprocess.CompletedProcess[str]]:
    """Return the result of every command in an ordinary process."""
    return {name: call(name, folder) for name in COMMANDS}


def test_every_command_of_the_parser_is_tested() -> None:
    assert sorted(command_names()) == COMMANDS


@pytest.mark.parametrize("name", COMMANDS)
def test_ordinary_process_ends_with_a_result_or_one_error_line(name, results) -> None:
    done = results[name]
    assert done.returncode in (0, 2)
    if done.returncode == 2:
        assert done.stderr.startswith("surefoot") and done.stderr.count("\n") == 1


@pytest.mark.parametrize("closed", ["1", "2", "0 1 2"])
@pytest.mark.parametrize("name", COMMANDS)
def test_closed_streams_change_no_status_and_print_no_traceback(
    name, closed, results, folder
) -> None:
    redirections = " ".join(f"{number}>&-" for number in closed.split())
    line = f"{shlex.join(command_line(name, folder))} {redirections}"
    done = subprocess.run(
        ["sh", "-c", line], capture_output=True, text=True, timeout=120, cwd=folder
    )
    assert done.returncode == results[name].returncode
    assert "Traceback" not in done.stderr and "Exception" not in done.stderr


@pytest.mark.parametrize("number", [1, 2])
@pytest.mark.parametrize("name", COMMANDS)
def test_stream_whose_reader_has_closed_causes_no_traceback(name, number, folder) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    streams = {1: "stdout", 2: "stderr"}
    given = {stream: subprocess.PIPE for stream in streams.values()} | {streams[number]: writer}
    done = subprocess.run(command_line(name, folder), text=True, timeout=120, cwd=folder, **given)
    os.close(writer)
    text = (done.stdout or "") + (done.stderr or "")
    assert "Traceback" not in text and "Exception" not in text
    assert done.returncode in (0, 1, 2)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no /dev/full")
@pytest.mark.parametrize("name", ["gains", "robots", "faults", "stand"])
def test_full_disk_at_stdout_is_reported_in_one_line(name, folder) -> None:
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            command_line(name, folder), stdout=full, stderr=subprocess.PIPE, text=True, cwd=folder
        )
    assert done.returncode == 1
    assert done.stderr == "surefoot: error: [Errno 28] No space left on device\n"


@pytest.mark.parametrize("delay", [0.0, 0.25])
@pytest.mark.parametrize("name", COMMANDS)
def test_interrupted_command_ends_with_one_line_and_status_130(name, delay, folder) -> None:
    process = subprocess.Popen(
        command_line(name, folder),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=folder,
        start_new_session=True,
    )
    wait_for_imports(process)
    time.sleep(delay)
    sent = time.monotonic()
    os.killpg(process.pid, signal.SIGINT)
    _, stderr = process.communicate(timeout=60)
    assert time.monotonic() - sent < 3.0
    assert "Traceback" not in stderr and "Exception" not in stderr
    if process.returncode == 130:
        assert stderr.endswith("surefoot: error: interrupted\n")
    else:  # a command or Python itself was ending, or surefoot robot, which Ctrl-C ends
        assert process.returncode in (0, 2, -signal.SIGINT)


def wait_for_imports(process: subprocess.Popen[str]) -> None:
    """Wait until a process imports the package; Python itself prints a traceback before."""
    while process.poll() is None and "/surefoot/_core." not in _maps(process.pid):
        time.sleep(0.001)


def _maps(pid: int) -> str:
    try:
        return Path(f"/proc/{pid}/maps").read_text()
    except OSError:  # the process has ended
        return ""


@pytest.mark.parametrize("group", [True, False], ids=["terminal", "kill"])
@pytest.mark.parametrize(
    "words", ["tune search --jobs 2", "faults --jobs 2", "assess --quick --jobs 2", "bench"]
)
def test_interrupted_work_ends_within_3_s_with_its_workers(words, group, tmp_path) -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "surefoot", *words.split()],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=tmp_path,
        start_new_session=True,
    )
    time.sleep(6.0)  # the workers run
    sent = time.monotonic()
    (os.killpg if group else os.kill)(process.pid, signal.SIGINT)
    _, stderr = process.communicate(timeout=60)
    assert process.returncode == 130 and stderr.endswith("surefoot: error: interrupted\n")
    assert "Traceback" not in stderr
    while members(process.pid):
        assert time.monotonic() - sent < 3.0
        time.sleep(0.05)


def members(group: int) -> list[str]:
    """Return the processes of a group that still run."""
    found = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, number = path.read_text().rpartition(")")[2].split()[:3]
        except (OSError, ValueError):  # the process has ended
            continue
        if int(number) == group and state != "Z":
            found.append(path.parent.name)
    return found


@pytest.mark.parametrize(
    ("name", "value"),
    [*((name, "foo") for name in COMMANDS), ("stand", "osmesa"), ("stand", "glfw")],
)
def test_wrong_graphics_do_not_matter_without_pictures(name, value, results, folder) -> None:
    environment = {"MUJOCO_GL": value, "DISPLAY": "", "WAYLAND_DISPLAY": ""}
    done = call(name, folder, **environment)
    assert (done.returncode, done.stderr.count("\n")) == (
        results[name].returncode,
        results[name].stderr.count("\n"),
    )


@pytest.mark.parametrize("value", ["foo", "glfw"])
@pytest.mark.parametrize("command", ["stand", "assess", "tune search"])
def test_wrong_graphics_for_pictures_are_refused_with_the_remedy(command, value, tmp_path) -> None:
    line = [sys.executable, "-m", "surefoot", *command.split(), "--report", "report"]
    environment = os.environ | {"MUJOCO_GL": value, "DISPLAY": "", "WAYLAND_DISPLAY": ""}
    done = subprocess.run(line, capture_output=True, text=True, cwd=tmp_path, env=environment)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(f"surefoot: error: MUJOCO_GL: got '{value}'")
    assert done.stderr.count("\n") == 1 and "run: unset MUJOCO_GL" in done.stderr


@pytest.mark.parametrize(
    "environment",
    [{"LC_ALL": "C"}, {"LC_ALL": "C", "PYTHONUTF8": "0"}],
    ids=["C", "C without Python's UTF-8 mode"],
)
@pytest.mark.parametrize("name", COMMANDS)
def test_paths_of_any_bytes_cause_no_traceback_in_any_locale(
    name, environment, results, folder
) -> None:
    place = folder / "Füße-犬"
    place.mkdir(exist_ok=True)
    (place / "run.npz").write_bytes((folder / "run.npz").read_bytes())
    line = [os.fsencode(word) for word in command_line(name, place)]
    done = subprocess.run(line, capture_output=True, env=os.environ | environment, cwd=folder)
    assert b"Traceback" not in done.stderr
    assert done.returncode == results[name].returncode, done.stderr


def test_report_and_results_are_written_to_a_path_of_any_bytes(tmp_path) -> None:
    place = os.fsencode(tmp_path) + b"/\xff\xfe"
    os.mkdir(place)
    line = [sys.executable, "-m", "surefoot", "stand", "--duration", "0.1"]
    words = [b"--json", place + b"/out.json", b"--log", place + b"/log.npz", b"--report", place]
    done = subprocess.run(
        [*map(os.fsencode, line), *words], capture_output=True, env=os.environ | {"LC_ALL": "C"}
    )
    assert done.returncode == 0, done.stderr
    assert {b"out.json", b"log.npz", b"index.html"} <= set(os.listdir(place))
