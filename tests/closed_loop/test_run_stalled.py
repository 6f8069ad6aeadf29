# SPDX-License-Identifier: BSD-3-Clause
"""surefoot run with stalls, a silent robot, a closed stdout and signals."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from paused_process import paused_process
from virtual_robot_helpers import (
    arm_again,
    restore_sigint,
    start_controller,
    start_robot,
    wait_for,
)

pytestmark = pytest.mark.real_time


def end(*processes: subprocess.Popen[str]) -> None:
    for process in processes:
        process.kill()
        process.wait(timeout=20)


def test_stalled_controller_damps_until_armed_again(tmp_path: Path) -> None:
    robot, port = start_robot()
    run = start_controller(port, "--json", str(tmp_path / "run.json"))
    wait_for(run, "standing")
    time.sleep(0.5)
    with paused_process(run):
        time.sleep(0.6)  # more samples than the system buffers
    assert "damping: away" in wait_for(run, "damping")
    time.sleep(0.5)
    arm_again(run)
    time.sleep(0.3)
    run.send_signal(signal.SIGINT)
    run.communicate(timeout=20)
    end(robot)
    result = json.loads((tmp_path / "run.json").read_text())
    # The robot lay when it was armed again, so it did not stand to the end.
    assert (run.returncode, result["dampings"] - result["pauses"], result["rearms"]) == (3, 1, 1)


@pytest.mark.parametrize("rate", [100, 500, 1000])
def test_silent_robot_is_stale_within_60_ms_at_every_rate(rate: int) -> None:
    robot, port = start_robot()
    run = start_controller(port, "--rate", str(rate))
    wait_for(run, "standing")
    time.sleep(0.3)
    with paused_process(robot):
        line = wait_for(run, "damping")
        found = re.search(r"stale: no LowState for (\d+) ms", line)
        # Detection can be late by one tick, 10 ms at 100 Hz, and by delays of the machine.
        assert found and 20 <= int(found[1]) <= 60, line
        run.send_signal(signal.SIGUSR1)
        wait_for(run, "not re-armed: no LowState for")
    end(run, robot)


def test_robot_paused_for_40_ms_continues_without_arming(tmp_path: Path) -> None:
    robot, port = start_robot()
    run = start_controller(port, "--json", str(tmp_path / "run.json"))
    wait_for(run, "standing")
    time.sleep(0.3)
    with paused_process(robot):
        time.sleep(0.04)
    wait_for(run, "resumed")
    time.sleep(0.5)
    run.send_signal(signal.SIGINT)
    run.communicate(timeout=20)
    end(robot)
    result = json.loads((tmp_path / "run.json").read_text())
    assert (run.returncode, result["reason"], result["rearms"]) == (0, "asked", 0)
    assert result["pauses"] >= 1 and result["tilt_deg"] < 2.0


def test_controller_survives_closed_stdout_and_ends_cleanly_on_sighup(tmp_path: Path) -> None:
    robot, port = start_robot()
    run = start_controller(port, "--json", str(tmp_path / "run.json"))
    wait_for(run, "standing")
    assert run.stdout is not None
    run.stdout.close()
    time.sleep(1.5)  # nothing reads its status line
    assert run.poll() is None
    run.send_signal(signal.SIGHUP)
    run.wait(timeout=20)
    end(robot)
    result = json.loads((tmp_path / "run.json").read_text())
    assert (run.returncode, result["reason"]) == (0, "asked")


def test_interrupt_before_any_robot_exits_with_status_1() -> None:
    run = start_controller(9)
    wait_for(run, "waiting")
    run.send_signal(signal.SIGINT)
    _, err = run.communicate(timeout=20)
    assert run.returncode == 1 and "no answer from" in err


def test_duration_counts_from_the_first_control_tick(tmp_path: Path) -> None:
    robot, port = start_robot()
    with paused_process(robot):
        run = start_controller(port, "--duration", "1", "--json", str(tmp_path / "run.json"))
        wait_for(run, "waiting")
        time.sleep(1.2)
    run.communicate(timeout=20)
    end(robot)
    result = json.loads((tmp_path / "run.json").read_text())
    assert run.returncode == 0
    assert result["ticks"] > 450 and result["time_s"] > 2.0


RUNNER = """
import surefoot, sys
runner = surefoot.Runner(surefoot.load_robot("go1"), port=int(sys.argv[1]))
print("running", flush=True)
try:
    runner.run()
except KeyboardInterrupt:
    print(runner.snapshot().phase, runner.snapshot().reason)
"""


def test_ctrl_c_ends_a_runner_in_the_main_thread_by_damping() -> None:
    robot, port = start_robot()
    run = subprocess.Popen(
        [sys.executable, "-c", RUNNER, str(port)],
        stdout=subprocess.PIPE,
        text=True,
        preexec_fn=restore_sigint,
    )
    wait_for(run, "running")
    time.sleep(0.5)
    run.send_signal(signal.SIGINT)
    out, _ = run.communicate(timeout=20)
    end(robot)
    assert out.split() == ["ended", "asked"]
