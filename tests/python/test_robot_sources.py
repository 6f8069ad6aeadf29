"""Sources of a robot: a name, a URDF or a Pinocchio model; exactly one of them."""

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
import surefoot
from surefoot import Error
from surefoot.robot.loading import describe_robot, load_pinocchio_model

MODELS = Path(surefoot.__file__).parent / "models"


@pytest.fixture
def model():
    return load_pinocchio_model(describe_robot("go1"))


@pytest.fixture
def config(tmp_path):
    """Return a function that writes a changed copy of go1's TOML and returns its path."""

    def write(old: str = "", new: str = "") -> Path:
        text = (MODELS / "go1.toml").read_text()
        assert old in text
        (tmp_path / "my.toml").write_text(text.replace(old, new) if old else text)
        return tmp_path / "my.toml"

    return write


@pytest.mark.parametrize("name", ["a1", "go1", "go2", "b1"])
def test_robot_from_a_model_equals_the_robot_from_its_urdf(name):
    model = load_pinocchio_model(describe_robot(name))
    ours = surefoot.load_robot(model=model, config=str(MODELS / f"{name}.toml"))
    theirs = surefoot.load_robot(name)
    assert ours.serialized_model() == theirs.serialized_model()
    assert ours.config.gains == theirs.config.gains
    for field in (
        "q_lower",
        "q_upper",
        "hip_inward",
        "tau_max",
        "p_base_imu",
        "quat_base_imu",
        "armature",
    ):
        np.testing.assert_array_equal(getattr(ours.config, field), getattr(theirs.config, field))


def test_modified_pinocchio_model_is_used(model, config):
    model.inertias[1].mass += 2.0
    robot = surefoot.load_robot(model=model, config=config())
    assert robot.mass == pytest.approx(surefoot.load_robot("go1").mass + 2.0)
    surefoot.StandController(robot).update(surefoot.LowState())


def test_given_model_is_not_modified(model, config):
    before = model.saveToString()
    surefoot.load_robot(model=model, config=config())
    assert model.saveToString() == before


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"FR_calf_joint"', '"FR_claf_joint"', ["'FR_claf_joint' (motor 2)", "'FR_calf_joint'"]),
        ('"RL_foot"', '"RL_fot"', ["missing foot frame 'RL_fot'", "mean 'RL_foot'"]),
        ('frame = "imu_link"', 'frame = "imu_lnk"', ["IMU frame 'imu_lnk'", "mean 'imu_link'"]),
        ("friction = 0.65 ", "frction = 0.65 ", ["robot.frction", "mean 'friction'", "valid keys"]),
    ],
)
def test_unknown_name_in_model_or_toml_is_named(model, config, old, new, words):
    with pytest.raises(Error) as caught:
        surefoot.load_robot(model=model, config=config(old, new))
    assert [word for word in words if word not in str(caught.value)] == []


def test_model_without_a_free_base_is_refused(config):
    fixed = pin.buildModelFromUrdf(str(describe_robot("go1").urdf))
    with pytest.raises(Error, match=r"got '\w+' \(JointModelR\w+\), expected a free-flyer"):
        surefoot.load_robot(model=fixed, config=config())
    with pytest.raises(Error, match="got no joint, expected a free-flyer"):
        surefoot.load_robot(model=pin.Model(), config=config())


@pytest.mark.parametrize("model", ["go1.urdf", 3, pin.GeometryModel()])
def test_non_model_input_error_names_its_type(model, config):
    with pytest.raises(Error, match=f"got {type(model).__name__}, expected a pinocchio.Model"):
        surefoot.load_robot(model=model, config=config())


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({}, "got nothing"),
        ({"name": "go1", "urdf": "a"}, "got a name and urdf="),
        ({"name": "go1", "config": "b"}, "got a name and config="),
        ({"name": "go1", "model": 1}, "got a name and model="),
        ({"urdf": "a", "model": 1, "config": "b"}, "got urdf= and model= and config="),
        ({"urdf": "a"}, "got urdf=,"),
        ({"model": 1}, "got model=,"),
        ({"config": "b"}, "got config=,"),
    ],
)
def test_conflicting_or_incomplete_sources_are_refused(given, words):
    with pytest.raises(Error, match="expected a name, or urdf= and config=, or model=") as caught:
        surefoot.load_robot(**given)
    assert words in str(caught.value)


def test_description_from_name_and_files_is_refused():
    with pytest.raises(Error, match="got name 'go1' and files"):
        describe_robot("go1", config="b.toml")
