"""Checks of the links of a URDF: inertia and collision geometry."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from typing import NamedTuple

import numpy as np

from surefoot._core import Error
from surefoot.robot.urdf_numbers import read_number, read_numbers
from surefoot.robot.urdf_schema import ATTRIBUTES

# A link with at most this mass [kg] and these moments [kg.m^2] does not change a robot of 10 kg
# within 1e-6. Derived from the <link name="base"> of go1 and b1, whose six entries 1e-6 kg.m^2 are
# no valid inertia. If larger: a wrong inertia could hide.
NEGLIGIBLE_MASS = 2e-6
NEGLIGIBLE_MOMENT = 2e-6
# [m] Largest size of a collision shape and largest offset. Chosen: a quadruped is smaller than 2 m.
# If larger: MuJoCo's contact forces overflow; a file in mm passes.
MAX_SIZE = 10.0
# Share of the largest moment by which the other two may miss it: rounded numbers of thin rods.
_TRIANGLE_TOLERANCE = 1e-6


class LinkInertia(NamedTuple):
    """Mass [kg] and largest entry of the inertia [kg.m^2] of a link."""

    mass: float
    moment: float

    @property
    def massless(self) -> bool:
        """Whether the link has no inertia of its own."""
        return self.mass <= NEGLIGIBLE_MASS

    @property
    def pointlike(self) -> bool:
        """Whether the moments are below those of a body of 1 mm."""
        return self.moment < 1e-6 * self.mass


def check_link(link: ET.Element) -> LinkInertia:
    """Check the numbers of a link and return its inertia, zeros without <inertial>.

    Raises:
        Error: A number cannot be read, a size is not above 0, or the inertia is impossible and not
            negligible.
    """
    where = f"link '{link.get('name')}'"
    for collision in link.findall("collision"):
        check_origin(collision, where)
        _check_geometry(collision, where)
    inertial = link.find("inertial")
    return LinkInertia(0.0, 0.0) if inertial is None else _check_inertial(inertial, where)


def check_origin(element: ET.Element, where: str) -> None:
    """Raise Error if an element's <origin> has a number that cannot be read or is in mm or deg."""
    origin = element.find("origin")
    for name in ("xyz", "rpy"):
        if origin is None or name not in origin.attrib:
            continue
        values = read_numbers(origin, name, 3, where)
        if max(map(abs, values)) > MAX_SIZE:
            raise Error(
                f"{where}: <origin {name}>: got '{origin.get(name)}', expected at most "
                f"{MAX_SIZE:g}, in m and rad"
            )


def _check_inertial(inertial: ET.Element, where: str) -> LinkInertia:
    check_origin(inertial, where)
    mass_element, inertia = inertial.find("mass"), inertial.find("inertia")
    if mass_element is None or inertia is None:
        missing = "mass" if mass_element is None else "inertia"
        raise Error(f"{where}: <inertial> has no <{missing}>, expected <mass> and <inertia>")
    mass = read_number(mass_element, "value", where)
    xx, xy, xz, yy, yz, zz = (read_number(inertia, name, where) for name in ATTRIBUTES["inertia"])
    matrix = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if mass < 0.0:
        raise Error(f"{where}: mass: got {mass:g} kg, expected 0 or more")
    found = LinkInertia(mass, float(np.abs(matrix).max()))
    negligible = found.moment <= NEGLIGIBLE_MOMENT
    if found.massless and not negligible:
        raise Error(f"{where}: mass: got {mass:g} kg with an inertia, expected a mass above 0")
    low, middle, high = np.linalg.eigvalsh(matrix)
    valid = low >= -1e-9 * high and low + middle >= (1.0 - _TRIANGLE_TOLERANCE) * high
    if not (valid or (negligible and found.massless)):
        raise Error(
            f"{where}: inertia: got principal moments {low:.4g}, {middle:.4g}, {high:.4g} kg.m^2, "
            "expected none below 0 and none above the sum of the other two; correct <inertia>"
        )
    return found


def _check_geometry(collision: ET.Element, where: str) -> None:
    geometry = collision.find("geometry")
    shapes = [] if geometry is None else [s for s in geometry if s.tag in ATTRIBUTES]
    if len(shapes) != 1:
        got = ", ".join(f"<{shape.tag}>" for shape in shapes) or "nothing"
        raise Error(
            f"{where}: <geometry> of <collision>: got {got}, expected one of <box>, <cylinder>, "
            "<sphere>, <capsule>, <mesh>"
        )
    shape = shapes[0]
    if shape.tag == "mesh":
        if not shape.get("filename", "").strip():
            raise Error(f"{where}: <mesh> of <collision>: got no filename, expected a file")
        if "scale" in shape.attrib and 0.0 in read_numbers(shape, "scale", 3, where):
            raise Error(f"{where}: <mesh scale>: got '{shape.get('scale')}', expected no zero")
        return
    for name, count in ATTRIBUTES[shape.tag].items():
        values = read_numbers(shape, name, count, where)
        if min(values) <= 0.0 or max(values) > MAX_SIZE:
            raise Error(
                f"{where}: <{shape.tag} {name}>: got '{shape.get(name)}', expected sizes above 0, "
                f"up to {MAX_SIZE:g} m"
            )
