# SPDX-License-Identifier: BSD-3-Clause
"""surefoot run over DDS: what is refused before the release of the sport service, and after it."""

from __future__ import annotations

import math
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import surefoot
from surefoot import Mode
from surefoot.cli import dds_run, main, run_setup
from surefoot.cli import run as run_module
from surefoot.cli.arguments import parse_arguments
from surefoot.cli.dds_options import default_robot
from surefoot.cli.robot_choice import chosen_robot, robot_source
from surefoot.cli.run_text import slow_simulator_text

ERROR = 2  # exit status after a wrong argument
BROKEN_LINK = "rt/lowcmd: got 1 other writer(s), expected none"


class FakeSwitcher:
    """Switcher of a robot whose sport service is in a mode."""

    mode = "normal"
    calls: tuple[str, ...] = ()
    refuses = False  # the release begins and then fails

    def __init__(self, network: object) -> None:
        pass

    def is_present(self) -> bool:
        return True

    def check_mode(self) -> str:
        return FakeSwitcher.mode

    def release(self, on_message: Any) -> str:
        FakeSwitcher.calls += ("release",)
        if not FakeSwitcher.mode:
            return ""
        on_message("releasing it")
        if FakeSwitcher.refuses:
            raise surefoot.Error("motion switcher: got mode 'normal'")
        return FakeSwitcher.mode

    def select_mode(self, name: str) -> None:
        FakeSwitcher.calls += (f"select {name}",)


def broken_link(*_: object, **__: object) -> None:
    raise surefoot.Error(BROKEN_LINK)


@pytest.fixture(autouse=True)
def fakes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Replace network, link and switcher; the link cannot be opened."""
    for name, value in {"mode": "normal", "calls": (), "refuses": False}.items():
        monkeypatch.setattr(FakeSwitcher, name, value)
    monkeypatch.setattr(dds_run, "MotionSwitcher", FakeSwitcher)
    monkeypatch.setattr(dds_run, "DdsNetwork", lambda *_: SimpleNamespace(notices=[]))
    monkeypatch.setattr(dds_run, "DdsLink", broken_link)


@pytest.mark.parametrize(
    "words",
    [
        ["--predict-ms", "90"],
        ["--rate", "5"],
        ["--form", "nonsense"],
        ["--gains", "/nowhere.toml"],
        ["--power-level", "11"],
        ["--motor-damping", "99"],
        ["--power-limit", "-1"],
        ["--duration", "0"],
        ["--json", "/nowhere/x.json"],
    ],
)
def test_bad_argument_is_refused_before_the_sport_service_is_released(words: list[str]) -> None:
    assert main(["run", "--sdk", "go2", *words]) in (1, ERROR)
    assert FakeSwitcher.calls == ()


def test_failure_after_the_release_reports_that_the_sport_service_is_off(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["run", "--sdk", "go2"]) == ERROR
    said = capsys.readouterr()
    assert "the sport service stays off (mode 'normal' was active)" in said.out
    assert BROKEN_LINK in said.err
    assert FakeSwitcher.calls == ("release",)


def test_failure_after_the_release_gives_the_mode_back_if_requested(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["run", "--sdk", "go2", "--give-back"]) == ERROR
    assert "mode 'normal' is active again" in capsys.readouterr().out
    assert FakeSwitcher.calls == ("release", "select normal")


def test_failure_during_the_run_never_gives_the_mode_back(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(dds_run, "DdsLink", lambda *_, **__: SimpleNamespace(take_news=list))
    monkeypatch.setattr(run_setup.RunSetup, "dds_runner", lambda *_: SimpleNamespace())
    monkeypatch.setattr(run_module, "supervise", broken_link)
    assert main(["run", "--sdk", "go2", "--give-back"]) == ERROR
    assert "the sport service stays off" in capsys.readouterr().out
    assert FakeSwitcher.calls == ("release",)


def test_release_that_fails_reports_that_the_sport_service_may_be_off(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(FakeSwitcher, "refuses", True)
    assert main(["run", "--sdk", "go2"]) == ERROR
    assert "the sport service may be off" in capsys.readouterr().out


def ended(stood_to_end: bool, mode: Mode) -> Any:
    return SimpleNamespace(stood_to_end=stood_to_end, mode=mode)


def end_of_run(end: Any, *words: str) -> str:
    """Return what a session with --give-back prints at the end of a run."""
    lines: list[str] = []
    arguments = parse_arguments(["run", "--sdk", "go2", "--give-back", *words])
    with dds_run.DdsSession(arguments, lines.append) as session:
        session.begin()
        lines.clear()
        session.end(end)
    return "\n".join(lines)


def test_robot_that_stood_and_sat_down_gets_its_mode_back() -> None:
    assert "mode 'normal' is active again" in end_of_run(ended(True, Mode.PASSIVE))
    assert FakeSwitcher.calls == ("release", "select normal")


@pytest.mark.parametrize(
    "end",
    [
        ended(False, Mode.PASSIVE),  # the mode before the first LowState, and of a hung robot
        ended(True, Mode.DAMPING),
        ended(True, Mode.STAND),
    ],
)
def test_robot_that_did_not_sit_down_does_not_get_its_mode_back(end: Any) -> None:
    said = end_of_run(end)
    assert "it is not certain that the robot lies" in said
    assert "activate mode 'normal' with the vendor's app" in said
    assert FakeSwitcher.calls == ("release",)


@pytest.mark.parametrize(("typed", "selected"), [("lies", True), ("yes", False), ("", False)])
def test_operator_of_a_real_robot_is_asked_whether_it_lies(
    typed: str, selected: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    answers = iter(["lies", typed])  # the first one is for the release
    monkeypatch.setattr(dds_run, "has_keyboard", lambda: True)
    monkeypatch.setattr(dds_run, "_typed", lambda _: next(answers))
    end_of_run(ended(False, Mode.PASSIVE), "--rise", "--real-robot", "--interface", "enp3s0")
    assert ("select normal" in FakeSwitcher.calls) == selected


def test_without_an_active_mode_none_is_given_back(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(FakeSwitcher, "mode", "")
    said = end_of_run(ended(True, Mode.PASSIVE))
    assert said == "--give-back: no mode was active, none is given back"


REAL = ("--rise", "--yes", "--real-robot")


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (("--sdk", "go2", "--robot", "go1", "--interface", "x", *REAL), "--robot: got go1 with"),
        (("--sdk", "b2", "--robot", "go2"), "--sdk: got b2 with robot go2, expected go2"),
        (("--sdk", "go2", *REAL), "--real-robot: got no --interface"),
        (
            ("--sdk", "go2", "--interface", "x", "--no-motion-switcher", *REAL),
            "--no-motion-switcher: got --real-robot",
        ),
        (("--sdk", "go2", "--give-back", "--no-motion-switcher"), "--give-back: got --no-motion"),
        (("--sdk", "go2", "--host", "127.0.0.1"), "--host: got --sdk go2"),
        (("--sdk", "go2", "--port", "8007"), "--port: got --sdk go2"),
        (("--sdk", "go2", "--local-port", "0"), "--local-port: got --sdk go2"),
        (("--interface", "lo"), "--interface: got no --sdk go2 or b2"),
        (("--domain", "0"), "--domain: got no --sdk go2 or b2"),
        (("--libddsc", "x.so"), "--libddsc: got no --sdk go2 or b2"),
        (("--untested-libddsc",), "--untested-libddsc: got no --sdk go2 or b2"),
        (("--tick", "message"), "--tick: got no --sdk go2 or b2"),
        (("--give-back",), "--give-back: got no --sdk go2 or b2"),
        (("--no-motion-switcher",), "--no-motion-switcher: got no --sdk go2 or b2"),
    ],
)
def test_unsafe_or_unused_option_is_refused_by_its_name(
    words: tuple[str, ...], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", *words]) == ERROR
    error = capsys.readouterr().err
    assert text in error and error.count("\n") == 1
    assert FakeSwitcher.calls == ()


@pytest.mark.parametrize("command", ["run", "robot"])
def test_untested_libddsc_is_refused_unless_allowed(
    command: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(dds_run, "DdsNetwork", surefoot.DdsNetwork)
    words = [command, "--sdk", "go2", "--libddsc", "libm.so.6"]  # any other library
    assert main(words) == ERROR
    assert "or allow an untested version with --untested-libddsc" in capsys.readouterr().err
    assert main([*words, "--untested-libddsc"]) == ERROR
    assert "without dds_create_domain" in capsys.readouterr().err


def test_other_robot_is_accepted_in_a_simulation() -> None:
    arguments = parse_arguments(["run", "--sdk", "go2", "--robot", "go1"])
    setup = run_setup.read_setup(arguments)
    assert setup.robot.name == "go1" and setup.generation == "go2"
    assert math.isinf(setup.options.duration)


def test_urdf_alone_is_that_of_the_robot_that_sdk_names(tmp_path: Path) -> None:
    urdf = tmp_path / "mine.urdf"
    urdf.write_text("<robot name='b2'/>")
    arguments = parse_arguments(["run", "--sdk", "b2", "--urdf", str(urdf)])
    description = chosen_robot(arguments, default=default_robot(arguments.sdk))
    assert description is not None
    assert (description.name, description.urdf) == ("b2", urdf)


@pytest.mark.parametrize("command", ["assess", "tune search"])
def test_source_of_a_robot_without_urdf_has_the_toml_of_the_package(command: str) -> None:
    words = [*command.split(), "--robot", "b2", "--urdf", "mine.urdf"]
    urdf, config = robot_source(parse_arguments(words), default="go1")
    assert Path(urdf).name == "mine.urdf" and Path(config).name == "b2.toml"
    assert Path(config).exists()


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["run", "--sdk", "b2"], "expected the name and urdf= (--urdf)"),
        (["run", "--sdk", "go2", "--urdf", "mine.urdf"], "got --urdf alone"),
        (["robots", "--mjcf", "scene.xml", "--robot", "b2"], "expected --check FILE.urdf too"),
    ],
)
def test_missing_urdf_is_told_in_one_line(
    words: list[str], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == ERROR
    error = capsys.readouterr().err
    assert text in error and error.count("\n") == 1


def test_fault_of_time_with_the_tick_from_arrival_is_explained() -> None:
    slow = {"stood_to_end": False, "faults": {"clock": 1}}
    assert "does not run in real time" in slow_simulator_text(slow)
    assert slow_simulator_text({"stood_to_end": True, "faults": {"clock": 1}}) == ""
    assert slow_simulator_text({"stood_to_end": False, "faults": {"fall": 1}}) == ""
