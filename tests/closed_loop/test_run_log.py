# SPDX-License-Identifier: BSD-3-Clause
"""The log of the last ticks of surefoot run."""

from __future__ import annotations

import json
import signal
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import surefoot
from surefoot.cli import main
from surefoot.cli.run_log import write_run_log
from surefoot.estimate import read_log
from surefoot.sensor_log.column_definitions import CLOCK_COLUMNS
from virtual_robot_helpers import start_controller, start_robot


@pytest.mark.real_time
def test_run_log_keeps_the_last_second_and_is_readable_by_estimate(tmp_path: Path) -> None:
    file = str(tmp_path / "run.npz")
    script = tmp_path / "remote.txt"
    script.write_text("1.5 press B\n")
    robot, port = start_robot("--remote", str(script))
    run = start_controller(port, "--duration", "3", "--log", file, "--log-time", "1")
    out, err = run.communicate(timeout=60)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    assert (run.returncode, err) == (3, ""), out
    assert file in out
    log = np.load(file)
    steps = np.diff(log["run_time"])
    assert len(log["run_time"]) == 500 and (steps > 0.0).all() and steps.sum() < 1.1
    assert log["run_heard"].mean() > 0.9
    standing, damped = log["run_mode"] == "stand", log["run_mode"] == "damping"
    assert (standing | damped).all() and (np.diff(damped.astype(int)) >= 0).all()
    assert set(log["run_damping"][damped]) == {"button"}
    # The log ends half of --log-time after damping starts, so it keeps the ticks before.
    assert 230 < standing.sum() < 270
    # The motors report the sent torques one or two periods later, within their errors.
    felt = np.abs(log["tauEst"] - log["run_tau"])[standing]
    assert np.median(felt) < 1.0 < np.abs(log["run_tau"])[standing].max()
    assert np.all(log["run_tau"][damped] == 0.0)
    assert log["run_reports"].shape[1] == len(surefoot.LowState().raw)
    assert log["run_commands"].shape[1] == len(surefoot.LowCmd().raw)
    assert read_log(file).ignored == ()
    assert main(["estimate", file, "--robot", "go1", "--json", str(tmp_path / "out.json")]) == 0
    assert json.loads((tmp_path / "out.json").read_text())


@pytest.mark.real_time
def test_log_of_a_running_runner_is_refused() -> None:
    runner = surefoot.Runner(
        surefoot.load_robot("go1"),
        port=1,
        options=surefoot.RunOptions(log_time=1.0, connect_timeout=5.0),
    )
    loop = threading.Thread(target=runner.run)
    loop.start()
    while runner.real_time == "not running":
        time.sleep(0.01)
    with pytest.raises(surefoot.Error, match="log: got a call while run"):
        runner.log()
    runner.stop()
    loop.join()
    assert len(runner.log()) == 0 and runner.log().samples.shape == (0, 937)


def test_log_across_a_robot_restart_uses_the_run_clock(tmp_path: Path) -> None:
    ticks = [2**32 - 2, 0, 2, 4, 6]  # the tick wraps, which is no restart

    def written(ticks: list[int]) -> list[str]:
        samples = np.zeros((len(ticks), len(surefoot.LowState().raw)), dtype=np.uint8)
        for report, tick in zip(samples, ticks, strict=True):
            state = surefoot.LowState()
            state.tick = tick
            report[:] = state.raw
        log = SimpleNamespace(
            time=0.002 * np.arange(len(ticks)),
            has_new_state=np.ones(len(ticks), dtype=bool),
            mode=np.full(len(ticks), surefoot.Mode.STAND.value),
            velocity=np.zeros((len(ticks), 3)),
            gait=np.full(len(ticks), surefoot.Gait.AUTO.value),
            damping_fault=np.full(len(ticks), surefoot.FaultId.NONE.value),
            samples=samples,
            commands=np.zeros((len(ticks), len(surefoot.LowCmd().raw)), dtype=np.uint8),
        )
        write_run_log(str(tmp_path / "run.npz"), log)
        return [name for name in np.load(tmp_path / "run.npz").files if name in CLOCK_COLUMNS]

    assert written(ticks) == ["tick", "time"]
    assert written([*ticks, 2, 4]) == ["time"]
    assert read_log(str(tmp_path / "run.npz")).time[-1] == pytest.approx(0.012)


def test_invalid_log_options_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for words, said in (
        (["--log", str(tmp_path / "run.csv")], "expected a name ending in .npz"),
        (["--log", str(tmp_path / "no" / "run.npz")], "folder that can be written"),
        (["--log", str(tmp_path / "a.npz"), "--log-time", "601"], "'log_time' out of range"),
        (["--log", str(tmp_path / "a.npz"), "--log-time", "nan"], "expected above 0, up to 600"),
        (["--log", str(tmp_path / "a.npz"), "--log-time", "0"], "expected above 0, up to 600"),
        (["--log-time", "10"], "--log-time: got no --log"),
    ):
        assert main(["run", "--port", "1", *words]) == 2
        assert said in capsys.readouterr().err


def test_log_write_failure_does_not_fail_the_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> float:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("surefoot.cli.run.write_run_log", full)
    out = tmp_path / "out.json"
    robot, port = start_robot()
    log = str(tmp_path / "run.npz")
    words = ["--port", str(port), "--duration", "0.5", "--log", log, "--json", str(out)]
    status = main(["run", *words])
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    said = capsys.readouterr()
    assert status == 0 and json.loads(out.read_text())["stood_to_end"]
    assert "--log: [Errno 28] No space left on device" in said.err and "log of" not in said.out
