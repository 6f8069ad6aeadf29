"""Options that commands with a simulated controller share: plant, pushes and the tick."""

from __future__ import annotations

import argparse

from surefoot.cli.robot_choice import add_mjcf_option, add_robot_options

_PUSH_HELP = (
    "DIRECTION:IMPULSE:LENGTH[:HEIGHT]@TIME: lateral, forward or degrees from forward towards "
    "left; N.s, or percent of the LIP push limit (linear inverted pendulum); s; m above the centre "
    "of mass (0); s. Example: lateral:8.0:0.1@2.0, lateral:50%%:0.1:-0.05@2.0. Repeatable"
)
_REFERENCE_HELP = (
    "NAME=VALUE[,NAME=VALUE ...]@TIME: reference of the body: x, y, height [m], roll, pitch, yaw "
    "[deg], relative to the latched standing pose; s. Other axes keep their reference. A walking "
    "robot follows height, roll and pitch. Example: roll=10@4.0, height=-0.02,yaw=5@6. Repeatable"
)


def add_plant_options(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    """Add the options of robot, ground, sensors and pushes; return their group."""
    group = parser.add_argument_group("simulation")
    add_robot_options(group, "go1")
    add_mjcf_option(group)
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
    return group


def add_flaw_options(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    """Add the options of model errors, unknown to the controller; return their group."""
    group = parser.add_argument_group("model errors of motors and ground")
    add = group.add_argument
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
    return group


def add_tick_options(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    """Add the options of gains and tick; return their group."""
    group = parser.add_argument_group("controller")
    add = group.add_argument
    add("--gains", metavar="FILE.toml", help="gains that differ from the robot's own")
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
    add("--reference", action="append", default=[], metavar="REFERENCE", help=_REFERENCE_HELP)
    return group


def add_form_option(parser: argparse.ArgumentParser | argparse._ArgumentGroup) -> None:
    """Add --form."""
    parser.add_argument(
        "--form",
        default="auto",
        metavar="auto|condensed|general",
        help="form of the QP: on contact forces (condensed) or on accelerations and forces "
        "(general); auto chooses by the state of the robot (auto)",
    )
