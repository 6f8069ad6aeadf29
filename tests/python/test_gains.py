# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import copy
import math
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import surefoot
from surefoot import Error, Gains
from surefoot.sim import Plant, PlantSettings, Push

TABLE = surefoot.gain_table()
NAMES = [info.name for info in TABLE]


@pytest.fixture
def load(tmp_path):
    def load(text: str, start: Gains | None = None) -> Gains:
        path = tmp_path / "mine.toml"
        path.write_text(text)
        return surefoot.load_gains(path, start)

    return load


def values(gains: Gains) -> list[float]:
    return [getattr(gains, name) for name in NAMES]


def test_gain_table_lists_every_gain() -> None:
    attributes = [name for name in vars(Gains) if isinstance(vars(Gains)[name], property)]
    assert attributes == NAMES
    assert len(set(NAMES)) == len(NAMES)


@pytest.mark.parametrize("info", TABLE, ids=NAMES)
def test_default_gain_matches_the_library_and_is_in_range(info) -> None:
    assert info.default == getattr(Gains(), info.name)
    assert info.minimum <= info.default <= info.maximum
    assert info.minimum >= 0.0 or info.name == "recovery_margin"  # -10: no recovery steps
    assert info.unit
    assert info.meaning


def test_the_gains_of_every_robot_are_valid(body) -> None:
    body.robot.config.gains.validate()


@pytest.mark.parametrize("info", TABLE, ids=NAMES)
def test_gain_is_set_and_read_by_name(info) -> None:
    gains = Gains()
    before = values(gains)
    value = 0.5 * (info.default + info.maximum)
    surefoot.set_gain(gains, info.name, value)
    assert surefoot.get_gain(gains, info.name) == getattr(gains, info.name) == value
    before[NAMES.index(info.name)] = value
    assert values(gains) == before


@pytest.mark.parametrize("info", TABLE, ids=NAMES)
@pytest.mark.parametrize("wrong", ["nan", "inf", "below", "above"])
def test_out_of_range_gain_is_named_and_not_set(info, wrong: str) -> None:
    value = {
        "nan": math.nan,
        "inf": math.inf,
        "below": math.nextafter(info.minimum, -math.inf),
        "above": math.nextafter(info.maximum, math.inf),
    }[wrong]
    gains = Gains()
    with pytest.raises(Error, match=rf"'{info.name}' out of range: got .*, expected .* \.\. "):
        surefoot.set_gain(gains, info.name, value)
    assert gains == Gains()
    setattr(gains, info.name, value)
    with pytest.raises(Error, match=rf"'{info.name}' out of range"):
        gains.validate()


@pytest.mark.parametrize("info", TABLE, ids=NAMES)
def test_gain_range_includes_its_ends(info) -> None:
    for value in (info.minimum, info.maximum):
        surefoot.set_gain(Gains(), info.name, value)


@pytest.mark.parametrize("call", [surefoot.get_gain, lambda g, n: surefoot.set_gain(g, n, 1.0)])
def test_unknown_gain_error_suggests_the_nearest_and_lists_all(call) -> None:
    with pytest.raises(Error) as caught:
        call(Gains(), "com_kp_verticle")
    assert "got 'com_kp_verticle' (did you mean 'com_kp_vertical'?)" in str(caught.value)
    assert [name for name in NAMES if name not in str(caught.value)] == []


def test_contact_force_off_must_be_below_contact_force_on() -> None:
    gains = Gains()
    gains.contact_force_off = gains.contact_force_on
    with pytest.raises(Error, match=r"'contact_force_off' must be below 'contact_force_on'"):
        gains.validate()


def test_copied_gains_are_independent() -> None:
    gains = Gains()
    twin = copy.copy(gains)
    assert twin == gains
    twin.foot_kp += 1.0
    assert twin != gains
    assert gains == Gains()


@pytest.mark.parametrize(
    "text", ["[gains]\nfoot_kp = 77\nfoot_kd = 5.5\n", "foot_kp = 77\nfoot_kd = 5.5\n"]
)
def test_gain_file_changes_only_the_gains_it_names(load, text: str) -> None:
    start = Gains()
    start.com_kp_vertical = 99.0
    expected = copy.copy(start)
    expected.foot_kp, expected.foot_kd = 77.0, 5.5
    assert load(text, start) == expected
    assert start.foot_kp == Gains().foot_kp
    assert load("") == Gains()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("foot_kp = -1", "'foot_kp' out of range: got -1, expected 0 .. 5000 [1/s^2]"),
        ("foot_kp = nan", "'foot_kp' out of range: got nan"),
        ("foot_kp = -inf", "'foot_kp' out of range: got -inf"),
        ('foot_kp = "100"', "gain 'foot_kp': got '100', expected a number"),
        ("foot_kp = true", "gain 'foot_kp': got True, expected a number"),
        ("foot_kp = [1.0]", "gain 'foot_kp': got [1.0], expected a number"),
        (f"foot_kp = 1{400 * '0'}", "gain 'foot_kp': got a number too large"),
        (f"foot_kp = -1{400 * '0'}", "gain 'foot_kp': got a number too large"),
        (f"foot_kp = 1{5000 * '0'}", "mine.toml' is not valid TOML"),
        ("foot_kpp = 1.0", "'foot_kpp' (did you mean 'foot_kp'?)"),
        ("contact_force_on = 0.02", "'contact_force_off' must be below"),
        ("foot_kp: 1.0", "mine.toml' is not valid TOML"),
        ("[gains]\nfoot_kp = 1\n[robot]\nname = 'x'", "gains"),
        ("gains = 3", "gains"),
        ("gains = [1, 2]", "gains"),
    ],
)
def test_invalid_gain_file_is_refused(load, text: str, words: str) -> None:
    with pytest.raises(Error) as caught:
        load(text)
    assert words in str(caught.value)


def test_a_missing_gain_file_is_named() -> None:
    with pytest.raises(Error, match=r"cannot read '/no/such/gains.toml'"):
        surefoot.load_gains("/no/such/gains.toml")


CONTROLLERS = [surefoot.StandController, surefoot.WholeBodyController]


@pytest.mark.parametrize("controller", CONTROLLERS)
def test_controller_starts_with_given_or_robot_gains(go1, controller) -> None:
    assert controller(go1.robot).gains == go1.robot.config.gains
    gains = Gains()
    gains.foot_kp = 33.0
    assert controller(go1.robot, gains).gains == gains


@pytest.mark.parametrize("controller", CONTROLLERS)
def test_controller_refuses_invalid_gains_and_keeps_its_own(go1, controller) -> None:
    bad = Gains()
    bad.base_kd_yaw = -3.0
    with pytest.raises(Error, match="'base_kd_yaw' out of range: got -3"):
        controller(go1.robot, bad)
    running = controller(go1.robot)
    with pytest.raises(Error, match="base_kd_yaw"):
        running.set_gains(bad)
    assert running.gains == go1.robot.config.gains


def test_an_estimator_refuses_bad_gains(go1) -> None:
    bad = Gains()
    bad.gate_foot = math.nan
    with pytest.raises(Error, match="'gate_foot' out of range: got nan"):
        surefoot.StateEstimator(go1.robot).set_gains(bad)


@pytest.mark.parametrize("damping", [-0.1, 50.1, math.nan, math.inf])
def test_motor_damping_out_of_range_is_refused(go1, damping: float) -> None:
    with pytest.raises(Error, match="'motor_damping' out of range"):
        surefoot.StandController(go1.robot, Gains(), surefoot.ControllerOptions(damping))


def test_gains_given_to_a_controller_are_copied(go1) -> None:
    gains = Gains()
    controller = surefoot.StandController(go1.robot, gains)
    gains.foot_kp = 1.0
    controller.gains.foot_kp = 2.0
    assert controller.gains == Gains()


def confidence_lost(go1, first: float, later: float) -> float:
    """Return the contact confidence that FR loses in 40 ms without force.

    Args:
        go1: Robot.
        first: contact_dwell at the start [s].
        later: contact_dwell from tick 10 on [s].
    """
    gains = go1.robot.config.gains
    gains.contact_dwell = first
    controller = surefoot.StandController(go1.robot, gains)
    gains.contact_dwell = later
    for tick in range(140):
        lifted = tick >= 120
        loads = (0.0, 0.3, 0.35, 0.35) if lifted else (0.25,) * 4
        report = go1.resting_sample(2 * tick, loads=loads)
        report.footForceEst[:] = 40
        report.footForceEst[0] = 0 if lifted else 40
        controller.update(report)
        if later != first and tick == 10:  # the gain ramp takes 0.1 s
            controller.set_gains(gains)
    return 1.0 - float(controller.state.contact[0])


def test_gains_reach_the_estimator_from_the_start_and_between_ticks(go1) -> None:
    fast, slow = confidence_lost(go1, 0.1, 0.1), confidence_lost(go1, 0.4, 0.4)
    assert 0.2 < fast < 0.4  # 40 ms of a 100 ms dwell time, minus the force filter's lag
    assert fast == pytest.approx(4.0 * slow)
    assert confidence_lost(go1, 0.1, 0.4) == pytest.approx(slow)


@pytest.mark.parametrize("seed", range(5))
def test_saved_gain_file_loads_exactly(tmp_path, seed: int) -> None:
    rng = np.random.default_rng(seed)
    gains = Gains()
    for info in TABLE:
        surefoot.set_gain(gains, info.name, float(rng.uniform(info.minimum, info.maximum)))
    gains.contact_force_off = 0.5 * gains.contact_force_on
    path = tmp_path / "saved.toml"
    surefoot.save_gains(path, gains, "go1", "two lines\nof where they come from")
    assert surefoot.load_gains(path) == gains
    text = path.read_text()
    assert text.startswith("# Gains of go1.\n# two lines\n# of where they come from\n")
    for info in TABLE:
        assert f"# [{info.unit}] {info.meaning}" in text
    assert list(tmp_path.iterdir()) == [path]


def test_gains_out_of_range_are_not_saved(tmp_path) -> None:
    gains = Gains()
    gains.foot_kp = -1.0
    with pytest.raises(Error, match="'foot_kp' out of range"):
        surefoot.save_gains(tmp_path / "bad.toml", gains)
    assert list(tmp_path.iterdir()) == []


def test_unwritable_path_is_named() -> None:
    with pytest.raises(OSError, match=r"/no/such"):
        surefoot.save_gains("/no/such/gains.toml", Gains())


def test_gain_unit_in_a_file_is_checked(load) -> None:
    gains = load('foot_kp = { value = 77, unit = "1/s^2" }')
    assert gains.foot_kp == 77.0
    for text, words in (
        ('{ value = 77, unit = "N/m" }', "'foot_kp': got unit 'N/m', expected '1/s^2'"),
        ("{ value = 77 }", "'foot_kp': got a table of value, expected value and unit"),
        ('{ value = "a", unit = "1/s^2" }', "'foot_kp': got 'a', expected a number"),
    ):
        with pytest.raises(Error, match=re.escape(words)):
            load(f"foot_kp = {text}")


def pushed_torques(go1, change: Callable[[Gains], None]) -> np.ndarray:
    """Return the torques (250, 12) of a pushed robot; the gains change at tick 180 [N.m]."""
    plant = Plant("go1", PlantSettings(sensors="ideal"))
    controller = surefoot.StandController(plant.robot)
    state = plant.reset()
    plant.add_push(Push("lateral", 0.3 * plant.lip_push_limit("lateral"), time=0.2))
    rows = []
    for k in range(250):
        if k == 180:
            gains = controller.gains
            change(gains)
            controller.set_gains(gains)
        command = controller.update(state)
        rows.append([command.motorCmd[i].tau for i in range(12)])
        state = plant.step(command)
    assert controller.gains == gains
    return np.array(rows)


def test_gain_change_during_a_push_causes_no_torque_jump(go1) -> None:
    def stiffer(gains: Gains) -> None:
        for name in ("com_kp_horizontal", "com_kd_horizontal", "base_kp_tilt", "base_kd_tilt"):
            setattr(gains, name, 2.0 * getattr(gains, name))

    left = pushed_torques(go1, lambda gains: None)
    changed = pushed_torques(go1, stiffer)
    before = np.abs(np.diff(left[101:250], axis=0)).max()
    assert np.abs(changed[180] - left[180]).max() < 0.1 * before
    assert np.abs(np.diff(changed[179:], axis=0)).max() < 1.2 * before


def test_gains_apply_at_once_before_the_first_sample_and_after_reset(go1) -> None:
    controller = surefoot.StandController(go1.robot)
    gains = controller.gains
    gains.foot_kp = 77.0
    controller.set_gains(gains)
    assert controller.active_gains == gains
    for tick in range(10):
        controller.update(go1.resting_sample(2 * tick))
    gains.foot_kp = 99.0
    controller.set_gains(gains)
    assert controller.gains == gains
    assert controller.active_gains.foot_kp == 77.0
    controller.update(go1.resting_sample(20))
    assert 77.0 < controller.active_gains.foot_kp < 79.0
    controller.reset()
    assert controller.active_gains == gains


def test_gains_set_every_tick_are_reached(go1) -> None:
    controller = surefoot.StandController(go1.robot)
    for tick in range(10):
        controller.update(go1.resting_sample(2 * tick))
    for tick in range(10, 70):
        gains = controller.gains
        gains.foot_kp = 99.0
        if tick > 12:
            gains.foot_kd = 11.0
        controller.set_gains(gains)
        controller.update(go1.resting_sample(2 * tick))
    assert controller.active_gains == controller.gains
    assert (controller.gains.foot_kp, controller.gains.foot_kd) == (99.0, 11.0)


def test_gain_change_during_damping_applies_at_once(go1) -> None:
    controller = surefoot.StandController(go1.robot)
    for tick in range(10):
        controller.update(go1.resting_sample(2 * tick))
    for _ in range(20):
        command = controller.update(go1.resting_sample(20))
    assert controller.status == surefoot.Status.DAMPING
    gains = controller.gains
    gains.damping_kd = 6.0
    controller.set_gains(gains)
    command = controller.update(go1.resting_sample(22))
    assert command.motorCmd[0].Kd == 6.0


@pytest.mark.parametrize("robot", surefoot.available_robots())
def test_units_in_robot_files_match_the_gain_table(robot: str) -> None:
    file = Path(surefoot.__file__).parent / "models" / f"{robot}.toml"
    said = re.findall(r"^(\w+) = \S+ +# \[(.+?)\]", file.read_text(), re.MULTILINE)
    units = {info.name: info.unit for info in surefoot.gain_table()}
    found = {name: unit for name, unit in said if name in units}
    assert len(found) > 20 and found == {name: units[name] for name in found}
