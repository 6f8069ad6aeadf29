"""surefoot robots --check and --mjcf: the report on one robot or on one MJCF."""

from __future__ import annotations

import argparse

from surefoot._core import Error
from surefoot.cli.missing_module import missing_module
from surefoot.cli.tables import list_robots, print_table
from surefoot.robot.description import (
    RobotDescription,
    available_robots,
    describe_robot,
    robots_without_urdf,
)
from surefoot.robot.robot_report import RobotReport, check_robot

# Largest difference of plant and controller, as a share of the largest entry. The inertia of the
# base link of go1 and b1, which MuJoCo rejects, makes 1e-7.
MAX_DIFFERENCE = 1e-6


def add_robots_options(parser: argparse.ArgumentParser) -> None:
    """Add --check, --mjcf, --robot and --config."""
    parser.add_argument(
        "--check", metavar="NAME|FILE.urdf", help="load one robot and report what is found"
    )
    parser.add_argument("--config", metavar="FILE.toml", help="robot settings that the URDF lacks")
    parser.add_argument("--mjcf", metavar="FILE.xml", help="print what is found in an MJCF")
    names = " or ".join(robots_without_urdf())
    parser.add_argument(
        "--robot",
        metavar="NAME",
        help=f"settings of {names}, instead of --config; with --mjcf: its robot (go1)",
    )


def robots(arguments: argparse.Namespace) -> None:
    """List the robots known by name, check one robot, or print what is found in an MJCF.

    Raises:
        Error: A wrong argument, or the robot or the MJCF cannot be loaded.
    """
    if arguments.check is None and arguments.mjcf is not None:
        if arguments.robot in robots_without_urdf():
            raise Error(
                f"--robot: got {arguments.robot} with --mjcf alone, expected --check FILE.urdf "
                "too, because the package has no URDF of it"
            )
        _print_mapping(arguments, describe_robot(arguments.robot or "go1"))
        return
    if arguments.check is None:
        if arguments.config is not None or arguments.robot is not None:
            raise Error("got --config or --robot alone, expected --check with a URDF, or --mjcf")
        list_robots(arguments)
        return
    description = _description(arguments)
    report = check_robot(description)
    print(_text(report))
    _print_tables(report)
    doubts = [*report.doubts, *_compare_with_plant(report, description)]
    print("\n".join(["", "doubts:", *(f"  {doubt}" for doubt in doubts or ["none"])]))
    if arguments.mjcf is not None:
        print()
        _print_mapping(arguments, description)


def _print_mapping(arguments: argparse.Namespace, description: RobotDescription) -> None:
    try:
        from surefoot.sim.mjcf.describe import describe_mjcf
    except ModuleNotFoundError as problem:
        raise missing_module("robots", problem) from None
    if arguments.config is not None and arguments.check is None:
        raise Error("--config: got it with --mjcf alone, expected --check FILE.urdf too")
    print(describe_mjcf(description.with_mjcf(arguments.mjcf)))


def _description(arguments: argparse.Namespace) -> RobotDescription:
    files = arguments.robot is not None or arguments.config is not None
    if arguments.check in available_robots() and not files:
        return describe_robot(arguments.check)
    if arguments.robot is not None and arguments.robot not in robots_without_urdf():
        raise Error(
            f"--robot: got '{arguments.robot}'; valid names: {', '.join(robots_without_urdf())}"
        )
    if not files:
        raise Error(
            f"--check: got '{arguments.check}' alone, expected a name of surefoot robots, or a "
            "URDF with --config FILE.toml"
        )
    return describe_robot(arguments.robot, urdf=arguments.check, config=arguments.config)


def _text(report: RobotReport) -> str:
    config = report.robot.config
    x, y, z = config.p_base_imu
    return (
        f"{report.robot.name}: {report.robot.mass:.3f} kg, {len(report.bodies) - 1} joints, "
        f"foot radius {config.foot_radius:g} m, IMU at ({x:g}, {y:g}, {z:g}) m\n"
    )


def _print_tables(report: RobotReport) -> None:
    rows = [(body.link, body.joint, f"{body.mass:.4g}") for body in report.bodies]
    print_table(("body", "moved by", "mass [kg]"), rows)
    print()
    legs = [
        (
            leg.leg,
            leg.frame,
            f"{leg.thigh:.4g}",
            f"{leg.calf:.4g}",
            " ".join(f"{p:.3f}" for p in leg.foot),
        )
        for leg in report.legs
    ]
    header = ("leg", "foot", "thigh [m]", "calf [m]", "foot in the standing pose, x y z [m]")
    print_table(header, legs)
    print()
    config = report.robot.config
    limits = [
        (
            name,
            f"{config.q_lower[i]:.3f} .. {config.q_upper[i]:.3f}",
            f"{config.q_standing[i]:.3f}",
            f"{config.tau_max[i]:.1f}",
            f"{config.dq_max[i]:.1f}",
            f"{config.armature[i]:.4g}",
        )
        for i, name in enumerate(config.joint_names)
    ]
    columns = ("joint", "limits [rad]", "standing", "torque [N.m]", "speed [rad/s]", "armature")
    print_table(columns, limits)


def _compare_with_plant(report: RobotReport, description: RobotDescription) -> list[str]:
    """Print how well the simulated robot agrees with the controller's model; return doubts."""
    try:
        from surefoot.sim.model.agreement import compare_models
    except ModuleNotFoundError:
        return ["the simulated robot was not compared, because MuJoCo is not installed"]
    agreement = compare_models(report.robot, description)
    print(
        f"\nMuJoCo and Pinocchio differ by {agreement.mass_matrix:.1g} (mass matrix), "
        f"{agreement.gravity:.1g} (gravity), {agreement.feet:.1g} (feet) of the largest entry"
    )
    if agreement.worst <= MAX_DIFFERENCE:
        return []
    return [f"the simulated robot differs from the controller's by {agreement.worst:.1g}"]
