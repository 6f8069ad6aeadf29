# SPDX-License-Identifier: BSD-3-Clause
"""MJCF files: what is found in them, and what is refused by the name of its element."""

from __future__ import annotations

import re
import sys
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from surefoot import Error
from surefoot.cli import main
from surefoot.robot.description import describe_robot
from surefoot.sim import ModelMapping
from surefoot.sim.mjcf.describe import describe_mjcf

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from foreign_mjcf import IMU_POSITION, VARIANTS, write_mjcf

Edit = Callable[[ET.Element], None]
FLAT = 'type="plane" size="0 0 1"'
LINK = '<inertial pos="0 0 0" mass="0.1" diaginertia="1e-4 1e-4 1e-4"/>'
ARM = f'<body name="arm"><joint name="shoulder" axis="0 0 1"/>{LINK}</body>'
WHEEL = f'<body name="wheel"><joint name="wheel" axis="0 1 0"/>{LINK}</body>'
SLIDER = f'<body name="gripper"><joint name="finger" type="slide"/>{LINK}</body>'
FORK = f'<body name="fork"><joint name="second" axis="0 1 0"/>{LINK}</body>'
BALL = f'<body name="ball" pos="3 0 1"><freejoint name="ball"/>{LINK}<geom size="0.1"/></body>'
TENDON = '<tendon><fixed name="belt"><joint joint="FR_hip_joint" coef="1"/></fixed></tendon>'
EQUALITY = '<equality><joint name="lock" joint1="FR_hip_joint"/></equality>'
STEP = f'<body name="step" pos="2 0 0"><geom name="box" type="box" size="1 1 0.1"/>{LINK}</body>'


def find(root: ET.Element, kind: str, name: str) -> ET.Element:
    element = root.find(f".//{kind}[@name='{name}']")
    assert element is not None, name
    return element


def add(where: str, text: str) -> Edit:
    """Add an element to the body of that name, to "worldbody" or to the root."""

    def edit(root: ET.Element) -> None:
        parent = root if where == "mujoco" else root.find("worldbody")
        if where not in ("mujoco", "worldbody"):
            parent = find(root, "body", where)
        assert parent is not None
        parent.append(ET.fromstring(text))

    return edit


def put(kind: str, name: str, **attributes: str) -> Edit:
    return lambda root: find(root, kind, name).attrib.update(attributes)


def option(**attributes: str) -> Edit:
    def edit(root: ET.Element) -> None:
        ET.SubElement(root, "option", attributes)

    return edit


def no_free_joint(root: ET.Element) -> None:
    for parent in root.iter():
        for joint in [j for j in parent if j.tag in ("freejoint", "joint")]:
            if joint.tag == "freejoint" or joint.get("type") == "free":
                parent.remove(joint)


def braked_base(root: ET.Element) -> None:
    """Give the free joint damping, as a default class of joints does."""
    base = find(root, "body", "base")
    for joint in [j for j in base if j.tag in ("freejoint", "joint")]:
        base.remove(joint)
    base.insert(0, ET.fromstring('<joint type="free" damping="1"/>'))


def two_robots(root: ET.Element) -> None:
    world = root.find("worldbody")
    assert world is not None
    text = ET.tostring(find(root, "body", "base"), encoding="unicode")
    world.append(ET.fromstring(re.sub(r'name="', 'name="second_', text)))


def turned(root: ET.Element) -> None:
    """Let the x axis of the base point backward: the hips are where other legs should be."""
    for leg in ("FR", "FL", "RR", "RL"):
        hip = find(root, "body", f"{leg}_hip")
        x, y, z = hip.get("pos", "").split()
        hip.set("pos", f"{-float(x)} {-float(y)} {z}")


def edited(folder: Path, *edits: Edit) -> Path:
    path = write_mjcf(folder / "robot.xml")
    root = ET.parse(path).getroot()
    for edit in edits:
        edit(root)
    path.write_text(ET.tostring(root, encoding="unicode"), encoding="utf-8")
    return path


def mapping(path: Path, robot: str = "go1") -> ModelMapping:
    return describe_mjcf(describe_robot(robot).with_mjcf(path))


REFUSED: dict[str, tuple[list[Edit], tuple[str, ...]]] = {
    "no free joint": ([no_free_joint], ("free joint", "'base'", "<freejoint/>")),
    "several robots": ([two_robots], ("several robots", "'base'", "'second_base'", "remove")),
    "arm": ([add("base", ARM)], ("'shoulder'", "chain of 1", "'arm'", "payload")),
    "wheel": ([add("FL_calf", WHEEL)], ("joint 'wheel'", "fourth joint", "fixed foot")),
    "gripper": ([add("base", SLIDER)], ("joint 'finger'", "slide", "hinges")),
    "second chain": ([add("FL_hip", FORK)], ("joint 'second'", "'FL_hip_joint'", "one chain")),
    "other moving body": ([add("worldbody", BALL)], ("body 'ball'", "no moving body", "remove")),
    "tendon": ([add("mujoco", TENDON)], ("tendon 'belt'", "expected none", "remove")),
    "equality": ([add("mujoco", EQUALITY)], ("equality constraint 'lock'", "remove")),
    "foot box": (
        [put("geom", "RR_foot", type="box", size="0.02 0.02 0.02")],
        ("geom 'RR_foot'", "got a box", "sphere"),
    ),
    "foot capsule across the leg": (
        [put("geom", "RR_foot", type="capsule", size="0.02 0.03", euler="90 0 0")],
        ("geom 'RR_foot'", "got a capsule across the leg", "replace it by a sphere"),
    ),
    "feet of two sizes": ([put("geom", "RL_foot", size="0.03")], ("'RL_foot'", "0.03", "0.02")),
    "foot that collides with nothing": (
        [put("geom", "FR_foot", contype="8", conaffinity="8")],
        ("geom 'FR_foot'", "'ground'", "contype"),
    ),
    "tilted ground": ([put("geom", "ground", quat="0.99 0.1 0 0")], ("geom 'ground'", "level")),
    "high ground": ([put("geom", "ground", pos="0 0 0.2")], ("geom 'ground'", "height 0")),
    "two grounds": (
        [add("worldbody", f'<geom name="other" {FLAT}/>')],
        ("got 2 planes", "'other'"),
    ),
    "obstacle in a fixed body": ([add("worldbody", STEP)], ("geom 'box'", "'step'", "worldbody")),
    "base that looks backward": ([turned], ("joint 'FR_hip_joint'", "rear left", "x axis")),
    "hip along y": ([put("joint", "FL_hip_joint", axis="0 1 0")], ("'FL_hip_joint'", "base x")),
    "no gravity": ([option(gravity="0 0 -1.6")], ("gravity", "0 0 -1.6", "0 0 -9.81")),
    "contacts off": (
        [add("mujoco", '<option><flag contact="disable"/></option>')],
        ("flag 'contact'", "enable"),
    ),
    **{
        f"{flag} off": (
            [add("mujoco", f'<option><flag {flag}="disable"/></option>')],
            (f"flag '{flag}'", "enable"),
        )
        for flag in ("damper", "spring", "frictionloss", "limit")
    },
    "mesh that is missing": (
        [
            add("mujoco", '<asset><mesh name="shell" file="shell.stl"/></asset>'),
            add("base", '<geom type="mesh" mesh="shell"/>'),
        ],
        ("MuJoCo rejects it", "shell.stl", "relative"),
    ),
}


@pytest.mark.parametrize(("edits", "words"), REFUSED.values(), ids=REFUSED)
def test_element_that_the_plant_cannot_simulate_is_refused_by_its_name(
    tmp_path: Path, edits: list[Edit], words: tuple[str, ...]
) -> None:
    path = edited(tmp_path, *edits)
    with pytest.raises(Error) as error:
        mapping(path)
    message = str(error.value)
    assert message.startswith(f"MJCF '{path}': ") and "\n" not in message
    assert all(word in message for word in words), message


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("<robot name='x'/>", "got <robot>, expected <mujoco>"),
        ("<mujoco><worldbody>", "is not a MJCF"),
        ("<mujoco><worldbody/></mujoco>", "free joint"),
        ("<mujoco><nonsense/></mujoco>", "nonsense"),
        ('<mujoco><include file="go1.xml"/></mujoco>', "go1.xml"),
    ],
)
def test_file_that_is_no_robot_is_refused(tmp_path: Path, text: str, words: str) -> None:
    path = tmp_path / "scene.xml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Error, match=re.escape(words)):
        mapping(path)


def test_missing_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(Error, match="MJCF: cannot read"):
        mapping(tmp_path / "none.xml")


@pytest.mark.parametrize("name", VARIANTS)
def test_all_parts_of_every_variant_are_found(tmp_path: Path, name: str) -> None:
    found = mapping(write_mjcf(tmp_path / "robot.xml", *VARIANTS[name]))
    assert [joint.joint for joint in found.joints] == [joint.motor for joint in found.joints]
    assert [foot.geom for foot in found.feet] == ["FR_foot", "FL_foot", "RR_foot", "RL_foot"]
    assert found.base == "base" and found.ground == "geom 'ground'" and not found.doubts
    moved = found.imu_position == pytest.approx(IMU_POSITION)
    assert moved == (name == "IMU elsewhere")


def test_zero_and_sign_of_other_conventions_are_found(tmp_path: Path) -> None:
    path = write_mjcf(
        tmp_path / "robot.xml", *VARIANTS["other initial pose"], *VARIANTS["other axes"]
    )
    hip, thigh, calf = mapping(path).joints[:3]
    assert (hip.sign, thigh.sign, calf.sign) == (1.0, 1.0, -1.0)
    assert [hip.offset, thigh.offset, calf.offset] == pytest.approx([0.0, 0.6, -1.2], abs=1e-5)


def test_joints_and_feet_without_names_are_found_by_structure(tmp_path: Path) -> None:
    path = write_mjcf(tmp_path / "robot.xml")
    root = ET.parse(path).getroot()
    for unused in ("actuator", "sensor", "contact"):
        for element in root.findall(unused):
            root.remove(element)
    for element in root.iter():
        if element.tag in ("joint", "body", "geom", "site"):
            element.attrib.pop("name", None)
    path.write_text(ET.tostring(root, encoding="unicode"), encoding="utf-8")
    found = mapping(path)
    assert len({joint.joint for joint in found.joints}) == 12
    assert all("without a name" in joint.joint for joint in found.joints)
    assert [foot.radius for foot in found.feet] == [0.02] * 4
    assert found.imu == "mount of the TOML of 'go1', no site found"


def test_legs_are_sorted_by_the_positions_of_their_hips(tmp_path: Path) -> None:
    path = write_mjcf(tmp_path / "robot.xml")
    names = {"FR": "leg1", "FL": "leg4", "RR": "leg2", "RL": "leg3"}
    text = re.sub(r"\b(FR|FL|RR|RL)_", lambda match: f"{names[match[1]]}_", path.read_text())
    path.write_text(text, encoding="utf-8")
    joints = [joint.joint for joint in mapping(path).joints[::3]]
    assert joints == [f"{names[leg]}_hip_joint" for leg in ("FR", "FL", "RR", "RL")]


def test_include_and_position_actuators_are_used_as_the_mapping_says(tmp_path: Path) -> None:
    path = edited(tmp_path)
    text = re.sub(r"<general ", '<position kp="80" ', path.read_text())
    path.write_text(
        re.sub(
            r'<position kp="80" (name="\w+" joint="\w+")[^>]*/>', r'<position kp="80" \1/>', text
        )
    )
    scene = tmp_path / "scene.xml"
    scene.write_text(
        '<mujoco><include file="robot.xml"/><option integrator="RK4" timestep="0.004"/>'
        '<keyframe><key name="home"/></keyframe></mujoco>'
    )
    text = str(mapping(scene))
    for words in (
        "actuators are off, with their gains: 12 position",
        "keyframes are not used: 'home'",
        "euler instead of rk4",
        "its timestep, 0.004 s, is replaced by physics_dt",
    ):
        assert words in text, text


def test_command_robots_prints_the_mapping(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write_mjcf(tmp_path / "robot.xml")
    assert main(["robots", "--mjcf", str(path)]) == 0
    printed = capsys.readouterr().out
    assert printed == f"{mapping(path)}\n"
    assert "site 'imu' by its name" in printed and "RL_calf_joint" in printed


def test_check_of_a_robot_and_the_mapping_are_both_printed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write_mjcf(tmp_path / "robot.xml")
    assert main(["robots", "--check", "go1", "--mjcf", str(path)]) == 0
    printed = capsys.readouterr().out
    assert "MuJoCo and Pinocchio differ" in printed and printed.endswith(f"\n\n{mapping(path)}\n")


def test_other_rotor_inertia_and_a_braked_base_are_doubts(tmp_path: Path) -> None:
    found = mapping(edited(tmp_path, put("joint", "RR_calf_joint", armature="0.05"), braked_base))
    assert len(found.doubts) == 2
    assert "armature of joint 'RR_calf_joint' is 0.05" in found.doubts[0]
    assert "free joint of body 'base' has damping" in found.doubts[1]


def test_hip_elsewhere_and_one_longer_calf_are_doubts_that_name_the_leg(tmp_path: Path) -> None:
    hip = put("body", "RL_hip", pos="-0.1881 0.07 0")
    knee, foot = (put("body", f"RR_{part}", pos="0 0 -0.25") for part in ("calf", "foot"))
    found = mapping(edited(tmp_path, hip, knee, foot))
    assert [doubt.split(" is ")[0] for doubt in found.doubts] == [
        "thigh of leg RR of 'go1'",
        "calf of leg RR of 'go1'",
        "hip of leg RL",
    ]
    assert "in the file at (-0.188, 0.070, 0.000) m" in found.doubts[2]


def test_fluid_and_compensated_gravity_of_the_file_are_notes(tmp_path: Path) -> None:
    fluid = option(density="1.2", viscosity="2e-5", wind="3 0 0")
    text = str(mapping(edited(tmp_path, fluid, put("body", "trunk", gravcomp="0.5"))))
    assert "cancels this share of gravity: 0.5 in 'trunk'" in text
    assert "density 1.2, viscosity 2e-05 and wind 3 0 0 of the file are used" in text
    assert "friction, soft_soles and leg_collisions are those of the file's contacts" in text


def test_legs_of_another_robot_are_a_doubt(tmp_path: Path) -> None:
    found = mapping(write_mjcf(tmp_path / "robot.xml", robot="b1"), "go1")
    assert len(found.doubts) >= 3 and "thigh of leg FR of 'go1'" in found.doubts[0]
    assert "hip of leg FR is at (0.188, -0.047, 0.000) m, in the file at (" in found.doubts[2]
    assert np.isclose(found.mass, 55.7, atol=0.2)
