"""Checks of the joints of a URDF."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from typing import Any

from surefoot._core import Error
from surefoot.robot.robot_toml import suggest
from surefoot.robot.urdf_links import check_origin
from surefoot.robot.urdf_numbers import number_text, read_number, read_numbers

MOVABLE = ("revolute", "continuous", "prismatic")
_TYPES = (*MOVABLE, "fixed", "floating", "planar")
_LEG_JOINTS = ("hip", "thigh", "calf")


def check_joint(joint: ET.Element) -> None:
    """Check type, axis, limits and numbers of a joint.

    Raises:
        Error: A value is missing or impossible, or the joint is of a kind that is not supported.
    """
    where, kind = f"joint '{joint.get('name')}'", joint.get("type", "")
    if kind not in _TYPES:
        raise Error(
            f"{where}: type: got '{kind}'{suggest(kind, _TYPES)}; valid types: {', '.join(_TYPES)}"
        )
    if kind == "planar":
        raise Error(f"{where}: type: got 'planar', expected a joint of one axis, or fixed")
    check_origin(joint, where)
    if kind not in MOVABLE:
        return
    if joint.find("mimic") is not None:
        raise Error(
            f"{where}: got <mimic>, expected a joint of its own; make it fixed, or remove <mimic>"
        )
    axis = joint.find("axis")
    if axis is not None and not math.hypot(*read_numbers(axis, "xyz", 3, where)) > 1e-3:
        raise Error(f"{where}: <axis xyz>: got '{axis.get('xyz')}', expected a direction")
    _check_limit(joint, where, kind)
    dynamics = joint.find("dynamics")
    for name in ("damping", "friction"):
        if dynamics is not None and name in dynamics.attrib:
            value = read_number(dynamics, name, where)
            if value < 0.0:
                raise Error(f"{where}: <dynamics {name}>: got {value:g}, expected 0 or more")


def _check_limit(joint: ET.Element, where: str, kind: str) -> None:
    limit = joint.find("limit")
    if limit is None:
        if kind == "continuous":
            return
        raise Error(f"{where}: got no <limit>, expected lower, upper, effort and velocity")
    values = {
        name: read_number(limit, name, where)
        for name in ("lower", "upper", "effort", "velocity")
        if name in limit.attrib or name in ("effort", "velocity")
    }
    for name in ("effort", "velocity"):
        if not values[name] > 0.0:
            raise Error(f"{where}: <limit {name}>: got {values[name]:g}, expected above 0")
    lower, upper = values.get("lower", 0.0), values.get("upper", 0.0)
    if kind != "continuous" and not lower < upper:
        raise Error(
            f"{where}: <limit>: got lower {lower:g}, upper {upper:g}, expected lower < upper"
        )


def bound_leg_joint(joint: ET.Element, table: dict[str, Any]) -> None:
    """Make a continuous joint of a leg revolute, with the limits of the robot's TOML.

    Raises:
        Error: The TOML has no limits for it, or the URDF has no <limit>.
    """
    name, names = joint.get("name", ""), table["robot"]["joints"]
    if joint.get("type") != "continuous" or name not in names:
        return
    kind = _LEG_JOINTS[names.index(name) % 3]
    limits = table.get("limits", {}).get(kind)
    if limits is None:
        raise Error(
            f"joint '{name}': got a continuous joint in a leg, expected limits; add "
            f"{kind} = [lower, upper] to [limits] of the TOML"
        )
    limit = joint.find("limit")
    if limit is None:
        raise Error(f"joint '{name}': got no <limit>, expected <limit effort velocity>")
    joint.set("type", "revolute")
    limit.set("lower", number_text([float(limits[0])]))
    limit.set("upper", number_text([float(limits[1])]))
