# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
import surefoot
from surefoot.robot.loading import describe_robot, load_pinocchio_model

ROBOTS = ["a1", "go1", "go2", "b1"]
LEGS = ("FR", "FL", "RR", "RL")
# The narrower of the SDK's and the URDF's position limits [rad]: hip, thigh, calf of FR.
LIMITS = {
    "a1": ([-0.802, -1.0472, -2.6965], [0.802, 4.1888, -0.9163]),
    "go1": ([-0.863, -0.663, -2.721], [0.863, 2.966, -0.888]),
    "go2": ([-1.0472, -1.5708, -2.7227], [1.0472, 3.4907, -0.83776]),
    "b1": ([-0.75, -1.0, -2.6], [0.75, 3.5, -0.6]),
}
MASS = {"a1": 13.741, "go1": 13.1005, "go2": 16.085, "b1": 55.689}
ARMATURE = {
    "a1": [0.01, 0.01, 0.01],
    "go1": [0.00403, 0.00403, 0.00906],
    "go2": [0.00448, 0.00448, 0.01646],
    "b1": [0.0251, 0.0588, 0.1323],
}
FRICTION = {"a1": 0.6548, "go1": 0.65, "go2": 0.64, "b1": 0.713}
IMU_MOUNT = {
    "a1": [0.0, 0.0, 0.0],
    "go1": [-0.01592, -0.06659, -0.00617],
    "go2": [-0.02557, 0.0, 0.04232],
    "b1": [0.0, 0.0, 0.0],
}


@pytest.fixture
def toml() -> str:
    return (Path(surefoot.__file__).parent / "models" / "go1.toml").read_text()


@pytest.fixture
def load(tmp_path):
    """Return a function that loads go1's URDF with a given configuration."""

    def load(text: str | bytes, urdf=None) -> surefoot.Robot:
        path = tmp_path / "mine.toml"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return surefoot.load_robot(urdf=urdf or describe_robot("go1").urdf, config=path)

    return load


def changed(text: str, old: str, new: str) -> str:
    assert text.count(old) == 1
    return text.replace(old, new)


def without(text: str, key: str) -> str:
    """Return the TOML text without one key, whose value may span several lines."""
    line = re.compile(rf"^{key} = (\[[^\]]*\]|[^\n]*)", re.MULTILINE)
    assert len(line.findall(text)) == 1
    return line.sub("", text)


def test_the_four_robots_are_known_by_name() -> None:
    assert sorted(surefoot.available_robots()) == sorted(ROBOTS)


@pytest.mark.parametrize("name", ROBOTS)
def test_robot_loaded_by_name_has_the_urdf_mass(name: str) -> None:
    robot = surefoot.load_robot(name)
    assert (robot.name, robot.nq, robot.nv) == (name, 19, 18)
    assert robot.mass == pytest.approx(MASS[name], abs=1e-3)


def test_every_motor_maps_to_the_joint_of_its_name(body) -> None:
    names = [f"{leg}_{kind}_joint" for leg in LEGS for kind in ("hip", "thigh", "calf")]
    joints = [body.model.joints[body.model.getJointId(name)] for name in names]
    assert list(body.robot.config.joint_names) == names
    assert list(body.robot.motor_to_v) == [joint.idx_v for joint in joints]
    assert list(body.robot.motor_to_q) == [joint.idx_q for joint in joints]


def test_every_foot_maps_to_the_frame_of_its_name(body) -> None:
    frames = [body.model.frames[i].name for i in body.robot.foot_frame_ids]
    assert frames == [f"{leg}_foot" for leg in LEGS]


@pytest.mark.parametrize("name", ROBOTS)
def test_position_limits_are_the_narrower_of_sdk_and_urdf(name: str) -> None:
    config = surefoot.load_robot(name).config
    lower, upper = LIMITS[name]
    np.testing.assert_allclose(config.q_lower[:3], lower, atol=1e-4)
    np.testing.assert_allclose(config.q_upper[:3], upper, atol=1e-4)


def test_position_limits_are_within_the_urdf_and_contain_the_pose(body) -> None:
    config, model = body.robot.config, body.model
    q = np.array(body.robot.motor_to_q)
    assert (config.q_lower >= model.lowerPositionLimit[q]).all()
    assert (config.q_upper <= model.upperPositionLimit[q]).all()
    assert (config.q_lower < config.q_standing).all()
    assert (config.q_standing < config.q_upper).all()


def test_motion_range_is_limited_by_hip_inward(go1) -> None:
    config = go1.robot.config
    config.hip_inward = 0.4
    lower, upper = config.q_lower, config.q_upper
    upper[[0, 6]], lower[[3, 9]] = 0.4, -0.4  # positive angles move right legs under the trunk
    ranges = [surefoot.motion_range(config, motor) for motor in range(12)]
    assert ranges == list(zip(lower, upper, strict=True))
    assert surefoot.load_robot("b1").config.hip_inward == 0.4
    with pytest.raises(surefoot.Error, match=r"got motor 12, expected 0 \.\. 11"):
        surefoot.motion_range(config, 12)


def test_a_standing_pose_beyond_hip_inward_is_refused(load, toml: str) -> None:
    pose = changed(toml, "[0.0, 0.8, -1.6]", "[-0.3, 0.8, -1.6]")
    with pytest.raises(
        surefoot.Error, match=r"hip_inward: got 0\.2.*least 0\.3, the angle of FL_hip"
    ):
        load(changed(pose, "[limits]", "[limits]\nhip_inward = 0.2"))


def test_the_standing_pose_is_level_with_bent_knees(body) -> None:
    np.testing.assert_array_equal(body.robot.config.q_standing, [0.0, 0.8, -1.6] * 4)
    q = body.robot.q_standing()
    np.testing.assert_array_equal(q[:7], [0, 0, 0, 0, 0, 0, 1])
    np.testing.assert_array_equal(q[list(body.robot.motor_to_q)], [0.0, 0.8, -1.6] * 4)
    heights = body.contact_points(q)[:, 2]
    assert np.ptp(heights) < 1e-3


def test_motor_torque_and_speed_match_the_urdf(body) -> None:
    config, model = body.robot.config, body.model
    v = np.array(body.robot.motor_to_v)
    np.testing.assert_array_equal(config.tau_max, model.effortLimit[v])
    np.testing.assert_array_equal(config.no_load_speed, model.velocityLimit[v])
    np.testing.assert_allclose(config.corner_speed, 0.5 * config.no_load_speed)


@pytest.mark.parametrize("name", ROBOTS)
def test_armature_adds_to_the_diagonal_of_the_mass_matrix(name: str) -> None:
    robot, bare = surefoot.load_robot(name), load_pinocchio_model(describe_robot(name))
    model = pin.Model()
    model.loadFromString(robot.serialized_model())
    q = robot.q_standing()
    with_it, without_it = (np.triu(pin.crba(m, m.createData(), q)) for m in (model, bare))
    expected = np.zeros(robot.nv)
    expected[list(robot.motor_to_v)] = ARMATURE[name] * 4
    np.testing.assert_allclose(with_it - without_it, np.diag(expected), atol=1e-12)
    np.testing.assert_allclose(robot.config.armature, ARMATURE[name] * 4)


@pytest.mark.parametrize("name", ROBOTS)
def test_imu_mount_matches_the_urdf(name: str) -> None:
    config = surefoot.load_robot(name).config
    np.testing.assert_allclose(config.p_base_imu, IMU_MOUNT[name], atol=1e-6)
    np.testing.assert_allclose(config.quat_base_imu, [1.0, 0.0, 0.0, 0.0], atol=1e-6)
    assert config.friction == FRICTION[name]


def test_motor_torque_falls_linearly_with_speed_only_while_driving(go1) -> None:
    config, limit = go1.robot.config, surefoot.motor_torque_limit
    corner, top, tau = config.corner_speed[2], config.no_load_speed[2], config.tau_max[2]
    for sign in (-1.0, 1.0):
        assert limit(config, 2, sign * 0.99 * corner, sign) == tau
        assert limit(config, 2, sign * 0.5 * (corner + top), sign) == pytest.approx(0.5 * tau)
        assert limit(config, 2, sign * 1.5 * top, sign) == 0.0
        assert limit(config, 2, -sign * 1.5 * top, sign) == tau


def with_gain(toml: str, line: str) -> str:
    """Return a TOML with one gain replaced; [gains] must be its last table."""
    name = line.partition(" =")[0]
    rest = [old for old in toml.splitlines() if not old.startswith(f"{name} =")]
    return "\n".join([*rest, line, ""])


def test_user_robot_is_loaded_from_urdf_and_toml(load, toml: str) -> None:
    text = changed(toml, 'name = "go1"', 'name = "rex"')
    text = changed(text, 'frame = "imu_link"', "position = [0.1, 0, 0]\nquaternion = [0, 0, 0, 1]")
    text = changed(text, "friction = 0.65 ", "friction = 0.4 ")
    robot = load(with_gain(text, "com_kp_vertical = 99"))
    assert (robot.name, robot.config.friction) == ("rex", 0.4)
    np.testing.assert_array_equal(robot.config.p_base_imu, [0.1, 0.0, 0.0])
    np.testing.assert_array_equal(robot.config.quat_base_imu, [0.0, 0.0, 0.0, 1.0])
    assert robot.config.gains.com_kp_vertical == 99.0
    assert robot.mass == surefoot.load_robot("go1").mass


def test_twelve_standing_angles_are_read_per_motor(load, toml: str) -> None:
    values = [0.01 * (k - 6) for k in range(12)]
    values[1::3], values[2::3] = [0.7] * 4, [-1.5, -1.4, -1.3, -1.2]
    robot = load(changed(toml, "standing = [0.0, 0.8, -1.6]", f"standing = {values}"))
    np.testing.assert_array_equal(robot.config.q_standing, values)


def test_robot_config_is_returned_as_a_copy(go1) -> None:
    config = go1.robot.config
    config.friction = 1.1
    config.gains.foot_kp = 1.0
    assert go1.robot.config.friction == 0.65
    assert go1.robot.config.gains.foot_kp != 1.0


def test_an_unknown_robot_is_refused_with_the_valid_names() -> None:
    with pytest.raises(surefoot.Error, match=r"unknown robot: got 'go7'.*a1, b1, go1, go2"):
        surefoot.load_robot("go7")


@pytest.mark.parametrize(
    "arguments", [{}, {"urdf": "a.urdf"}, {"config": "a.toml"}], ids=["none", "urdf", "config"]
)
def test_incomplete_description_is_refused(arguments) -> None:
    with pytest.raises(surefoot.Error, match="urdf= and config="):
        surefoot.load_robot(**arguments)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"FR_hip_joint"', '"FR_hap_joint"', ["missing joint 'FR_hap_joint'", "'FR_hip_joint'"]),
        ('"FR_hip_joint"', '"FR_calf_joint"', ["'FR_calf_joint' twice", "12 different names"]),
        ('"RL_foot"', '"RL_fot"', ["missing foot frame 'RL_fot'", "mean 'RL_foot'", "universe"]),
        ('"FR_foot", "FL_foot"', '"FL_foot", "FR_foot"', ["FL_calf_joint", "FR_calf_joint"]),
        ('frame = "imu_link"', 'frame = "imu_lnk"', ["IMU frame 'imu_lnk'", "mean 'imu_link'"]),
        ('frame = "imu_link"', 'frame = "FR_foot"', ["FR_calf_joint", "expected the base"]),
        ('frame = "imu_link"', "quaternion = [1, 1, 0, 0]", ["IMU quaternion norm: got 1.4"]),
        ('frame = "imu_link"', "position = [0, 0]", ["imu.position: got [0, 0], expected 3"]),
        ("friction = 0.65 ", "frction = 0.65 ", ["robot.frction", "mean 'friction'", "valid keys"]),
        ("[motors]", "[motrs]", ["section [motrs]", "mean 'motors'", "valid sections"]),
        ("friction = 0.65 ", "friction = -0.5 ", ["friction: got -0.5", "expected 0 < friction"]),
        ("radius = 0.02 ", "radius = nan ", ["foot radius: got nan"]),
        ("[0.0, 0.8, -1.6]", "[0.0, 0.8, -0.6]", ["standing pose of FR_calf_joint", "-2.7"]),
        ("[0.0, 0.8, -1.6]", "[0.9, 0.8, -1.6]", ["standing pose of FR_hip_joint: got 0.9"]),
        ("[0.0, 0.8, -1.6]", "[-0.9, 0.8, -1.6]", ["standing pose of FR_hip_joint: got -0.9"]),
        ("[0.0, 0.8, -1.6]", "[nan, 0.8, -1.6]", ["standing pose of FR_hip_joint: got nan"]),
        ("[0.0, 0.8, -1.6]", "[0.0, 0.8]", ["robot.standing: got [0.0, 0.8], expected 3 numbers"]),
        ("hip = [-1.047, 1.047]", "hip = [1.0, -1.0]", ["limits of FR_hip_joint", "lower < upper"]),
        ("hip = [-1.047, 1.047]", "hp = [-1.0, 1.0]", ["limits.hp", "mean 'hip'"]),
        ("[limits]", "[limits]\nhip_inward = 0.0", ["hip_inward: got 0", "a number > 0, in rad"]),
        ("[limits]", "[limits]\nhip_inward = nan", ["hip_inward: got nan", "a number > 0"]),
        ("[limits]", "[limits]\nhip_inward = -0.4", ["hip_inward: got -0.4", "a number > 0"]),
        ("[limits]", "[limits]\nhip_inward = [1]", ["limits.hip_inward: got [1]", "in rad"]),
        ("armature = [0.00403,", "armature = [-0.004,", ["armature of FR_hip_joint: got -0.004"]),
        ("corner_fraction = 0.5", "corner_fraction = 1.5", ["corner_speed", "no_load_speed"]),
        ("corner_fraction = 0.5", "corner_fraction = nan", ["corner_speed", "got nan"]),
    ],
)
def test_invalid_configuration_error_names_value_and_expectation(
    load, toml, old, new, words
) -> None:
    with pytest.raises(surefoot.Error) as caught:
        load(changed(toml, old, new))
    assert [word for word in words if word not in str(caught.value)] == []


@pytest.mark.parametrize("key", ["name", "joints", "standing", "frames", "radius", "armature"])
def test_missing_key_is_named(load, toml: str, key: str) -> None:
    with pytest.raises(surefoot.Error, match=rf"missing key '\w+\.{key}'"):
        load(without(toml, key))


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("com_kp_vertical = -1.0", "'com_kp_vertical' out of range: got -1, expected 0 .. 2000"),
        ("com_kp_vertical = nan", "'com_kp_vertical' out of range: got nan"),
        ("com_kp_vertical = inf", "'com_kp_vertical' out of range: got inf"),
        ('com_kp_vertical = "high"', "'com_kp_vertical': got 'high', expected a number"),
        ("com_kp_vertical = true", "'com_kp_vertical': got True, expected a number"),
        ("com_kp_vertical = [1.0]", "expected a number"),
        ("com_kp_vertcal = 1.0", "'com_kp_vertcal' (did you mean 'com_kp_vertical'?)"),
        ("contact_force_off = 0.4", "'contact_force_off' must be below 'contact_force_on'"),
    ],
)
def test_a_bad_gain_in_the_toml_is_named(load, toml: str, line: str, words: str) -> None:
    with pytest.raises(surefoot.Error) as caught:
        load(with_gain(toml, line))
    assert words in str(caught.value)


@pytest.mark.parametrize(
    ("section", "key", "value"),
    [
        ("robot", "name", "3"),
        ("robot", "joints", "12"),
        ("robot", "joints", "[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]"),
        ("robot", "standing", "0.8"),
        ("robot", "standing", '"low"'),
        ("robot", "standing", '["a", "b", "c"]'),
        ("robot", "friction", '"grippy"'),
        ("feet", "radius", '"small"'),
        ("feet", "frames", "4"),
        ("imu", "frame", "7"),
        ("limits", "hip", "1.0"),
        ("limits", "hip", "[1.0]"),
        ("limits", "hip", '["a", "b"]'),
        ("motors", "armature", "0.01"),
        ("motors", "corner_fraction", '"half"'),
    ],
)
def test_value_of_the_wrong_type_error_names_its_key(load, toml, section, key, value) -> None:
    text = changed(without(toml, key), f"[{section}]", f"[{section}]\n{key} = {value}")
    with pytest.raises(surefoot.Error, match=key):
        load(text)


@pytest.mark.parametrize("section", ["robot", "feet", "imu", "limits", "motors", "gains"])
def test_section_that_is_no_table_is_named(load, toml: str, section: str) -> None:
    table = re.compile(rf"^\[{section}\].*?(?=^\[|\Z)", re.MULTILINE | re.DOTALL)
    with pytest.raises(surefoot.Error, match=section):
        load(f"{section} = 3\n" + table.sub("", toml))


@pytest.mark.parametrize("text", [b"[robot\n", b"\xff\xfe\x00", b"name: go1"])
def test_a_file_that_is_not_toml_is_named(load, text: bytes) -> None:
    with pytest.raises(surefoot.Error, match=r"mine.toml' is not valid TOML"):
        load(text)


def test_a_missing_file_is_named(load, toml: str, tmp_path) -> None:
    with pytest.raises(surefoot.Error, match=r"URDF not found: got '/no/such.urdf'"):
        load(toml, urdf="/no/such.urdf")
    with pytest.raises(surefoot.Error, match=r"cannot read '.*absent.toml'"):
        surefoot.load_robot(urdf=describe_robot("go1").urdf, config=tmp_path / "absent.toml")


def test_a_urdf_that_cannot_be_parsed_is_named(load, toml: str, tmp_path) -> None:
    path = tmp_path / "broken.urdf"
    path.write_text("<robot")
    with pytest.raises(surefoot.Error, match=r"broken\.urdf"):
        load(toml, urdf=path)


def test_a_model_fixed_to_the_world_is_refused(go1) -> None:
    fixed = pin.buildModelFromUrdf(str(describe_robot("go1").urdf))
    with pytest.raises(surefoot.Error, match="expected a free-flyer"):
        surefoot.Robot.from_serialized_model(fixed.saveToString(), go1.robot.config)


@pytest.mark.parametrize("share", [0.0, 0.01, 0.5])
def test_truncated_model_text_is_refused(go1, share: float) -> None:
    text = go1.robot.serialized_model()
    with pytest.raises(surefoot.Error, match="serialised model cannot be read"):
        surefoot.Robot.from_serialized_model(text[: int(share * len(text))], go1.robot.config)
