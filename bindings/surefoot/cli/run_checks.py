"""Checks of the options of surefoot run: transport, operator and robot."""

from __future__ import annotations

import argparse

from surefoot._core import Error
from surefoot.cli.dds_options import DDS_ROBOTS
from surefoot.system.terminal import has_keyboard

# Options of one transport only; each is None or False if not given.
_UDP_OPTIONS = ("--host", "--port", "--local-port")
_DDS_OPTIONS = (
    "--interface",
    "--domain",
    "--libddsc",
    "--untested-libddsc",
    "--tick",
    "--give-back",
    "--no-motion-switcher",
)


def check_transport(arguments: argparse.Namespace) -> None:
    """Raise Error for an option of the other transport, and for a wrong use of those of DDS."""
    if arguments.sdk not in DDS_ROBOTS:
        option = _first_given(arguments, _DDS_OPTIONS)
        if option is not None:
            raise Error(
                f"{option}: got no --sdk go2 or b2, expected one of them: this option is for DDS "
                "only; add --sdk, or leave the option out"
            )
        return
    option = _first_given(arguments, _UDP_OPTIONS)
    if option is not None:
        raise Error(
            f"{option}: got --sdk {arguments.sdk}, which means DDS, expected a generation of "
            "frames over UDP; use --interface and --domain instead"
        )
    if arguments.no_motion_switcher and arguments.give_back:
        raise Error(
            "--give-back: got --no-motion-switcher, expected only one of them: without a motion "
            "switcher no mode can be given back"
        )
    if arguments.real_robot:
        _check_real_dds(arguments)


def _check_real_dds(arguments: argparse.Namespace) -> None:
    if arguments.no_motion_switcher:
        raise Error(
            "--no-motion-switcher: got --real-robot, expected a simulation: on a robot the "
            "sport service must be released, or both programs command the motors; leave the option "
            "out"
        )
    if not arguments.interface:
        raise Error(
            "--real-robot: got no --interface, expected the network interface of the cable to the "
            "robot; list the interfaces with: ip -brief address"
        )


def _first_given(arguments: argparse.Namespace, options: tuple[str, ...]) -> str | None:
    """Return the first option that was given, or None."""
    for option in options:
        value = getattr(arguments, option.removeprefix("--").replace("-", "_"))
        if value is not None and value is not False:
            return option
    return None


def check_operator(arguments: argparse.Namespace) -> None:
    """Raise Error unless the operator can start and stop the robot with the given options."""
    if arguments.yes and not arguments.rise:
        raise Error(
            "--yes: got no --rise, expected both: --yes lets the robot rise without a key press"
        )
    if arguments.real_robot and not arguments.rise:
        raise Error(
            "--real-robot: got no --rise, expected both: a real robot must start lying, so that "
            "its arming checks run before it gets torques"
        )
    if arguments.real_robot and arguments.no_remote and not has_keyboard():
        raise Error(
            "--real-robot: got --no-remote and no terminal, expected button B of the remote or a "
            "terminal to stop the robot"
        )
    if arguments.rise and not arguments.yes and not has_keyboard():
        raise Error(
            "--rise: got no terminal for the keys, expected a terminal, or --yes to arm and rise "
            "as soon as all checks pass"
        )


def check_dds_robot(name: str, sdk: str, real_robot: bool) -> None:
    """Raise Error if a robot must not be controlled as the robot that --sdk names.

    Args:
        name: Name of the chosen robot.
        sdk: Value of --sdk, one of DDS_ROBOTS.
        real_robot: Whether --real-robot is given.
    """
    if name == sdk:
        return
    if name in DDS_ROBOTS:
        raise Error(
            f"--sdk: got {sdk} with robot {name}, expected {name}: their motors have different "
            f"servo modes; use --sdk {name}, or leave out --robot"
        )
    if real_robot:
        raise Error(
            f"--robot: got {name} with --sdk {sdk} and --real-robot, expected {sdk}: masses, "
            f"limits and gains of {name} are not those of a real {sdk}; leave out --robot, or set "
            f'name = "{sdk}" in the [robot] table of --config if it describes a {sdk}'
        )
