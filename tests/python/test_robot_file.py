# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
import surefoot
from surefoot import Error, Robot

CONFIG = [name for name in vars(surefoot.RobotConfig) if not name.startswith("_")]
CONFIG = [name for name in CONFIG if name not in ("validate", "gains")]
LOAD_WITHOUT_DEPENDENCIES = """
import sys, importlib.metadata
class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in ("pinocchio", "mujoco", "casadi", "example_robot_data", "cmeel"):
            raise ImportError(name + " is not installed")
sys.meta_path.insert(0, Absent())
def files(name): raise importlib.metadata.PackageNotFoundError(name)
importlib.metadata.files = importlib.metadata.distribution = files
import surefoot
robot = surefoot.Robot.load(sys.argv[1])
surefoot.StandController(robot).update(surefoot.LowState())
assert robot.name == "go1"
"""


@pytest.fixture
def path(go1, tmp_path) -> Path:
    path = tmp_path / "go1.robot"
    go1.robot.save(str(path))
    return path


def with_checksum(content: bytes) -> bytes:
    """Return the content with its checksum line recomputed."""
    body = content[: content.rindex(b"\nchecksum ")]
    return body + b"\nchecksum %d\n" % zlib.crc32(body)


def test_saved_robot_loads_unchanged(body, tmp_path) -> None:
    path = str(tmp_path / "any name.robot")
    body.robot.save(path)
    twin = Robot.load(path)
    assert twin.serialized_model() == body.robot.serialized_model()
    assert twin.config.gains == body.robot.config.gains
    for field in CONFIG:
        ours, theirs = getattr(body.robot.config, field), getattr(twin.config, field)
        np.testing.assert_array_equal(theirs, ours, err_msg=field)
    assert list(twin.motor_to_v) == list(body.robot.motor_to_v)
    assert list(twin.foot_frame_ids) == list(body.robot.foot_frame_ids)


def test_changed_configuration_is_saved(go1, tmp_path) -> None:
    gains = surefoot.Gains()
    for k, info in enumerate(surefoot.gain_table()):
        share = (100 - k) / 100.0  # decreasing: keeps contact_force_off below contact_force_on
        setattr(gains, info.name, (1 - share) * info.default + share * info.maximum)
    quat = np.array([0.1, 0.2, 0.3, 0.4]) / np.linalg.norm([0.1, 0.2, 0.3, 0.4])
    changes = {"name": "rex", "friction": 1 / 3, "quat_base_imu": quat, "p_base_imu": quat[1:]}
    changes["hip_inward"] = 0.7
    robot = go1.with_config(gains=gains, **changes).robot
    robot.save(str(tmp_path / "rex.robot"))
    twin = Robot.load(str(tmp_path / "rex.robot")).config
    assert twin.gains == gains != go1.robot.config.gains
    for field, value in changes.items():
        np.testing.assert_array_equal(getattr(twin, field), value)


def test_loaded_robot_gives_the_same_torques(body, tmp_path) -> None:
    path = str(tmp_path / "x.robot")
    body.robot.save(path)
    state = body.random_state(seed=5)
    reference = body.reference_at(state)
    ours, theirs = (
        surefoot.WholeBodyController(robot).update(state, reference)
        for robot in (body.robot, Robot.load(path))
    )
    np.testing.assert_array_equal(theirs.torques, ours.torques)


def test_saving_twice_gives_the_same_file(go1, path: Path, tmp_path) -> None:
    again = tmp_path / "again.robot"
    Robot.load(str(path)).save(str(again))
    assert again.read_bytes() == path.read_bytes()


@pytest.mark.parametrize("version", [0, 2, 10, -1])
def test_robot_file_version_error_names_both_versions(path: Path, version: int) -> None:
    content = path.read_bytes().replace(b"surefoot-robot 1\n", b"surefoot-robot %d\n" % version, 1)
    path.write_bytes(with_checksum(content))
    with pytest.raises(Error, match=rf"go1.robot': got version {version}, expected version 1"):
        Robot.load(str(path))


def test_corrupt_byte_is_detected(path: Path) -> None:
    good = path.read_bytes()
    rng = np.random.default_rng(11)
    places = [*rng.integers(0, len(good), 60), 3, 15, 16, len(good) - 4, len(good) - 1]
    for place in places:
        damaged = bytearray(good)
        damaged[place] ^= 1 << int(rng.integers(8))
        path.write_bytes(damaged)
        with pytest.raises(Error, match=r"go1\.robot"):
            Robot.load(str(path))


@pytest.mark.parametrize("share", [0.0, 0.0005, 0.01, 0.5, 0.999, 0.9999])
def test_truncated_robot_file_is_refused(path: Path, share: float) -> None:
    good = path.read_bytes()
    path.write_bytes(good[: int(share * len(good))])
    with pytest.raises(Error, match=r"go1\.robot': (not a robot file|the end is|the checksum)"):
        Robot.load(str(path))


@pytest.mark.parametrize("content", [b"", b"<robot name='go1'/>", b"\x7fELF" + bytes(500)])
def test_file_of_another_kind_is_refused(path: Path, content: bytes) -> None:
    path.write_bytes(content)
    with pytest.raises(Error, match=r"not a robot file; expected .*'surefoot export'"):
        Robot.load(str(path))


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (b"\nfriction ", b"\nfrction ", "got field 'frction', expected 'friction'"),
        (b"\nfriction 0.", b"\nfriction x0.", "field 'friction' cannot be read"),
        (b"\nfriction 0.", b"\nfriction -0.", "friction: got -0."),
        (b"\ngain.foot_kp ", b"\ngain.foot_kp -", "'foot_kp' out of range: got -"),
        (b"\nfoot_frames FR_foot ", b"\nfoot_frames FR_fot ", "foot frame 'FR_fot'"),
        (b"serialization::archive", b"serialisation::archive", "same Pinocchio version"),
    ],
)
def test_robot_file_with_valid_checksum_is_still_validated(path: Path, old, new, words) -> None:
    good = path.read_bytes()
    assert old in good
    path.write_bytes(with_checksum(good.replace(old, new, 1)))
    with pytest.raises(Error) as caught:
        Robot.load(str(path))
    assert words in str(caught.value)


def test_unreadable_or_unwritable_file_is_named(go1, tmp_path) -> None:
    with pytest.raises(Error, match=r"'/no/such.robot': cannot be opened"):
        Robot.load("/no/such.robot")
    with pytest.raises(Error, match=r"'/no/such/go1.robot': cannot be written"):
        go1.robot.save("/no/such/go1.robot")
    with pytest.raises(Error, match="robot file"):
        Robot.load(str(tmp_path))


def test_robot_file_loads_without_pinocchio_mujoco_or_robot_data(path: Path) -> None:
    run = subprocess.run(
        [sys.executable, "-c", LOAD_WITHOUT_DEPENDENCIES, str(path)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.stderr == ""
    assert run.returncode == 0


def test_saved_model_includes_rotor_armature(path: Path) -> None:
    robot, model = Robot.load(str(path)), pin.Model()
    model.loadFromString(robot.serialized_model())
    np.testing.assert_array_equal(model.armature[list(robot.motor_to_v)], robot.config.armature)
    assert robot.config.armature.min() > 0.0
