# SPDX-License-Identifier: BSD-3-Clause
"""A plant from an MJCF: its values are those of the file, and the controller stands and walks."""

from __future__ import annotations

import json
import re
import sys
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
import surefoot
from surefoot import Error
from surefoot.assess.foreign_stance import plant_stance
from surefoot.assess.stance_model import stance_model
from surefoot.cli import main
from surefoot.robot.loading import build_robot, describe_robot
from surefoot.sim import Plant, PlantSettings, Terrain
from surefoot.sim.model.mujoco_model import trunk_mass
from surefoot.stand import StandSettings, parse_push, run_stand, summarise
from surefoot.tune.live.simulation import Simulation
from surefoot.walk import WalkSettings, parse_velocity, run_walk
from surefoot.walk.commands import command_figures

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from foreign_mjcf import VARIANTS, bent_pose, other_axes, write_mjcf

COARSE = PlantSettings(physics_dt=0.001, seed=1)
WALKING = replace(COARSE, walking_sensors=True)


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Return the MJCF files of all variants, by name."""
    folder = tmp_path_factory.mktemp("mjcf")
    return {
        name: write_mjcf(folder / f"{k}.xml", *changes)
        for k, (name, changes) in enumerate(VARIANTS.items())
    }


def stand(mjcf: Path | None, duration: float = 2.0, push: str | None = None) -> Any:
    robot = describe_robot("go1") if mjcf is None else describe_robot("go1").with_mjcf(mjcf)
    pushes = () if push is None else (parse_push(push),)
    return run_stand(StandSettings(robot, duration, COARSE, pushes=pushes))


@pytest.mark.parametrize("name", ["ours", "other initial pose", "other axes"])
def test_our_own_model_moves_as_our_own_plant(files: dict[str, Path], name: str) -> None:
    # Other zeros of the joints change the rounding of their angles. A push of 50 % unloads two
    # feet, and these errors then grow to 1 mm, with any controller.
    percent = 40 if name == "other initial pose" else 50
    push = f"lateral:{percent}%:0.1@0.1"
    ours, theirs = stand(None, 0.5, push), stand(files[name], 0.5, push)
    assert np.abs(ours.q_true - theirs.q_true).max() < 1e-3
    assert np.abs(ours.tau - theirs.tau).max() < 0.5
    assert ours.lip_limit == pytest.approx(theirs.lip_limit, rel=1e-3)


def test_file_with_other_axes_and_zeros_in_degrees_moves_as_our_own_plant(
    tmp_path: Path,
) -> None:
    path = write_mjcf(tmp_path / "robot.xml", bent_pose, other_axes)
    root = ET.parse(path).getroot()
    compiler = root.find("compiler")
    assert compiler is not None and compiler.get("angle") == "radian"
    compiler.set("angle", "degree")
    for joint in root.iter("joint"):
        if "range" in joint.attrib:
            low, high = np.degrees([float(text) for text in joint.attrib["range"].split()])
            joint.set("range", f"{low:.9g} {high:.9g}")
    path.write_text(ET.tostring(root, encoding="unicode"))
    ours, theirs = stand(None, 0.5), stand(path, 0.5)
    assert np.abs(ours.q_true - theirs.q_true).max() < 1e-3
    plants = Plant("go1", COARSE), Plant("go1", COARSE, mjcf=path)
    names = plants[0].robot.config.joint_names
    ranges = [np.array([plant.model.joint(name).range for name in names]) for plant in plants]
    assert np.allclose(*ranges, atol=1e-4)


@pytest.mark.parametrize("name", VARIANTS)
def test_robot_stands_after_a_push_of_50_percent(files: dict[str, Path], name: str) -> None:
    log = stand(files[name], 3.0, "lateral:50%:0.1@0.5")
    assert not log.fell and summarise(log)["settled"]


@pytest.mark.slow
@pytest.mark.parametrize("name", VARIANTS)
def test_robot_walks_at_a_half_metre_per_second(files: dict[str, Path], name: str) -> None:
    robot = describe_robot("go1").with_mjcf(files[name])
    velocities = (parse_velocity("0.5,0,0@0.5"),)
    log = run_walk(WalkSettings(robot, 5.0, WALKING, velocities=velocities))
    assert not log.fell
    assert log.com_velocity[1500:, 0].mean() == pytest.approx(0.5, abs=0.08)


@pytest.mark.slow
def test_robot_walks_sideways_and_turns_on_a_slippery_floor(files: dict[str, Path]) -> None:
    robot = describe_robot("go1").with_mjcf(files["friction 0.4"])
    velocities = tuple(parse_velocity(text) for text in ("0,0.3,0@0.5", "0,0,1@3"))
    log = run_walk(WalkSettings(robot, 5.5, WALKING, velocities=velocities))
    assert not log.fell
    for command in command_figures(log):
        assert command["velocity_rmse"].max() <= 0.08, command


def test_masses_joints_and_contacts_are_those_of_the_file(files: dict[str, Path]) -> None:
    plants = {name: Plant("go1", COARSE, mjcf=path) for name, path in files.items()}
    ours = plants["ours"]
    assert plants["friction 0.4"].friction == 0.4 and ours.friction == 0.8
    assert plants["mass +10 %"].model.body_mass.sum() == pytest.approx(1.1 * ours.robot.mass)
    assert plants["foot radius -10 %"].handles.foot_radius == pytest.approx(0.018)
    damped, feet = plants["damping 2"], plants["soft contact"].handles.foot_geoms
    assert np.allclose(damped.model.dof_damping[damped.handles.joint_v].reshape(12, -1)[:, 0], 2.0)
    assert np.allclose(plants["soft contact"].model.geom_solimp[feet, 0], 0.015)
    assert all(plant.robot.mass == ours.robot.mass for plant in plants.values())


def test_first_sample_has_the_angles_of_our_convention(files: dict[str, Path]) -> None:
    for name in ("other initial pose", "other axes"):
        state = Plant("go1", PlantSettings(sensors="ideal"), mjcf=files[name]).reset()
        angles = [state.motorState[i].q for i in range(12)]
        assert np.allclose(angles, surefoot.load_robot("go1").config.q_standing, atol=0.05), name


def test_stance_of_our_own_model_is_that_of_the_controller(files: dict[str, Path]) -> None:
    plant = Plant("go1", COARSE, mjcf=files["ours"])
    theirs, ours = plant_stance(plant), stance_model(plant.robot)
    assert theirs.mass == pytest.approx(ours.mass)
    for name in ("com", "contacts", "jacobians", "gravity_torque"):
        assert np.allclose(getattr(theirs, name), getattr(ours, name), atol=1e-9), name


def test_actuators_and_keyframes_of_the_file_have_no_effect(
    tmp_path: Path, files: dict[str, Path]
) -> None:
    other = tmp_path / "other.xml"
    text = re.sub(r"<actuator>.*</actuator>", "", files["ours"].read_text(), flags=re.DOTALL)
    position = '<position name="p" joint="FR_calf_joint" kp="500"/>'
    pose = " ".join(["0 0 0.6 1 0 0 0", *["0.2"] * 12])
    keyframe = f'<keyframe><key name="home" qpos="{pose}"/></keyframe>'
    added = f"<actuator>{position}</actuator>{keyframe}"
    other.write_text(text.replace("</mujoco>", f"{added}</mujoco>"))
    assert np.array_equal(stand(files["ours"], 0.2).commands, stand(other, 0.2).commands)


def test_foot_without_a_ground_stands_on_a_plane_with_its_own_friction(
    tmp_path: Path, files: dict[str, Path]
) -> None:
    path = tmp_path / "robot.xml"
    path.write_text(re.sub(r'<geom name="ground"[^>]*/>', "", files["friction 0.4"].read_text()))
    plant = Plant("go1", COARSE, mjcf=path)
    assert plant.friction == 0.4
    assert plant.mapping is not None and "a plane is added" in plant.mapping.ground


def unusual_defaults(spec: mujoco.MjSpec) -> None:
    """Set the default class "main"; the elements of the file keep their values."""
    geom, joint, tendon = spec.default.geom, spec.default.joint, spec.default.tendon
    geom.contype = geom.conaffinity = 0
    geom.priority, geom.margin, geom.solref, geom.solimp = 1, 0.05, [0.5, 1.0], [0.1] * 5
    joint.stiffness, joint.ref, joint.springref = [50.0, 0.0, 0.0], 0.3, 0.4
    joint.limited, joint.range = mujoco.mjtLimited.mjLIMITED_TRUE, [-0.1, 0.1]
    tendon.stiffness, tendon.frictionloss, tendon.margin = [50.0, 0.0, 0.0], 1.0, 0.1


def test_added_plane_and_rotors_do_not_take_the_default_class_of_the_file(
    tmp_path: Path, files: dict[str, Path]
) -> None:
    paths = tmp_path / "ours.xml", write_mjcf(tmp_path / "defaults.xml", unusual_defaults)
    assert '<geom contype="0" conaffinity="0"' in paths[1].read_text()
    texts = files["ours"].read_text(), paths[1].read_text()
    for path, text in zip(paths, texts, strict=True):
        path.write_text(re.sub(r'<geom name="ground"[^>]*/>', "", text))
    settings = PlantSettings(physics_dt=0.001, sensors="ideal", backlash_deg=0.3)
    ours, theirs = (Plant("go1", settings, mjcf=path) for path in paths)
    assert np.allclose(ours.data.qpos, theirs.data.qpos, atol=1e-9)
    assert theirs.friction == 0.8
    assert theirs.truth.foot_forces[2].sum() == pytest.approx(9.81 * ours.robot.mass, rel=0.02)


@pytest.mark.parametrize(("friction", "dimension"), [("0.3 0.5 0 0 0", 3), ("0.8 0.8 0 0 0", 1)])
def test_friction_is_the_smaller_of_two_directions_and_zero_for_condim_1(
    tmp_path: Path, files: dict[str, Path], friction: str, dimension: int
) -> None:
    path = tmp_path / "robot.xml"
    pair = f'<pair geom1="FR_foot" geom2="ground" condim="{dimension}" friction="{friction}"/>'
    text = files["ours"].read_text()
    path.write_text(text.replace("</mujoco>", f"<contact>{pair}</contact></mujoco>"))
    assert Plant("go1", COARSE, mjcf=path).friction == (0.3 if dimension == 3 else 0.0)


def test_bodies_fixed_to_a_calf_may_touch_the_ground(
    tmp_path: Path, files: dict[str, Path]
) -> None:
    path = tmp_path / "robot.xml"
    root = ET.parse(files["ours"]).getroot()
    calf = root.find(".//body[@name='RL_calf']")
    assert calf is not None
    shin = '<body pos="0 0 -0.1"><geom name="shin" size="0.01" mass="0"/></body>'
    calf.append(ET.fromstring(shin))
    path.write_text(ET.tostring(root, encoding="unicode"))
    plant = Plant("go1", COARSE, mjcf=path)
    assert plant.model.geom("shin").id in plant.handles.calf_geoms


def test_foot_that_is_a_capsule_along_the_calf_stands_on_its_lower_end(
    tmp_path: Path, files: dict[str, Path]
) -> None:
    path = tmp_path / "robot.xml"
    text = re.sub(
        r'(<geom name="\w\w_foot") size="0.02"( pos="[^"]*")?',
        r'\1 type="capsule" size="0.02" fromto="0 0 0.1 0 0 0"',
        files["ours"].read_text(),
    )
    assert text.count("capsule") == 4
    path.write_text(text)
    plant, ours = Plant("go1", COARSE, mjcf=path), Plant("go1", COARSE, mjcf=files["ours"])
    assert np.allclose(plant.truth.p_world_feet, ours.truth.p_world_feet, atol=1e-3)
    assert plant.handles.foot_radius == 0.02


def test_feet_that_collide_by_contact_pairs_stand_with_the_friction_of_the_pairs(
    tmp_path: Path, files: dict[str, Path]
) -> None:
    path = tmp_path / "robot.xml"
    text = files["ours"].read_text()
    names = [f"foot {k}" for k in range(4)]
    for name, new in zip(("FR_foot", "FL_foot", "RR_foot", "RL_foot"), names, strict=True):
        old = f'<geom name="{name}"'
        text = text.replace(old, f'<geom name="{new}" contype="0" conaffinity="0"')
    pairs = "".join(
        f'<pair geom1="{new}" geom2="ground" condim="3" friction="0.3 0.3 0 0 0"/>' for new in names
    )
    path.write_text(text.replace("</mujoco>", f"<contact>{pairs}</contact></mujoco>"))
    plant = Plant("go1", COARSE, mjcf=path)
    assert plant.friction == 0.3
    assert plant.truth.foot_forces[2].sum() == pytest.approx(9.81 * plant.robot.mass, rel=0.02)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("friction", 0.5),
        ("slope_deg", 5.0),
        ("soft_ground_sink", 0.01),
        ("terrain", Terrain(step_height=0.05)),
        ("block_foot", "FR"),
        ("platform_heading_deg", 0.0),
    ],
)
def test_setting_that_the_file_replaces_is_refused(
    files: dict[str, Path], name: str, value: Any
) -> None:
    with pytest.raises(Error, match=f"^{name}: got .* with an MJCF.*change the file"):
        Plant("go1", PlantSettings(**{name: value}), mjcf=files["ours"])


def test_payload_backlash_and_scales_act_on_the_robot_of_the_file(files: dict[str, Path]) -> None:
    settings = PlantSettings(payload_kg=2.0, backlash_deg=0.3, armature_scale=2.0)
    plant, ours = Plant("go1", settings, mjcf=files["ours"]), Plant("go1", settings)
    assert plant.model.body_mass.sum() == pytest.approx(ours.model.body_mass.sum())
    assert np.allclose(
        plant.model.dof_armature[plant.handles.motor_v],
        ours.model.dof_armature[ours.handles.motor_v],
    )


def test_legs_of_another_robot_are_refused(tmp_path: Path) -> None:
    path = write_mjcf(tmp_path / "robot.xml", robot="b1")
    with pytest.raises(
        Error, match=r"thigh of leg FR of 'go1' is 0\.213 m long, in the file 0\.350 m"
    ):
        Plant("go1", mjcf=path)


def test_trunk_of_our_own_model_has_our_trunk_mass(files: dict[str, Path]) -> None:
    ours = describe_robot("go1")
    robot = build_robot(ours)
    theirs = trunk_mass(robot, ours.with_mjcf(files["ours"]))
    assert theirs == pytest.approx(trunk_mass(robot, ours))


def test_range_without_the_standing_pose_is_refused(tmp_path: Path, files: dict[str, Path]) -> None:
    path = tmp_path / "robot.xml"
    text = files["other initial pose"].read_text()
    path.write_text(re.sub(r'(name="RL_calf_joint" range=)"[^"]*"', r'\1"-0.2 0.5"', text))
    with pytest.raises(Error, match=r"joint 'RL_calf_joint': got range -0\.2 .. 0\.5 rad, .*-0\.4"):
        Plant("go1", mjcf=path)


def test_robot_walks_onto_an_obstacle_of_the_file(tmp_path: Path, files: dict[str, Path]) -> None:
    path = tmp_path / "robot.xml"
    box = '<geom name="step" type="box" size="0.5 1 0.02" pos="0.75 0 0.02"/></worldbody>'
    path.write_text(files["ours"].read_text().replace("</worldbody>", box))
    plant = Plant("go1", COARSE, mjcf=path)
    controller, state = surefoot.WalkController(plant.robot), plant.reset()
    for _ in range(1500):
        controller.set_velocity(surefoot.WalkVelocity(0.3, 0.0, 0.0))
        state = plant.step(controller.update(state))
    truth = plant.truth
    assert not truth.fell and truth.p_world_feet[2].max() > 0.055
    assert truth.foot_forces[2].sum() > 0.5 * 9.81 * plant.robot.mass


def test_simulation_that_diverges_counts_as_a_fall(files: dict[str, Path]) -> None:
    plant = Plant("go1", COARSE, mjcf=files["ours"])
    plant.data.qvel[:] = 1e12
    for _ in range(10):
        plant.step(surefoot.LowCmd())
    assert not np.isfinite(plant.data.qpos).all()
    assert plant.truth.fell


def test_live_tuning_simulates_the_robot_of_the_file(files: dict[str, Path]) -> None:
    simulation = Simulation(describe_robot("go1").with_mjcf(files["friction 0.4"]))
    assert simulation.plant.friction == 0.4
    for _ in range(20):
        simulation.tick()
    assert simulation.healthy


def test_stand_prints_the_mapping_and_names_the_file_in_its_summary(
    files: dict[str, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    mjcf = str(files["friction 0.4"])
    assert main(["stand", "--mjcf", mjcf, "--duration", "0.5", "--json", "-"]) == 0
    printed = capsys.readouterr()
    summary = json.loads(printed.out)
    assert summary["mjcf"] == mjcf and summary["friction"] == 0.4
    assert "FR_hip_joint" in printed.err and "actuators are off" in printed.err


@pytest.mark.slow
@pytest.mark.parametrize("walk", [False, True])
def test_scorecard_has_a_section_for_the_foreign_plant(
    tmp_path: Path, files: dict[str, Path], walk: bool
) -> None:
    card, out = tmp_path / "tiny.toml", tmp_path / "card.json"
    stand_card = 'directions = 1\nseeds = 1\ncondition_seeds = 1\nfaults = "none"\n'
    walk_card = "velocities = [[0.3, 0.0, 0.0]]\nwalk_s = 2.0\nseeds = 1\npush_velocities = []\n"
    card.write_text(walk_card + "condition_seeds = 0\n" if walk else stand_card)
    mjcf = files["friction 0.4"]
    options = ["--scenario", str(card), "--jobs", "1", "--json", str(out), "--mjcf", str(mjcf)]
    assert main(["assess", "--robot", "go1", *options, *(["--walk"] if walk else [])]) == 0
    result = json.loads(out.read_text())
    section = result["foreign_plant"]
    assert section["mjcf"] == str(mjcf) and section["friction"] == 0.4
    if walk:
        assert section["walk"]["velocities"][0]["walked"] == 1
        return
    foreign = section["push"]["tables"][0]["directions"][0]
    ours = result["push"]["tables"][0]["directions"][0]
    assert foreign["limit_ns"] < 0.9 * ours["limit_ns"]  # friction 0.4 lowers the limit
    assert foreign["lip_ns"] == pytest.approx(ours["lip_ns"])
    assert section["stand"]["passed"] == 1
