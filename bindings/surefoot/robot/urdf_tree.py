"""Checks of the tree of links and joints of a URDF."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections import Counter

from surefoot._core import Error
from surefoot.robot.robot_toml import suggest


def check_names(root: ET.Element) -> None:
    """Raise Error unless each link and each joint has a name of its own."""
    for kind in ("link", "joint"):
        names = [element.get("name", "") for element in root.findall(kind)]
        if "" in names:
            raise Error(f"{kind} {names.index('')}: got no name, expected one")
        name, count = Counter(names).most_common(1)[0] if names else ("", 0)
        if count > 1:
            raise Error(f"{kind} '{name}': got it {count} times, expected names of their own")
    links = {link.get("name") for link in root.findall("link")}
    for joint in root.findall("joint"):
        own = joint.get("name")
        if own in links and ends(joint)[1] != own:
            raise Error(
                f"joint '{own}': got the name of a link that it does not move, expected another"
            )


def ends(joint: ET.Element) -> tuple[str, str]:
    """Return the names of a joint's parent and child link; raise Error if one is missing."""
    names = []
    for tag in ("parent", "child"):
        element = joint.find(tag)
        name = "" if element is None else element.get("link", "")
        if not name:
            raise Error(f"joint '{joint.get('name')}': got no <{tag} link>, expected a link")
        names.append(name)
    return names[0], names[1]


def find_root(root: ET.Element) -> str:
    """Return the name of the root link.

    Raises:
        Error: The links and joints are not one tree.
    """
    links = [link.get("name", "") for link in root.findall("link")]
    if not links:
        raise Error("got no <link>, expected a robot")
    parents: dict[str, tuple[str, str]] = {}
    for joint in root.findall("joint"):
        name, (parent, child) = joint.get("name", ""), ends(joint)
        for link in (parent, child):
            if link not in links:
                raise Error(
                    f"joint '{name}': got link '{link}'{suggest(link, links)}, expected a link of "
                    "the URDF"
                )
        if child in parents:
            raise Error(
                f"link '{child}': got joints '{parents[child][1]}' and '{name}' above it, "
                "expected one"
            )
        parents[child] = (parent, name)
    roots = [link for link in links if link not in parents]
    if not roots:
        raise Error(f"joint '{parents[links[0]][1]}': got a loop of joints, expected a tree")
    if len(roots) > 1:
        raise Error(
            f"links {', '.join(repr(link) for link in roots[:4])}: got no joint above them, "
            "expected one root; is a <joint> missing?"
        )
    _check_reachable(links, parents, roots[0])
    return roots[0]


def _check_reachable(links: list[str], parents: dict[str, tuple[str, str]], root: str) -> None:
    for link in links:
        at, steps = link, 0
        while at != root and steps <= len(links):
            at, steps = parents[at][0], steps + 1
        if at != root:
            raise Error(f"link '{link}': got a loop of joints above it, expected a tree")


def remove_world(root: ET.Element, base: str) -> tuple[str, list[str]]:
    """Remove a link above the robot that stands for the world, and the joint to it.

    Pinocchio and MuJoCo give the robot a free base themselves. A link named world, or a floating
    joint, would be a second one, or would shift one of the two bases.

    Args:
        root: The URDF.
        base: Name of its root link.

    Returns:
        The root link without the world, and a sentence if something was removed.

    Raises:
        Error: A floating joint or a link named world is at another place.
    """
    doubts: list[str] = []
    joints = [joint for joint in root.findall("joint") if ends(joint)[0] == base]
    world = next(link for link in root.findall("link") if link.get("name") == base)
    kinds = [joint.get("type") for joint in joints]
    if kinds == ["floating"] or (base == "world" and kinds == ["fixed"]):
        if world.find("inertial") is not None:
            raise Error(
                f"link '{base}': got an <inertial> above a {kinds[0]} joint, expected the world "
                "without mass; remove it"
            )
        root.remove(world)
        root.remove(joints[0])
        removed, base = base, ends(joints[0])[1]
        doubts.append(
            f"link '{removed}' and its {kinds[0]} joint are removed; '{base}' is the base"
        )
    for joint in root.findall("joint"):
        if joint.get("type") == "floating":
            raise Error(
                f"joint '{joint.get('name')}': got a floating joint below the base '{base}', "
                "expected the free base only; make it fixed, or remove it"
            )
    for link in root.findall("link"):
        if link.get("name") == "world":
            raise Error(
                "link 'world': got it as a part of the robot, expected it above one fixed or "
                "floating joint; rename it"
            )
    return base, doubts
