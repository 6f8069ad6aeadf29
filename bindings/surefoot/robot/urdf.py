"""Reads and judges a URDF before Pinocchio and MuJoCo, which then build from the same text."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from surefoot._core import Error
from surefoot.robot.urdf_joints import MOVABLE, bound_leg_joint, check_joint
from surefoot.robot.urdf_links import LinkInertia, check_link
from surefoot.robot.urdf_numbers import number_text, read_numbers
from surefoot.robot.urdf_schema import ATTRIBUTES, CHILDREN, check_elements
from surefoot.robot.urdf_tree import check_names, ends, find_root, remove_world
from surefoot.robot.xml_file import read_xml


@dataclass(frozen=True)
class Urdf:
    """A URDF that has passed the checks.

    Attributes:
        text: The URDF with only what dynamics and contacts need: no visuals, materials, plugins.
        base: Name of the root link.
        links: Names of all links in the file, also of a removed link above the base.
        doubts: Values that are possible but unusual, one sentence each.
    """

    text: str
    base: str
    links: frozenset[str]
    doubts: tuple[str, ...]


def read_urdf(path: Path, table: dict[str, Any]) -> Urdf:
    """Read and check a URDF.

    Args:
        path: The file.
        table: The robot's TOML, as returned by read_table(): limits of continuous leg joints.

    Raises:
        Error: The file cannot be read, or a value is missing or impossible; the message names the
            link or joint.
    """
    root = read_xml(path, "URDF")
    try:
        links = frozenset(link.get("name", "") for link in root.findall("link"))
        base, doubts = _check(root, table)
        return Urdf(_cleaned(root), base, links, tuple(doubts))
    except Error as problem:
        raise Error(f"URDF '{path}': {problem}") from None


def _check(root: ET.Element, table: dict[str, Any]) -> tuple[str, list[str]]:
    doubts = check_elements(root, "robot")
    check_names(root)
    for kind in ("link", "joint"):
        for element in root.findall(kind):
            doubts += check_elements(element, f"{kind} '{element.get('name')}'")
    base, removed = remove_world(root, find_root(root))
    doubts += removed
    for joint in root.findall("joint"):
        check_joint(joint)
        bound_leg_joint(joint, table)
    inertias = {link.get("name", ""): check_link(link) for link in root.findall("link")}
    return base, doubts + _check_massless(root, inertias)


def _check_massless(root: ET.Element, inertias: dict[str, LinkInertia]) -> list[str]:
    """Check links without mass; return one sentence that names those with an effect.

    Raises:
        Error: A link has a shape and joints move it or hang from it, but it has no inertia.
    """
    jointed = {
        link: joint.get("name")
        for joint in root.findall("joint")
        if joint.get("type") in MOVABLE
        for link in ends(joint)
    }
    merged = []
    for link in root.findall("link"):
        name = link.get("name", "")
        shaped = link.find("collision") is not None or link.find("visual") is not None
        inertia = inertias[name]
        if shaped and name in jointed and (inertia.massless or inertia.pointlike):
            raise Error(
                f"link '{name}': got a mass of {inertia.mass:g} kg and an inertia of "
                f"{inertia.moment:g} kg.m^2, expected an <inertial> with those of the part, "
                f"because joint '{jointed[name]}' connects it"
            )
        if not inertia.massless:
            continue
        if link.find("collision") is not None or link.find("inertial") is not None:
            merged.append(name)
    if not merged:
        return []
    return [f"links without mass, merged with the link that carries them: {', '.join(merged)}"]


def _cleaned(root: ET.Element) -> str:
    robot = ET.Element("robot", name=root.get("name") or "robot")
    for element in root:
        if element.tag in CHILDREN["robot"]:
            robot.append(_cleaned_element(element))
    return ET.tostring(robot, encoding="unicode")


def _cleaned_element(element: ET.Element) -> ET.Element:
    """Return a copy with known children and attributes only, and numbers in plain form."""
    known = ATTRIBUTES.get(element.tag, {})
    copy = ET.Element(element.tag)
    for name, count in known.items():
        if name not in element.attrib:
            continue
        text = element.attrib[name]
        copy.set(name, number_text(read_numbers(element, name, count, "")) if count else text)
    fixed = element.tag == "joint" and element.get("type") == "fixed"
    for child in element:
        if child.tag not in CHILDREN.get(element.tag, ()) or child.tag in ("visual", "mimic"):
            continue
        # CAD exports give fixed joints a zero axis.
        if not (fixed and child.tag in ("axis", "limit", "dynamics")):
            copy.append(_cleaned_element(child))
    return copy
