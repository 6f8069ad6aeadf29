"""Options of surefoot stand."""

from __future__ import annotations

import argparse

from surefoot.cli.robot_choice import add_robot_options

_PUSH_HELP = (
    "DIRECTION:IMPULSE:LENGTH[:HEIGHT]@TIME: lateral, forward or degrees from forward towards "
    "left; N.s, or percent of the LIP push limit (linear inverted pendulum); s; m above the centre "
    "of mass (0); s. Example: lateral:8.0:0.1@2.0, lateral:50%%:0.1:-0.05@2.0. Repeatable"
)
_REFERENCE_HELP = (
    "NAME=VALUE[,NAME=VALUE ...]@TIME: reference of the body: x, y, height [m], roll, pitch, yaw "
    "[deg], relative to the latched standing pose; s. Other axes keep their reference. Example: "
    "roll=10@4.0, height=-0.02,yaw=5@6. Repeatable"
)
_EPILOG = (
    "exit status: 0 the robot stood, 3 it fell (results are written in both cases), 1 a file could "
    "not be written, 2 a wrong argument, 130 interrupted"
)


def add_stand_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot stand."""
    parser.epilog = _EPILOG
    _add_plant_options(parser)
    _add_flaw_options(parser)
    _add_controller_options(parser)
    add = parser.add_argument_group("results").add_argument
    add("--json", metavar="FILE|-", help="write the summary as one JSON object; - is stdout")
    add(
        "--log",
        metavar="FILE.npz|FILE.csv",
        help="write the controller's inputs, and the true state in separate columns, for surefoot "
        "estimate and surefoot replay (npz only)",
    )
    add("--report", metavar="DIR", help="write film, plots, index.html and summary.json")


def add_form_option(parser: argparse.ArgumentParser | argparse._ArgumentGroup) -> None:
    """Add --form."""
    parser.add_argument(
        "--form",
        default="auto",
        metavar="auto|condensed|general",
        help="form of the QP: on contact forces (condensed) or on accelerations and forces "
        "(general); auto chooses by the state of the robot (auto)",
    )


def _add_controller_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("controller")
    add = group.add_argument
    add("--gains", metavar="FILE.toml", help="gains that differ from the robot's own")
    add("--reference", action="append", default=[], metavar="REFERENCE", help=_REFERENCE_HELP)
    add(
        "--motor-damping",
        type=float,
        default=0.0,
        metavar="KD",
        help="motor-side damping [N.m.s/rad] (0: pure torque mode)",
    )
    add_form_option(group)
    add(
        "--predict-ms",
        type=float,
        default=0.0,
        metavar="MS",
        help="delay from measurement to action that the controller compensates by prediction (0)",
    )


def _add_plant_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("simulation")
    add_robot_options(group, "go1")
    add = group.add_argument
    add("--duration", type=float, default=10.0, metavar="S", help="simulated time (10)")
    add("--rate", type=float, default=500.0, metavar="HZ", help="control rate [Hz] (500)")
    add(
        "--sensors",
        default="real",
        metavar="real|ideal",
        help="with or without sensor errors (real)",
    )
    add(
        "--foot-force",
        metavar="est|raw|dead",
        help="which foot forces LowState has: footForceEst, footForce, or none (dead, as on go1)",
    )
    add(
        "--friction",
        type=float,
        default=0.8,
        metavar="MU",
        help="friction coefficient of the ground (0.8)",
    )
    add(
        "--slope",
        default="0",
        metavar="DEG[:HEADING]",
        help="ground slope and direction of ascent (0)",
    )
    add(
        "--payload",
        default="0",
        metavar="KG[:X:Y:Z]",
        help="mass unknown to the controller, at x, y, z in m (0)",
    )
    add("--push", action="append", default=[], metavar="PUSH", help=_PUSH_HELP)
    add("--seed", type=int, default=1, metavar="N", help="seed of all random numbers (1)")


def _add_flaw_options(parser: argparse.ArgumentParser) -> None:
    """Add the options that make the simulated robot differ from the controller's model."""
    add = parser.add_argument_group("model errors of motors and ground").add_argument
    add(
        "--delay-ms", type=float, default=0.0, metavar="MS", help="additional delay of commands (0)"
    )
    add("--motor-lag-ms", type=float, metavar="MS", help="motor time constant (real: 2, ideal: 0)")
    add(
        "--armature-scale", type=float, default=1.0, metavar="F", help="factor on rotor inertia (1)"
    )
    add(
        "--joint-friction-scale",
        type=float,
        default=1.0,
        metavar="F",
        help="factor on friction and damping of the joints (1)",
    )
    add("--backlash-deg", type=float, default=0.0, metavar="DEG", help="backlash of every gear (0)")
    add(
        "--soft-ground",
        type=float,
        default=0.0,
        metavar="M",
        help="how far standing feet sink in (0)",
    )
