"""Elements and attributes of a URDF that matter to dynamics and contacts."""

from __future__ import annotations

import xml.etree.ElementTree as ET

from surefoot._core import Error
from surefoot.robot.robot_toml import suggest

# Elements by their parent. All others are ignored, such as <gazebo>, unless a name looks like a
# misspelt one.
CHILDREN = {
    "robot": ("link", "joint"),
    "link": ("inertial", "visual", "collision"),
    "inertial": ("origin", "mass", "inertia"),
    "collision": ("origin", "geometry"),
    "geometry": ("box", "cylinder", "sphere", "capsule", "mesh"),
    "joint": ("origin", "parent", "child", "axis", "limit", "dynamics", "mimic"),
}
# Attributes by their element, each with its count of numbers; 0: text.
ATTRIBUTES = {
    "robot": {"name": 0},
    "link": {"name": 0},
    "joint": {"name": 0, "type": 0},
    "parent": {"link": 0},
    "child": {"link": 0},
    "origin": {"xyz": 3, "rpy": 3},
    "mass": {"value": 1},
    "inertia": {"ixx": 1, "ixy": 1, "ixz": 1, "iyy": 1, "iyz": 1, "izz": 1},
    "axis": {"xyz": 3},
    "limit": {"lower": 1, "upper": 1, "effort": 1, "velocity": 1},
    "dynamics": {"damping": 1, "friction": 1},
    "box": {"size": 3},
    "cylinder": {"radius": 1, "length": 1},
    "capsule": {"radius": 1, "length": 1},
    "sphere": {"radius": 1},
    "mesh": {"filename": 0, "scale": 3},
}
_REPEATABLE = ("link", "joint", "visual", "collision")
# Further elements of the URDF standard that have no effect here.
_IGNORED = {
    "robot": ("material", "transmission", "gazebo", "sensor", "mujoco"),
    "link": ("contact", "self_collision_checking"),
    "collision": ("material", "verbose"),
    "joint": ("calibration", "safety_controller"),
}


def check_elements(element: ET.Element, where: str) -> list[str]:
    """Check the names of an element's attributes and children, and of their children.

    Args:
        element: An element whose tag is a key of CHILDREN or ATTRIBUTES.
        where: Link or joint of the element, for messages.

    Returns:
        One sentence for each unknown element that is ignored.

    Raises:
        Error: A name looks like a misspelt one, or an element is given twice.
    """
    known = ATTRIBUTES.get(element.tag, {})
    for name in element.attrib.keys() - known.keys():
        if guess := suggest(name, known):
            raise Error(
                f"{where}: got unknown attribute <{element.tag} {name}>{guess}, expected one of "
                "the URDF standard"
            )
    doubts: list[str] = []
    seen: set[str] = set()
    valid = CHILDREN.get(element.tag, ())
    for child in element:
        if child.tag not in valid:
            doubts += _check_unknown(element.tag, child.tag, where)
            continue
        if child.tag in seen and child.tag not in _REPEATABLE:
            raise Error(f"{where}: got <{child.tag}> twice in <{element.tag}>, expected it once")
        seen.add(child.tag)
        if child.tag not in ("link", "joint", "visual"):
            doubts += check_elements(child, where)
    return doubts


def _check_unknown(parent: str, tag: str, where: str) -> list[str]:
    if tag.startswith("{") and "xacro" in tag:
        raise Error(f"{where}: got <xacro:{tag.partition('}')[2]}>, expected a URDF; run xacro")
    if tag in _IGNORED.get(parent, ()):
        return []
    guess = suggest(tag, CHILDREN.get(parent, ()))
    if guess:
        raise Error(
            f"{where}: got unknown element <{tag}> in <{parent}>{guess}, expected one of the URDF "
            "standard"
        )
    return [f"{where}: unknown element <{tag}> in <{parent}> is ignored"]
