# SPDX-License-Identifier: BSD-3-Clause
"""surefoot doctor: each check judges what it finds, and says what to do."""

from __future__ import annotations

import json
import os
import platform
import resource
from pathlib import Path

import numpy as np
import pytest
from surefoot.cli import main
from surefoot.doctor import (
    AREAS,
    Finding,
    Verdict,
    diagnose,
    findings_text,
    installation,
    network,
    real_time,
    simulation,
)
from surefoot.system import library_check


def subjects(findings: list[Finding]) -> dict[str, Finding]:
    return {finding.subject: finding for finding in findings}


@pytest.fixture(scope="module")
def here() -> list[Finding]:
    return diagnose(timer_seconds=0.05)


def test_this_computer_has_findings_in_every_area_and_no_bad_one(here: list[Finding]) -> None:
    assert {finding.area for finding in here} == set(AREAS)
    assert all(finding.value for finding in here)
    assert not [finding for finding in here if finding.verdict == Verdict.BAD]
    found = subjects(here)
    assert found["plant"].verdict == Verdict.GOOD
    assert "libpinocchio_default.so" in found["libpinocchio"].value


def test_every_limited_or_bad_finding_has_a_remedy(here: list[Finding]) -> None:
    for finding in here:
        if finding.verdict in (Verdict.LIMITED, Verdict.BAD):
            assert finding.remedy, finding


def test_text_has_each_finding_and_its_remedy_once(here: list[Finding]) -> None:
    bad = Finding("network", "interface can0", "up", Verdict.BAD, "unplug it")
    text = findings_text([*here, bad])
    for finding in here:
        assert finding.value in text
    assert "BAD interface can0" in text and text.count("-> unplug it") == 1


def test_missing_package_names_its_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installation, "package_version", lambda name: None)
    found = subjects(installation.check_installation())
    assert found["casadi"].verdict == Verdict.LIMITED
    assert "pip install 'surefoot[tune]'" in found["casadi"].remedy


def test_two_copies_of_pinocchio_are_bad(monkeypatch: pytest.MonkeyPatch) -> None:
    copies = [Path("/a/libpinocchio_default.so"), Path("/b/libpinocchio_default.so")]
    monkeypatch.setattr(installation, "loaded_libraries", lambda name: copies)
    finding = subjects(installation.check_installation())["libpinocchio"]
    assert finding.verdict == Verdict.BAD and "/b/" in finding.value
    assert "unset LD_LIBRARY_PATH" in finding.remedy


def test_loaded_libraries_are_those_of_this_process() -> None:
    import surefoot  # noqa: F401

    (path,) = library_check.loaded_libraries("libsurefoot.so")
    assert path.is_file()
    assert library_check.loaded_libraries("libdoes_not_exist") == []


def test_ros_in_the_python_path_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installation, "_check_ddsc", lambda: Finding("", "", "", Verdict.INFO))
    monkeypatch.setenv("PYTHONPATH", "/opt/ros/humble/lib/python3.10/site-packages")
    finding = subjects(installation.check_installation())["PYTHONPATH"]
    assert finding.verdict == Verdict.LIMITED and "unset PYTHONPATH" in finding.remedy


def test_user_without_rights_gets_the_lines_for_limits_conf(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    monkeypatch.setattr(resource, "getrlimit", lambda which: (0, 0))
    found = subjects(real_time.check_real_time(0.01))
    assert "* - rtprio 80" in found["SCHED_FIFO, priority 80"].remedy
    assert "* - memlock unlimited" in found["locked memory"].remedy


def test_processor_without_avx_cannot_simulate(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(real_time, "_processor_flags", lambda: {"sse2", "sse4_2"})
    monkeypatch.setattr(platform, "machine", lambda: "x86_64")
    finding = subjects(real_time.check_real_time(0.01))["processor"]
    assert finding.verdict == Verdict.LIMITED and "MuJoCo needs AVX" in finding.remedy


def test_late_timer_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(real_time, "timer_delays", lambda seconds: np.array([0.0, 0.001, 0.002]))
    finding = subjects(real_time.check_real_time(0.01))["timer"]
    assert finding.verdict == Verdict.LIMITED
    assert "3 deadlines, 2 ms apart: 1000 us late at p50" in finding.value


def test_timer_waits_for_each_deadline() -> None:
    delays = real_time.timer_delays(0.02)
    assert delays.size == 10 and delays.min() >= 0.0


@pytest.mark.parametrize(
    ("flags", "verdict", "remedy"),
    [
        (0x1003, Verdict.GOOD, ""),
        (0x1002, Verdict.INFO, ""),  # down
        (0x9, Verdict.INFO, ""),  # loopback
        (0x3, Verdict.LIMITED, "sudo ip link set eth7 multicast on"),
        (None, Verdict.INFO, ""),
    ],
)
def test_interface_is_judged_by_its_flags(flags: int | None, verdict: Verdict, remedy: str) -> None:
    finding = network.check_interface("eth7", flags)
    assert finding.verdict == verdict and remedy in finding.remedy


def test_broken_graphics_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulation, "_STEP", "pass")
    monkeypatch.setattr(simulation, "_DRAW", "raise OSError('no driver')")
    finding = subjects(simulation.check_simulation())["graphics"]
    assert finding.verdict == Verdict.LIMITED and "no driver" in finding.value
    assert "MUJOCO_GL" in finding.remedy


def test_command_writes_json_and_returns_3_for_a_bad_finding(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bad = Finding("network", "interface can0", "up", Verdict.BAD, "unplug it")
    monkeypatch.setattr("surefoot.cli.doctor.diagnose", lambda: [bad])
    file = tmp_path / "doctor.json"
    assert main(["doctor", "--json", str(file)]) == 3
    assert "unplug it" in capsys.readouterr().out
    (finding,) = json.loads(file.read_text())["findings"]
    assert finding == {
        "area": "network",
        "subject": "interface can0",
        "value": "up",
        "verdict": "bad",
        "remedy": "unplug it",
    }
    assert main(["doctor", "--json", str(tmp_path / "no" / "folder.json")]) == 2
