# SPDX-License-Identifier: BSD-3-Clause
"""A URDF and a TOML are loaded right, or refused by the name of the wrong element."""

from __future__ import annotations

from pathlib import Path

import pytest
import surefoot
from robot_edits import Edit, EditedRobot, add, drop, joint, link, put, put_inertia, retag
from surefoot import Error
from surefoot.robot.description import describe_robot
from surefoot.robot.robot_report import check_robot

TINY = {name: "1.68E-27" for name in ("ixx", "iyy", "izz")} | {"ixy": "-3E-45"}
TINY |= {"ixz": "7E-44", "iyz": "0"}
WORLD = '<link name="world"/><joint name="w" type="{}"><origin xyz="0.3 0 0.1" rpy="0 0 1"/>'
WORLD += '<parent link="world"/><child link="base"/></joint>'


@pytest.fixture
def go1(tmp_path: Path) -> EditedRobot:
    return EditedRobot(tmp_path)


@pytest.fixture(scope="module")
def mass() -> float:
    return surefoot.load_robot("go1").mass


INERTIAL = {
    "comma": (put(link("trunk", "/inertial/mass"), value="5,204"), "trunk", "decimal point"),
    "nan": (put_inertia("FR_calf", ixx="nan"), "FR_calf", "finite"),
    "inf": (put_inertia("FR_calf", ixx="1e999"), "FR_calf", "finite"),
    "text": (put_inertia("FR_calf", ixx="heavy"), "FR_calf", "finite"),
    "missing": (drop(link("trunk", "/inertial")), "trunk", "mass of 0 kg"),
    "missing in a leg": (drop(link("RL_calf", "/inertial")), "RL_calf", "'RL_calf_joint'"),
    "no mass": (drop(link("trunk", "/inertial/mass")), "trunk", "no <mass>"),
    "no inertia": (drop(link("trunk", "/inertial/inertia")), "trunk", "no <inertia>"),
    "no ixx": (
        lambda root: root.find(link("trunk", "//inertia")).attrib.pop("ixx"),
        "trunk",
        "ixx",
    ),
    "negative mass": (put(link("FL_hip", "/inertial/mass"), value="-0.6"), "FL_hip", "-0.6 kg"),
    "zero mass": (put(link("FL_hip", "/inertial/mass"), value="0"), "FL_hip", "above 0"),
    "negative moment": (put_inertia("FL_hip", iyy="-1e-3"), "FL_hip", "below 0"),
    "zero inertia": (
        put_inertia("FL_thigh", **dict.fromkeys(TINY, "0")),
        "FL_thigh",
        "inertia of 0 kg.m^2",
    ),
    "triangle": (put_inertia("trunk", izz="0.3"), "trunk", "sum of the other two"),
    "g.mm^2": (put_inertia("trunk", ixx="6e4", iyy="6e4", izz="6e4"), "base", "at most (2 m)^2"),
    "twice": (
        add(link("trunk"), '<inertial><mass value="1"/></inertial>'),
        "trunk",
        "<inertial> twice",
    ),
    "misspelt": (retag(link("trunk", "/inertial"), "inertal"), "trunk", "mean 'inertial'"),
    "tiny but shaped": (put(link("FL_hip", "/inertial/mass"), value="1e-9"), "FL_hip", "mass"),
}


@pytest.mark.parametrize(("edit", "name", "words"), INERTIAL.values(), ids=INERTIAL)
def test_inertia_that_is_missing_or_impossible_names_its_link(
    go1: EditedRobot, edit: Edit, name: str, words: str
) -> None:
    with pytest.raises(Error) as caught:
        go1.load(edit)
    assert f"'{name}'" in str(caught.value)
    assert words in str(caught.value)


def test_tiny_and_massless_fixed_links_are_merged_with_a_doubt(
    go1: EditedRobot, mass: float
) -> None:
    box = '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision>'
    inertial = f'<inertial><mass value="4E-15"/><inertia {attributes(TINY)}/></inertial>'
    files = go1.write(
        add(".", f'<link name="lidar">{inertial}{box}</link><link name="cover">{box}</link>'),
        *(fixed(name, "trunk") for name in ("lidar", "cover")),
    )
    report = check_robot(describe_robot(**files))
    assert report.robot.mass == pytest.approx(mass, abs=1e-9)
    assert any("lidar" in doubt and "cover" in doubt for doubt in report.doubts)


def attributes(values: dict[str, str]) -> str:
    return " ".join(f'{name}="{value}"' for name, value in values.items())


def fixed(child: str, parent: str) -> Edit:
    return add(
        ".",
        f'<joint name="{child}_fixed" type="fixed"><parent link="{parent}"/>'
        f'<child link="{child}"/><axis xyz="0 0 0"/></joint>',
    )


COLLISION = "/collision/geometry/box"
SHAPES = {
    "huge box": (put(link("trunk", COLLISION), size="0.2 1e13 0.1"), "up to 10 m"),
    "flat box": (put(link("trunk", COLLISION), size="0.2 0 0.1"), "above 0"),
    "two sizes": (put(link("trunk", COLLISION), size="0.2 0.1"), "3 numbers"),
    "no shape": (drop(link("trunk", COLLISION)), "got nothing, expected one of <box>"),
    "origin in mm": (put(link("trunk", "/collision/origin"), xyz="0 0 57"), "in m and rad"),
    "turn in degrees": (put(link("trunk", "/collision/origin"), rpy="0 90 0"), "in m and rad"),
}


@pytest.mark.parametrize(("edit", "words"), SHAPES.values(), ids=SHAPES)
def test_wrong_collision_shape_names_its_link(go1: EditedRobot, edit: Edit, words: str) -> None:
    with pytest.raises(Error) as caught:
        go1.load(edit)
    assert "link 'trunk'" in str(caught.value)
    assert words in str(caught.value)


JOINTS = {
    "mimic": (add(joint("FR_hip_joint"), '<mimic joint="FL_hip_joint"/>'), "<mimic>"),
    "zero axis": (put(joint("FR_hip_joint", "/axis"), xyz="0 0 0"), "a direction"),
    "no limit": (drop(joint("FR_hip_joint", "/limit")), "no <limit>"),
    "no effort": (
        lambda root: root.find(joint("FR_hip_joint", "/limit")).attrib.pop("effort"),
        "effort",
    ),
    "zero effort": (put(joint("FR_hip_joint", "/limit"), effort="0"), "above 0"),
    "two axes": (add(joint("FR_hip_joint"), '<axis xyz="0 1 0"/>'), "<axis> twice"),
    "type": (put(joint("FR_hip_joint"), type="revolut"), "did you mean 'revolute'"),
    "planar": (put(joint("FR_hip_joint"), type="planar"), "planar"),
    "floating": (put(joint("FR_hip_joint"), type="floating"), "floating joint below the base"),
    "unknown parent": (put(joint("FR_hip_joint", "/parent"), link="trnk"), "mean 'trunk'"),
    "same name": (put(joint("FL_hip_joint"), name="FR_hip_joint"), "2 times"),
    "prismatic": (put(joint("FR_hip_joint"), type="prismatic"), "does not turn"),
    "turned axis": (put(joint("FR_hip_joint", "/axis"), xyz="-1 0 0"), "axis: got (-1, 0, 0)"),
    "wrong axis": (put(joint("FR_hip_joint", "/axis"), xyz="0 0 1"), "expected x (forward)"),
    "turned origin": (put(joint("FR_hip_joint", "/origin"), rpy="0 0 3.14159"), "axis"),
    "huge speed": (put(joint("FR_hip_joint", "/limit"), velocity="1e6"), "at most 200 rad/s"),
    "huge torque": (put(joint("FR_hip_joint", "/limit"), effort="1e6"), "20 times the weight"),
    "continuous": (put(joint("FR_thigh_joint"), type="continuous"), None),
}


@pytest.mark.parametrize(("edit", "words"), JOINTS.values(), ids=JOINTS)
def test_wrong_joint_is_refused_by_name(go1: EditedRobot, edit: Edit, words: str | None) -> None:
    if words is None:  # takes its limits from the TOML
        lower, upper = -0.663, 2.966
        config = go1.load(edit).config
        assert (config.q_lower[1], config.q_upper[1]) == (lower, upper)
        return
    with pytest.raises(Error) as caught:
        go1.load(edit)
    assert "FR_" in str(caught.value)
    assert words in str(caught.value)


def test_continuous_leg_joint_without_limits_in_the_toml_is_refused(go1: EditedRobot) -> None:
    with pytest.raises(Error, match=r"'FR_thigh_joint': got a continuous .* add thigh = "):
        go1.load(
            put(joint("FR_thigh_joint"), type="continuous"), toml=("thigh = [-0.663, 2.966]", "")
        )


def test_huge_position_limits_are_replaced_by_those_of_the_toml(go1: EditedRobot) -> None:
    wide = put(joint("FR_thigh_joint", "/limit"), lower="-1e6", upper="1e6")
    assert go1.load(wide).config.q_upper[1] == 2.966
    with pytest.raises(Error, match=r"position limits of FR_thigh_joint: got -1\S* \.\. 1"):
        go1.load(wide, toml=("thigh = [-0.663, 2.966]", ""))


@pytest.mark.parametrize("kind", ["fixed", "floating"])
def test_world_link_above_the_base_is_removed(go1: EditedRobot, kind: str, mass: float) -> None:
    files = go1.write(add(".", WORLD.format(kind)))
    report = check_robot(describe_robot(**files))
    same = surefoot.load_robot("go1")
    assert (report.robot.nv, report.robot.mass) == (18, mass)
    assert "link 'world' and its" in report.doubts[0]
    assert list(report.robot.foot_frame_ids) == list(same.foot_frame_ids)


WRONG_WORLDS = {
    "a link": (
        put(link("imu_link"), name="world"),
        put(joint("imu_joint", "/child"), link="world"),
    ),
    "with mass": (
        add(".", WORLD.format("fixed")),
        add(link("world"), '<inertial><mass value="1"/><inertia/></inertial>'),
    ),
    "on a hinge": (
        add(".", WORLD.format("revolute")),
        add(joint("w"), '<limit lower="-1" upper="1" effort="1" velocity="1"/>'),
    ),
}


@pytest.mark.parametrize("edits", WRONG_WORLDS.values(), ids=WRONG_WORLDS)
def test_world_link_at_another_place_is_refused(go1: EditedRobot, edits: tuple[Edit, ...]) -> None:
    with pytest.raises(Error, match="world"):
        go1.load(*edits, toml=('frame = "imu_link"', "position = [0, 0, 0]"))


def rename_legs(root) -> None:
    """Exchange the names of the front legs."""
    for element in root.iter():
        for key, value in element.attrib.items():
            if value.startswith(("FR_", "FL_")):
                element.set(key, {"FR_": "FL_", "FL_": "FR_"}[value[:3]] + value[3:])


GEOMETRY = {
    "left is right": (rename_legs, ("", ""), ["FR_foot", "front right"]),
    "front is rear": (
        lambda root: [
            element.attrib.update({k: swapped(v) for k, v in element.attrib.items()})
            for element in root.iter()
        ],
        ("", ""),
        ["FR_foot", "front right"],
    ),
    "foot on its joint": (
        put(joint("FR_foot_fixed", "/origin"), xyz="0 0 0"),
        ("", ""),
        ["FR_foot", "FR_calf_joint", "0 m from the axis"],
    ),
    "foot on the thigh": (
        put(joint("FR_foot_fixed", "/parent"), link="FR_thigh"),
        ("", ""),
        ["FR_foot", "FR_thigh_joint", "expected the calf joint"],
    ),
    "no foot radius": (None, ("radius = 0.02 ", "radius = 0 "), ["foot radius: got 0"]),
    "foot radius of a calf": (None, ("radius = 0.02 ", "radius = 0.4 "), ["foot radius: got 0.4"]),
    "degrees": (
        None,
        ("[0.0, 0.8, -1.6]", "[0.0, 45, -90]"),
        ["standing pose of FR_thigh_joint: got 45", "looks like degrees"],
    ),
    "outside": (None, ("[0.0, 0.8, -1.6]", "[0.0, 0.8, 1.6]"), ["FR_calf_joint: got 1.6"]),
    "upside down": (None, ("[0.0, 0.8, -1.6]", "[0.0, 2.9, -0.9]"), ["FR_foot", "below its hip"]),
    "no such SRDF": (None, ("go1.srdf", "go7.srdf"), ["SRDF not found", "go7.srdf"]),
    "foot twice": (None, ('"FR_foot", "FL_foot"', '"FL_foot", "FL_foot"'), ["'FL_foot' twice"]),
}


def swapped(value: str) -> str:
    ends = {"FR_": "RR_", "RR_": "FR_", "FL_": "RL_", "RL_": "FL_"}
    return ends.get(value[:3], value[:3]) + value[3:]


@pytest.mark.parametrize(("edit", "toml", "words"), GEOMETRY.values(), ids=GEOMETRY)
def test_structure_that_contradicts_geometry_is_refused(
    go1: EditedRobot, edit: Edit | None, toml: tuple[str, str], words: list[str]
) -> None:
    with pytest.raises(Error) as caught:
        go1.load(*[edit] * (edit is not None), toml=toml)
    assert [word for word in words if word not in str(caught.value)] == []


def test_srdf_with_an_unknown_link_is_refused(go1: EditedRobot) -> None:
    files = go1.write(toml=("go1_description/srdf/go1.srdf", "/my.srdf"))
    text = (
        Path(files["config"])
        .read_text()
        .replace(f"{go1.description.mesh_root}/robots//my.srdf", "my.srdf")
    )
    files["config"].write_text(text)
    (go1.folder / "my.srdf").write_text(
        '<robot name="go1"><disable_collisions link1="trunk" link2="FR_hop"/></robot>'
    )
    with pytest.raises(Error, match=r"my\.srdf': <disable_collisions link2>: got 'FR_hop'"):
        surefoot.load_robot(**files)
    (go1.folder / "my.srdf").write_text("<robot")
    with pytest.raises(Error, match=r"my\.srdf' is not a SRDF"):
        surefoot.load_robot(**files)


def test_names_with_spaces_survive_the_robot_file(go1: EditedRobot, tmp_path: Path) -> None:
    def rename(root) -> None:
        for element in root.iter():
            for key, value in element.attrib.items():
                if value in ("FR_foot", "FR_hip_joint"):
                    element.set(key, value.replace("_", " "))

    text = go1.toml.replace('"FR_foot"', '"FR foot"').replace('"FR_hip_joint"', '"FR hip joint"')
    go1.toml = text.replace("srdf =", "# srdf =")
    robot = go1.load(rename)
    robot.save(str(tmp_path / "my.robot"))
    twin = surefoot.Robot.load(str(tmp_path / "my.robot"))
    assert twin.config.foot_frames == robot.config.foot_frames
    assert twin.config.joint_names[0] == "FR hip joint"
    with pytest.raises(Error, match="foot frame 0: got 'FR\nfoot'"):
        config = robot.config
        config.foot_frames = ["FR\nfoot", *config.foot_frames[1:]]
        surefoot.Robot.from_serialized_model(robot.serialized_model(), config)


def test_weak_motor_is_accepted_with_a_doubt(go1: EditedRobot) -> None:
    robot = go1.load(put(joint("FR_calf_joint", "/limit"), effort="1"))
    assert ["torque limit of FR_calf_joint" in doubt for doubt in robot.doubts] == [True]


@pytest.mark.parametrize("name", ["a1", "go1", "go2", "b1"])
def test_known_robots_have_no_doubt_but_links_without_mass(name: str) -> None:
    report = check_robot(describe_robot(name))
    assert [d for d in report.doubts if not d.startswith("links without mass")] == []
    assert [leg.leg for leg in report.legs] == ["FR", "FL", "RR", "RL"]
    assert sum(body.mass for body in report.bodies) == pytest.approx(report.robot.mass)
