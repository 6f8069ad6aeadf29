"""Options of robots that speak DDS."""

from __future__ import annotations

import argparse

DDS_ROBOTS = ("go2", "b2")  # values of --sdk that mean DDS
DEFAULT_DOMAIN = 1  # of simulations, by the convention of unitree_mujoco


def add_dds_options(group: argparse._ArgumentGroup) -> None:
    """Add --interface, --domain and --libddsc."""
    add = group.add_argument
    add("--interface", default="lo", metavar="NAME", help="network interface (lo)")
    add(
        "--domain",
        type=int,
        metavar="N",
        help=f"DDS domain, 0 .. 230 ({DEFAULT_DOMAIN}; real robots: 0)",
    )
    add(
        "--libddsc",
        default="",
        metavar="FILE",
        help="library of Cyclone DDS (that of the package cyclonedds, else of the system)",
    )


def default_robot(sdk: str | None) -> str:
    """Return the robot that a value of --sdk stands for, if no robot is chosen."""
    return sdk if sdk in DDS_ROBOTS else "go1"
