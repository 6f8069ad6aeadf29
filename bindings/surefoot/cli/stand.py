"""surefoot stand: a run from its arguments to its results."""

from __future__ import annotations

import argparse
import ctypes.util
import json
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from surefoot._core import Error, Gains
from surefoot.cli.progress import progress_bar
from surefoot.robots import build_robot, describe_robot, load_gains

if TYPE_CHECKING:
    from surefoot.stand import StandSettings


def stand(arguments: argparse.Namespace) -> None:
    """Run the robot and print, write and draw what was asked for; raises Error."""
    choose_graphics()
    try:
        from surefoot.stand import run_stand, summarise
        from surefoot.stand.text import summary_text
    except ModuleNotFoundError as problem:
        raise _missing(problem) from None
    settings = read_settings(arguments)
    _check_places(arguments)
    progress = progress_bar()
    log = run_stand(settings, progress)
    summary = summarise(log)
    _write_json(arguments.json, summary)
    if arguments.report is not None:
        from surefoot.stand.report import write_report

        command = ["surefoot", *arguments.words]
        page = write_report(log, summary, Path(arguments.report), command, progress)
    if arguments.json != "-":
        print(summary_text(summary))
        if arguments.report is not None:
            print(f"  report    {page}")


def choose_graphics() -> None:
    """Choose, before MuJoCo is imported, how it draws on a machine without a screen."""
    if os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY") or sys.platform != "linux":
        return
    # Without the library MuJoCo would not even import; a run without a film needs no graphics.
    library = ctypes.util.find_library("EGL")
    os.environ.setdefault("MUJOCO_GL", "egl" if library else "disable")


def read_settings(arguments: argparse.Namespace) -> StandSettings:
    """Turn arguments into settings; raises Error."""
    from surefoot.sim import PlantSettings
    from surefoot.stand import StandSettings, parse_push
    from surefoot.stand.settings import check_rate

    check_rate(arguments.rate)
    slope, heading = _numbers("--slope", arguments.slope, "DEG[:HEADING]", (1, 2), 2)
    payload, *position = _numbers("--payload", arguments.payload, "KG[:X:Y:Z]", (1, 4), 4)
    plant = PlantSettings(
        sensors=arguments.sensors,
        foot_force=arguments.foot_force,
        friction=arguments.friction,
        soft_ground_sink=arguments.soft_ground,
        slope_deg=slope,
        slope_heading_deg=heading,
        payload_kg=payload,
        payload_position=(position[0], position[1], position[2]),
        control_rate=arguments.rate,
        joint_friction_scale=arguments.joint_friction_scale,
        armature_scale=arguments.armature_scale,
        backlash_deg=arguments.backlash_deg,
        motor_lag=None if arguments.motor_lag_ms is None else arguments.motor_lag_ms / 1000.0,
        extra_delay=arguments.delay_ms / 1000.0,
        seed=arguments.seed,
    )
    return StandSettings(
        robot=arguments.robot,
        duration=arguments.duration,
        plant=plant,
        pushes=tuple(parse_push(text) for text in arguments.push),
        gains=_read_gains(arguments),
        motor_damping=arguments.motor_damping,
    )


def _read_gains(arguments: argparse.Namespace) -> Gains | None:
    if arguments.gains is None:
        return None
    own = build_robot(describe_robot(arguments.robot)).config.gains
    return load_gains(arguments.gains, own)


def _numbers(
    option: str, text: str, form: str, counts: tuple[int, ...], size: int
) -> tuple[float, ...]:
    """Read numbers between colons and fill up with zeros to `size`; raises Error."""
    try:
        values = tuple(float(word) for word in text.split(":"))
    except ValueError:
        values = ()
    if len(values) not in counts:
        raise Error(f"{option}: got '{text}', expected {form}")
    return values + (0.0,) * (size - len(values))


def _check_places(arguments: argparse.Namespace) -> None:
    """Find out before the run, not after it, that a result has no place to go; raises Error."""
    if arguments.json not in (None, "-"):
        path = Path(arguments.json)
        if path.is_dir() or not path.parent.is_dir() or not os.access(path.parent, os.W_OK):
            raise Error(f"--json: got '{path}', expected a file in a folder that can be written")
    if arguments.report is not None:
        try:
            Path(arguments.report).mkdir(parents=True, exist_ok=True)
            import surefoot.stand.report  # noqa: F401
        except OSError as problem:
            raise Error(f"--report: cannot make the folder: {problem}") from None
        except ModuleNotFoundError as problem:
            raise _missing(problem) from None


def _missing(problem: ModuleNotFoundError) -> Error:
    return Error(
        f"module '{problem.name}' not found: surefoot stand needs the extra 'sim'; "
        "run: pip install 'surefoot[sim]'"
    )


def _write_json(place: str | None, summary: dict[str, Any]) -> None:
    if place is None:
        return
    text = json.dumps(summary, indent=2, allow_nan=False) + "\n"
    if place == "-":
        sys.stdout.write(text)
    else:
        Path(place).write_text(text, encoding="utf-8")
