"""Options of robots that speak DDS."""

from __future__ import annotations

import argparse

DDS_ROBOTS = ("go2", "b2")  # values of --sdk that mean DDS
DEFAULT_DOMAIN = 1  # of simulations, by the convention of unitree_mujoco
LOOPBACK = "lo"  # interface of simulations


def add_dds_options(
    group: argparse._ArgumentGroup, interface_help: str = f"network interface ({LOOPBACK})"
) -> None:
    """Add the options of a DDS network; each is None or False if not given."""
    add = group.add_argument
    add("--interface", metavar="NAME", help=interface_help)
    add(
        "--domain",
        type=int,
        metavar="N",
        help=f"DDS domain, 0 .. 230 ({DEFAULT_DOMAIN}; real robots: 0)",
    )
    add(
        "--libddsc",
        metavar="FILE",
        help="library of Cyclone DDS (that of the package cyclonedds, else of the system)",
    )
    add(
        "--untested-libddsc",
        action="store_true",
        help="allow a version of that library with which Surefoot was not tested",
    )


def default_robot(sdk: str | None) -> str:
    """Return the robot that a value of --sdk stands for, if no robot is chosen."""
    return sdk if sdk in DDS_ROBOTS else "go1"
