# SPDX-License-Identifier: BSD-3-Clause
"""The simulated robot of a user's URDF agrees with the controller's, or is refused by name."""

from __future__ import annotations

import struct
import sys
from pathlib import Path

import pytest
import surefoot
from surefoot import Error
from surefoot.cli import main
from surefoot.robot.loading import RobotDescription, build_robot, describe_robot
from surefoot.sim import Plant
from surefoot.sim.model.agreement import compare_models
from surefoot.stand import StandSettings, run_stand

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))

from robot_edits import Edit, EditedRobot, add, drop, joint, link, put, put_inertia

BOX = '<collision><geometry><box size="0.3 0.2 0.1"/></geometry></collision>'
LIDAR = '<link name="lidar">{}</link><joint name="l" type="fixed"><parent link="trunk"/>'
LIDAR += '<child link="lidar"/></joint>'
TINY = '<inertial><mass value="4E-15"/><inertia ixx="1.68E-27" ixy="-3E-45" ixz="7E-44" '
TINY += 'iyy="1.68E-27" iyz="-9E-47" izz="1.68E-27"/></inertial>'
MATERIALS = '<material name="x"><color rgba="1 0 0 1"/></material>' * 2
WORLD = '<link name="world"/><joint name="w" type="fixed"><origin xyz="0.3 0 0.1" rpy="0 0 1"/>'
WORLD += '<parent link="world"/><child link="base"/></joint>'
POINT = "".join(f'{name}="0" ' for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
ACCEPTED: dict[str, list[Edit]] = {
    "two materials of one name": [add(".", MATERIALS)],
    "link with a shape and no mass": [add(".", LIDAR.format(BOX))],
    "CAD-tiny inertia": [add(".", LIDAR.format(TINY + BOX))],
    "point mass": [
        add(".", LIDAR.format(f'<inertial><mass value="0.3"/><inertia {POINT}/></inertial>'))
    ],
    "link world with an offset": [add(".", WORLD)],
    "inertia on the edge of the triangle": [
        put_inertia("FR_hip", ixx="1e-3", iyy="1e-3", izz="2.000001e-3", ixy="0", ixz="0", iyz="0")
    ],
    "continuous thigh": [put(joint("FR_thigh_joint"), type="continuous")],
    "axis of another length": [put(joint("FR_thigh_joint", "/axis"), xyz="0 2.5 0")],
    "inertia in turned axes": [put(link("trunk", "/inertial/origin"), rpy="0.3 -0.2 0.5")],
}


@pytest.mark.parametrize("edits", ACCEPTED.values(), ids=ACCEPTED)
def test_plant_and_controller_agree_on_an_unusual_urdf(tmp_path: Path, edits: list[Edit]) -> None:
    description = describe_robot(**EditedRobot(tmp_path).write(*edits))
    robot = build_robot(description)
    assert compare_models(robot, description).worst < 1e-6
    log = run_stand(StandSettings(description, 0.3))
    assert not log.fell


def test_point_mass_counts_in_plant_and_controller(tmp_path: Path) -> None:
    description = describe_robot(**EditedRobot(tmp_path).write(*ACCEPTED["point mass"]))
    plant = Plant(description)
    assert plant.robot.mass == pytest.approx(surefoot.load_robot("go1").mass + 0.3)
    assert plant.model.body_mass.sum() == pytest.approx(plant.robot.mass)


@pytest.mark.parametrize("name", ["a1", "go1", "go2", "b1"])
def test_plant_of_a_known_robot_agrees_with_its_controller(name: str) -> None:
    description = describe_robot(name)
    assert compare_models(build_robot(description), description).worst < 1e-6


def ascii_stl(path: Path) -> None:
    corners = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    facet = f"facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n"
    path.write_text(f"solid box\n{facet * 9}endsolid\n")


def lfs_pointer(path: Path) -> None:
    path.write_text("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a2146\nsize 12345\n")


def flat_stl(path: Path) -> None:
    triangle = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    path.write_bytes(bytes(80) + struct.pack("<I", 4) + triangle * 4)


def truncated_stl(path: Path) -> None:
    path.write_bytes(bytes(80) + struct.pack("<I", 4000))


def missing(path: Path) -> None:
    path.unlink(missing_ok=True)


def is_folder(path: Path) -> None:
    path.mkdir()


def box_stl(path: Path) -> None:
    corners = [(x, y, z) for x in (0.0, 0.1) for y in (0.0, 0.1) for z in (0.0, 0.1)]
    faces = [(a, b, c) for a in range(8) for b in range(a) for c in range(b)]
    body = b"".join(
        struct.pack("<12fH", 0, 0, 1, *corners[a], *corners[b], *corners[c], 0) for a, b, c in faces
    )
    path.write_bytes(bytes(80) + struct.pack("<I", len(faces)) + body)


MESH = '<link name="lidar"><collision><geometry><mesh filename="package://mine/meshes/box.stl"/>'
MESH += '</geometry></collision></link><joint name="l" type="fixed"><parent link="trunk"/>'
MESH += '<child link="lidar"/><origin xyz="0 0 0.1"/></joint>'


def with_mesh(folder: Path) -> tuple[RobotDescription, Path]:
    (folder / "meshes").mkdir()
    description = describe_robot(**EditedRobot(folder).write(add(".", MESH)))
    return description, folder / "meshes" / "box.stl"


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (ascii_stl, "ASCII STL"),
        (lfs_pointer, "Git LFS pointer"),
        (truncated_stl, "MuJoCo rejects it"),
        (missing, "mesh not found"),
        (is_folder, "mesh"),
    ],
)
def test_mesh_that_mujoco_cannot_read_is_refused_by_name(tmp_path: Path, make, words) -> None:
    description, mesh = with_mesh(tmp_path)
    make(mesh)
    with pytest.raises(Error, match=words) as caught:
        Plant(description)
    assert "box" in str(caught.value)
    assert "\n" not in str(caught.value)
    assert build_robot(description).name == "go1"  # the controller needs no mesh


def test_relative_path_of_a_urdf_with_collision_meshes_works(tmp_path, monkeypatch) -> None:
    _, mesh = with_mesh(tmp_path)
    box_stl(mesh)
    monkeypatch.chdir(tmp_path.parent)
    relative = Path(tmp_path.name)
    Plant(describe_robot(urdf=relative / "my.urdf", config=relative / "my.toml"))


def test_collada_collision_mesh_is_refused_by_name(tmp_path: Path) -> None:
    edited = EditedRobot(tmp_path)
    (tmp_path / "box.dae").write_text("<COLLADA/>")
    files = edited.write(add(".", MESH.replace("package://mine/meshes/box.stl", "box.dae")))
    with pytest.raises(Error, match=r"box\.dae': got format '\.dae'.*expected \.stl"):
        Plant(describe_robot(**files))


def test_check_prints_masses_legs_feet_and_doubts(tmp_path: Path, capsys) -> None:
    files = EditedRobot(tmp_path).write(add(".", LIDAR.format(TINY + BOX)))
    assert main(["robots", "--check", str(files["urdf"]), "--config", str(files["config"])]) == 0
    out = capsys.readouterr().out
    for words in ("go1: 13.1", "FR_calf_joint", "0.213", "foot in the standing pose", "lidar"):
        assert words in out
    assert "MuJoCo and Pinocchio differ by" in out


def test_check_of_a_known_robot_and_of_wrong_arguments(tmp_path: Path, capsys) -> None:
    assert main(["robots", "--check", "go2"]) == 0
    assert "go2: 16.085 kg" in capsys.readouterr().out
    files = EditedRobot(tmp_path).write(drop(link("trunk", "/inertial")))
    arguments = ["robots", "--check", str(files["urdf"]), "--config", str(files["config"])]
    assert main(arguments) == 2
    assert "link 'trunk'" in capsys.readouterr().err
    for wrong in (["--check", "go7"], ["--config", "x"], ["--check", "x", "--robot", "go1"]):
        assert main(["robots", *wrong]) == 2
        assert "surefoot: error:" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["aliengo", "b2"])
def test_robot_without_a_urdf_needs_its_name_and_a_urdf(tmp_path: Path, name: str, capsys) -> None:
    # go1's links and joints have the same names.
    continuous = put(joint("FR_thigh_joint"), type="continuous")
    urdf = EditedRobot(tmp_path).write(*[continuous] * (name == "aliengo"))["urdf"]
    with pytest.raises(Error, match=rf"robot '{name}': got no URDF.*--urdf"):
        surefoot.load_robot(name)
    robot = surefoot.load_robot(name, urdf=urdf)
    assert robot.name == name
    # aliengo: of the TOML; b2: of the URDF
    assert robot.config.q_upper[1] == (3.927 if name == "aliengo" else 4.501)
    assert main(["robots"]) == 0
    assert name in capsys.readouterr().out
