# SPDX-License-Identifier: BSD-3-Clause
"""Plain values: copy, deepcopy, pickle, ==, repr() and the errors of their fields."""

from __future__ import annotations

import copy
import enum
import math
import pickle
import re
from typing import Any

import numpy as np
import pytest
import surefoot
from surefoot import protocol

# Every class whose fields can be assigned, found by its properties.
VALUES = [
    kind
    for kind in vars(surefoot._core).values()
    if isinstance(kind, type)
    # Their settable gait is no value of a copy.
    and not issubclass(kind, (surefoot.Controller, surefoot.Supervisor))
    and any(isinstance(p, property) and p.fset for p in vars(kind).values())
]
RESULTS = ["ArmingCheck", "ArmingReport", "FaultReport", "EstimatorReport", "Solution"]
RESULTS += ["LinkCounts", "ReachStatus"]
COPIES = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    **{f"pickle {p}": lambda x, p=p: pickle.loads(pickle.dumps(x, p)) for p in (2, 3, 4, 5)},
}


def fields(kind: type) -> list[str]:
    return [name for name, p in vars(kind).items() if isinstance(p, property) and p.fset]


def changed(value: Any, rng: np.random.Generator) -> Any:
    """Return another value of the same kind."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, enum.Enum):
        members = list(type(value))
        return members[(members.index(value) + 1) % len(members)]
    if isinstance(value, int):
        return int(rng.integers(1, 100))
    if isinstance(value, float):
        return float(rng.normal())
    if isinstance(value, str):
        return value + "x"
    if isinstance(value, list):
        return [changed(element, rng) for element in value]
    if isinstance(value, np.ndarray):
        random = rng.integers(1, 100, value.shape or (4,)) + (
            0.25 if value.dtype.kind == "f" else 0
        )
        return random.astype(value.dtype)
    return filled(type(value), rng)


def filled(kind: type, rng: np.random.Generator) -> Any:
    """Return a value of which every field differs from its default."""
    value = kind()
    for name in fields(kind):
        if name == "quat_world_base":
            numbers = rng.normal(size=4)
            value.quat_world_base = numbers / np.linalg.norm(numbers)
        else:
            setattr(value, name, changed(getattr(value, name), rng))
    if kind is surefoot.Reference:
        value.posture = rng.normal(size=12)
        for leg in range(4):
            foot = value.foot(leg)
            foot.p_world, foot.load, foot.stance = rng.normal(size=3), float(leg) / 4, leg > 1
    if kind in (surefoot.LowState, surefoot.LowCmd):
        value.raw[:] = rng.integers(0, 256, value.raw.shape)
    return value


def assert_same_fields(a: Any, b: Any) -> None:
    for name in fields(type(a)):
        np.testing.assert_equal(getattr(a, name), getattr(b, name))


def test_the_classes_of_messages_states_gains_and_options_are_found() -> None:
    names = {kind.__name__ for kind in VALUES}
    assert {"Gains", "LowState", "LowCmd", "IMU", "MotorState", "MotorCmd", "BmsState"} <= names
    assert {"RobotState", "Reference", "FootReference", "BodyReference", "RobotConfig"} <= names
    assert {"ControllerOptions", "SupervisorOptions", "RunOptions", "WholeBodyOptions"} <= names


@pytest.mark.parametrize("duplicate", COPIES.values(), ids=COPIES)
@pytest.mark.parametrize("kind", VALUES)
def test_a_copy_equals_its_original_and_is_independent(kind, duplicate) -> None:
    value = filled(kind, np.random.default_rng(1))
    twin = duplicate(value)
    assert type(twin) is kind and twin is not value
    assert twin == value and not twin != value
    assert_same_fields(twin, value)
    before = repr(value)
    for name in fields(kind):
        if name != "quat_world_base":
            setattr(twin, name, changed(getattr(twin, name), np.random.default_rng(2)))
            assert twin != value
    assert repr(value) == before


@pytest.mark.parametrize("kind", VALUES)
def test_a_change_of_any_field_makes_values_unequal(kind) -> None:
    rng = np.random.default_rng(3)
    value = filled(kind, rng)
    for name in fields(kind):
        twin = copy.copy(value)
        if name == "quat_world_base":
            twin.quat_world_base = [0.0, 0.0, 0.0, 1.0]
        else:
            setattr(twin, name, changed(getattr(twin, name), np.random.default_rng(4)))
        assert twin != value, name
    assert value != kind.__name__ and value is not None


@pytest.mark.parametrize("kind", VALUES)
def test_mutable_values_have_no_hash(kind) -> None:
    with pytest.raises(TypeError, match="unhashable"):
        hash(kind())


@pytest.mark.parametrize("kind", VALUES)
def test_repr_names_the_class_and_its_fields(kind) -> None:
    text = repr(filled(kind, np.random.default_rng(5)))
    assert text.startswith(f"{kind.__name__}(") and text.endswith(")")
    assert all(f"{name}=" in text for name in fields(kind))


def test_a_nested_value_is_copied_with_its_owner() -> None:
    options = surefoot.SupervisorOptions(stand=surefoot.ControllerOptions(delay=0.01))
    twin = copy.copy(options)
    twin.stand.delay = 0.02
    assert (options.stand.delay, twin.stand.delay) == (0.01, 0.02)
    reference = surefoot.Reference()
    reference.foot(2).p_world = [1, 2, 3]
    twin = pickle.loads(pickle.dumps(reference))
    twin.foot(2).p_world[0] = 7.0
    np.testing.assert_array_equal(reference.foot(2).p_world, [1, 2, 3])
    np.testing.assert_array_equal(twin.foot(2).p_world, [7, 2, 3])


def test_a_state_of_another_robot_keeps_its_sizes() -> None:
    state = surefoot.RobotState(21, 20)
    twin = pickle.loads(pickle.dumps(state))
    assert (len(twin.q), len(twin.v)) == (21, 20) and twin == state
    assert state != surefoot.RobotState()


@pytest.mark.parametrize("duplicate", COPIES.values(), ids=COPIES)
def test_nan_survives_and_a_copy_with_nan_equals_its_original(duplicate) -> None:
    state, gains = surefoot.RobotState(), surefoot.Gains()
    state.v = np.full(18, np.nan)
    gains.foot_kp = math.nan
    assert duplicate(state) == state and np.isnan(duplicate(state).v).all()
    assert duplicate(gains) == gains and math.isnan(duplicate(gains).foot_kp)


@pytest.mark.parametrize("duplicate", COPIES.values(), ids=COPIES)
@pytest.mark.parametrize("kind", [protocol.ReceivedLowCmd, protocol.ReceivedLowState])
def test_received_messages_keep_their_extras(kind, duplicate) -> None:
    message = kind()
    message.raw[5] = 9
    message.extras.robotID = 77
    twin = duplicate(message)
    assert type(twin) is kind and twin == message
    assert (twin.raw[5], twin.extras.robotID) == (9, 77)
    other = copy.deepcopy(message)
    other.extras.robotID = 78
    assert other != message and message.extras.robotID == 77


@pytest.mark.parametrize("row", ["motorState", "motorCmd"])
def test_motor_slots_can_be_copied_and_compared(row) -> None:
    owner = surefoot.LowState() if row == "motorState" else surefoot.LowCmd()
    slots = getattr(owner, row)
    twin = copy.deepcopy(slots)
    assert twin == slots
    slots[3].q = 0.5
    assert twin != slots and twin[3].q != 0.5


def test_a_pickle_of_another_version_is_refused_by_field() -> None:
    gains = surefoot.Gains()
    values, added = gains.__getstate__()
    del values["foot_kp"]
    with pytest.raises(surefoot.Error, match=r"Gains: .*expected field foot_kp"):
        surefoot.Gains().__setstate__((values, added))
    with pytest.raises(surefoot.Error, match=r"LowCmd: .*got .* 3 bytes, expected 734"):
        surefoot.LowCmd().__setstate__((b"abc", None))


@pytest.mark.parametrize("name", RESULTS)
def test_results_can_be_copied_pickled_compared_and_printed(name) -> None:
    results = {type(value).__name__: value for value in measured_results()}
    value = results[name]
    for duplicate in COPIES.values():
        assert duplicate(value) == value
    assert repr(value).startswith(f"{name}(") and "0x" not in repr(value)


def measured_results() -> list[Any]:
    robot = surefoot.load_robot("go1")
    supervisor = surefoot.Supervisor(robot)
    state = surefoot.LowState()
    for tick in range(1, 30, 2):
        state.tick = tick
        supervisor.update(state)
    controller = supervisor.controller
    return [
        *(supervisor.arming, supervisor.arming.checks["tilt"], supervisor.faults),
        *(controller.solution, controller.estimator_report, controller.reach),
        surefoot.UdpLink().counts,
    ]


def test_fault_and_arming_reports_say_what_they_found() -> None:
    reports = {type(value).__name__: repr(value) for value in measured_results()}
    assert re.search(
        r"ArmingCheck\(applies=True, passed=(True|False), value=", reports["ArmingCheck"]
    )
    assert (
        "failed={" in reports["ArmingReport"]
        and "motor_mode: ArmingCheck(" in reports["ArmingReport"]
    )
    assert reports["FaultReport"].startswith("FaultReport(active=[")


@pytest.mark.parametrize("duplicate", COPIES.values(), ids=COPIES)
def test_a_copied_robot_is_equal_and_computes_the_same(duplicate) -> None:
    robot = surefoot.load_robot("go1")
    twin = duplicate(robot)
    assert twin == robot and hash(twin) == hash(robot) and len({robot, twin}) == 1
    assert twin.serialized_model() == robot.serialized_model()
    assert twin.config == robot.config
    assert "go1" in repr(twin)


def test_robots_with_another_configuration_differ() -> None:
    robot = surefoot.load_robot("go1")
    config = robot.config
    config.friction = 0.5
    other = surefoot.Robot.from_serialized_model(robot.serialized_model(), config)
    assert other != robot and robot != surefoot.load_robot("a1") and robot != "go1"


ARRAYS = [
    (kind, name)
    for kind in VALUES
    for name in fields(kind)
    if isinstance(getattr(kind(), name), np.ndarray) and name != "quat_world_base"
]


@pytest.mark.parametrize(("kind", "name"), ARRAYS)
def test_array_fields_accept_lists_tuples_and_other_dtypes(kind, name) -> None:
    value = kind()
    shape = getattr(value, name).shape or (4,)
    numbers = np.arange(1, 1 + np.prod(shape)).reshape(shape)
    for given in (
        numbers.tolist(),
        tuple(numbers.tolist()),
        numbers.astype(float),
        numbers[..., :],
    ):
        setattr(value, name, given)
        np.testing.assert_array_equal(getattr(value, name), numbers)


@pytest.mark.parametrize(("kind", "name"), ARRAYS)
def test_array_fields_refuse_other_shapes_by_name(kind, name) -> None:
    value = kind()
    before = copy.copy(value)
    where = f"{kind.__name__}.{name}: got "
    with pytest.raises(ValueError, match=re.escape(f"{where}shape (2, 2, 1), expected (")):
        setattr(value, name, np.zeros((2, 2, 1)))
    for wrong in ("abc", None, 3.0, [1, [2, 3]], ["a"] * 4, np.zeros(3, complex)):
        with pytest.raises(TypeError, match=re.escape(where) + r".*expected numbers of shape \("):
            setattr(value, name, wrong)
    assert value == before


@pytest.mark.parametrize(("kind", "name"), ARRAYS)
def test_array_fields_are_writable_views(kind, name) -> None:
    value = kind()
    view = getattr(value, name)
    if view.size:
        view.flat[0] = 5
        assert getattr(value, name).flat[0] == 5


INTEGERS = [(k, n) for k, n in ARRAYS if getattr(k(), n).dtype.kind in "iu"]


@pytest.mark.parametrize(("kind", "name"), INTEGERS)
@pytest.mark.parametrize("number", [1.5, math.nan, 1e12, -1e12])
def test_integer_arrays_refuse_numbers_that_they_cannot_hold(kind, name, number) -> None:
    value = kind()
    numbers = np.zeros(getattr(value, name).shape)
    numbers.flat[-1] = number
    with pytest.raises(ValueError, match=rf"{kind.__name__}.{name}: got .*expected whole numbers "):
        setattr(value, name, numbers)
    assert value == kind()


SCALARS = [
    (kind, name)
    for kind in VALUES
    for name in fields(kind)
    if not isinstance(getattr(kind(), name), np.ndarray)
]


@pytest.mark.parametrize(("kind", "name"), SCALARS)
def test_other_fields_refuse_wrong_types_by_name(kind, name) -> None:
    value = kind()
    with pytest.raises(TypeError, match=rf"^{kind.__name__}\.{name}: got .*complex.*, expected "):
        setattr(value, name, 1j)


def test_messages_name_range_and_enumerators() -> None:
    state, options = surefoot.LowState(), surefoot.ControllerOptions()
    with pytest.raises(
        TypeError, match=r"BmsState.SOC: got 300 \(int\), expected a whole number 0"
    ):
        state.bms.SOC = 300
    with pytest.raises(
        TypeError, match=r"ControllerOptions.form: got 'dense' .*AUTO, CONDENSED, GENERAL"
    ):
        options.form = "dense"
    with pytest.raises(TypeError, match=r"RobotConfig.joint_names: .*a list of 12, each a text"):
        surefoot.RobotConfig().joint_names = ["a"]


@pytest.mark.parametrize(
    ("kind", "arguments"),
    [
        (surefoot.BodyReference, {"yaw": "left"}),
        (surefoot.ControllerOptions, {"delay": "soon"}),
        (surefoot.SupervisorOptions, {"stand": surefoot.Gains()}),
        (surefoot.RunOptions, {"power_level": 1.5}),
        (surefoot.WholeBodyOptions, {"form": 3}),
    ],
)
def test_constructor_arguments_are_refused_by_name(kind, arguments) -> None:
    (name,) = arguments
    with pytest.raises(TypeError, match=rf"^{kind.__name__}\.{name}: got "):
        kind(**arguments)
