"""Settings of a simulated run, from the arguments of a command."""

from __future__ import annotations

import argparse
from typing import Any

from surefoot._core import Error, Gains, QpForm
from surefoot.cli.robot_choice import chosen_robot, print_mapping
from surefoot.robot.gain_files import load_gains
from surefoot.robot.loading import RobotDescription, build_robot
from surefoot.robot.robot_toml import suggest


def read_simulation(arguments: argparse.Namespace) -> dict[str, Any]:
    """Return the arguments of SimulationSettings that the options give.

    Args:
        arguments: Arguments with the options of simulation_options.py.

    Raises:
        Error: An argument is wrong.
    """
    from surefoot.sim import PlantSettings
    from surefoot.stand import parse_push, parse_reference
    from surefoot.stand.simulation_settings import check_rate

    check_rate(arguments.rate)
    robot = chosen_robot(arguments, default="go1")
    assert robot is not None  # not None, because a default robot is given
    print_mapping(robot)
    slope, heading = parse_numbers("--slope", arguments.slope, "DEG[:HEADING]", (1, 2), 2)
    payload, *position = parse_numbers("--payload", arguments.payload, "KG[:X:Y:Z]", (1, 4), 4)
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
    return {
        "robot": robot,
        "duration": arguments.duration,
        "plant": plant,
        "pushes": tuple(parse_push(text) for text in arguments.push),
        "references": tuple(parse_reference(text) for text in arguments.reference),
        "gains": read_gains(arguments.gains, robot),
        "motor_damping": arguments.motor_damping,
        "form": read_form(arguments.form),
        "predicted_delay": arguments.predict_ms / 1000.0,
    }


def read_form(text: str) -> QpForm:
    """Return the QpForm that --form names; raise Error if the name is unknown."""
    names = {form.name.lower(): form for form in QpForm}
    if text not in names:
        valid = ", ".join(names)
        raise Error(f"--form: got '{text}'{suggest(text, names)}; valid names: {valid}")
    return names[text]


def read_gains(file: str | None, robot: RobotDescription) -> Gains | None:
    """Return the robot's gains, changed to the values in `file`; None without a file.

    Raises:
        Error: The file cannot be read, or a gain is unknown or out of range.
    """
    if file is None:
        return None
    return load_gains(file, build_robot(robot).config.gains)


def parse_numbers(
    option: str, text: str, form: str, counts: tuple[int, ...], size: int
) -> tuple[float, ...]:
    """Parse numbers separated by colons, and append zeros until there are `size` numbers.

    `form` is the expected text and `counts` are the accepted numbers of values.

    Raises:
        Error: The text does not have this form.
    """
    try:
        values = tuple(float(word) for word in text.split(":"))
    except ValueError:
        values = ()
    if len(values) not in counts:
        raise Error(f"{option}: got '{text}', expected {form}")
    return values + (0.0,) * (size - len(values))
