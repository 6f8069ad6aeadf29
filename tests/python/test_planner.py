# SPDX-License-Identifier: BSD-3-Clause
"""Controller with a planner written in Python."""

from __future__ import annotations

import copy
import re

import numpy as np
import pytest
import surefoot
from surefoot import Controller, FallbackLevel, LowState, Status


class Hold(surefoot.Planner):
    """Keep the pose of the first tick; then call `change`, which a test sets."""

    def __init__(self) -> None:
        super().__init__()
        self.inputs: list[surefoot.PlannerInput] = []
        self.change = lambda reference: None

    def plan(self, input, reference):
        if not self.inputs:
            reference.p_com = input.p_com
            reference.quat_world_base = input.state.q[3:7]
            for leg in range(4):
                reference.foot(leg).p_world = input.p_feet[:, leg]
        self.inputs.append(input)
        return self.change(reference)

    def reset(self) -> None:
        self.inputs.clear()


class Standing:
    """A controller that receives the samples of a robot standing still."""

    def __init__(self, body, planner=None) -> None:
        self.planner = planner or Hold()
        self.controller = Controller(body.robot, self.planner)
        self.good, self.tick = body.resting_sample(0).to_bytes(), 0

    def step(self, ticks: int = 1) -> surefoot.LowCmd:
        for _ in range(ticks):
            sample = LowState.from_bytes(self.good)
            self.tick += 2
            sample.tick = self.tick
            command = self.controller.update(sample)
        return command


def torques(command) -> np.ndarray:
    return np.array([command.motorCmd[motor].tau for motor in range(12)])


def test_robot_of_a_python_planner_stands(go1) -> None:
    standing = Standing(go1)
    command = standing.step(10)
    assert standing.controller.status == Status.OK
    resting = LowState.from_bytes(standing.good)
    expected = [resting.motorState[motor].tauEst for motor in range(12)]
    np.testing.assert_allclose(torques(command), expected, atol=0.5)
    assert len(standing.planner.inputs) == 10
    assert isinstance(standing.controller, Controller)
    assert issubclass(surefoot.StandController, Controller)


def test_planner_input_is_a_copy_with_read_only_arrays(go1) -> None:
    standing = Standing(go1)
    standing.step(3)
    first, last = standing.planner.inputs[0], standing.planner.inputs[-1]
    assert last.dt == pytest.approx(0.002)
    assert last.mass == pytest.approx(go1.robot.mass)
    assert last.lost_leg == -1
    assert last.gains == go1.robot.config.gains
    assert last.p_feet.shape == last.v_feet.shape == (3, 4)
    np.testing.assert_allclose(last.p_com, first.p_com, atol=1e-3)
    np.testing.assert_allclose(last.R_world_base, np.eye(3), atol=1e-3)
    for name in ("p_com", "v_com", "R_world_base", "w_world_base", "p_feet", "v_feet"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(last, name)[0] = 1.0
        with pytest.raises(AttributeError):
            setattr(last, name, np.zeros(3))


def test_planner_receives_the_lost_leg(go1) -> None:
    standing = Standing(go1)
    standing.step(10)
    standing.controller.declare_leg_lost(2)
    standing.step()
    assert standing.planner.inputs[-1].lost_leg == 2
    assert not standing.controller.reference.foot(2).stance


def set_nan(reference) -> None:
    reference.p_com = [0.0, np.nan, 0.3]


@pytest.mark.parametrize("change", [set_nan, lambda reference: False, lambda reference: 0])
def test_bad_reference_ends_one_tick_at_a_fallback_level(go1, change) -> None:
    standing = Standing(go1)
    good = standing.step(10)
    standing.planner.change = change
    fallback = standing.step()
    assert standing.controller.status == Status.BAD_REFERENCE
    assert standing.controller.fallback_level == FallbackLevel.FORCES
    np.testing.assert_allclose(torques(fallback), torques(good), atol=0.5)
    standing.planner.change = lambda reference: None
    standing.step()
    assert standing.controller.status == Status.OK
    assert np.isfinite(standing.controller.reference.p_com).all()


def test_exception_in_plan_ends_the_tick_and_is_raised_after_it(go1) -> None:
    standing = Standing(go1)
    standing.step(10)

    def fail(reference) -> None:
        raise ZeroDivisionError("in plan")

    standing.planner.change = fail
    with pytest.raises(ZeroDivisionError, match="in plan"):
        standing.step()
    assert standing.controller.status == Status.BAD_REFERENCE
    assert standing.controller.fallback_level == FallbackLevel.FORCES
    standing.planner.change = lambda reference: None
    standing.step()
    assert standing.controller.status == Status.OK


def test_reset_resets_the_planner_and_raises_its_exception(go1) -> None:
    standing = Standing(go1)
    standing.step(10)
    standing.controller.reset()
    assert standing.planner.inputs == []
    standing.step(10)
    assert standing.controller.status == Status.OK

    class Failing(Hold):
        def reset(self) -> None:
            raise RuntimeError("in reset")

    controller = Standing(go1, Failing()).controller
    with pytest.raises(RuntimeError, match="in reset"):
        controller.reset()


class NoPlan(surefoot.Planner):
    def reset(self) -> None: ...


class NoReset(surefoot.Planner):
    def plan(self, input, reference) -> None: ...


class NoSuper(Hold):
    def __init__(self) -> None:
        pass


@pytest.mark.parametrize(
    ("planner", "message"),
    [
        (None, r"Controller.planner: got None \(NoneType\), expected an object of a class"),
        ("stand", r"Controller.planner: got 'stand' \(str\), expected an object of a class"),
        (Hold, r"Controller.planner: got <class .*Hold'> .*, expected an object of a class"),
        (NoPlan(), r"Controller.planner: got .*NoPlan.*, expected a class that defines plan\(\)"),
        (NoReset(), r"Controller.planner: got .*NoReset.*, expected a class that .* reset\(\)"),
    ],
)
def test_wrong_planner_is_refused_by_name(go1, planner, message: str) -> None:
    with pytest.raises(TypeError, match=message):
        Controller(go1.robot, planner)


@pytest.mark.filterwarnings("ignore:nanobind. attempted to access an uninitialized instance")
def test_planner_without_super_init_is_refused(go1) -> None:
    with pytest.raises(TypeError, match=re.escape("super().__init__()")):
        Controller(go1.robot, NoSuper())


def test_planner_lives_as_long_as_its_controller(go1) -> None:
    standing = Standing(go1)
    standing.planner = None
    standing.step(10)
    assert standing.controller.status == Status.OK


def test_kept_reference_is_a_copy(go1) -> None:
    standing = Standing(go1)
    standing.step(10)
    kept = copy.deepcopy(standing.controller.reference)
    standing.planner.change = lambda reference: setattr(reference, "a_com", [0.0, 0.0, 0.5])
    standing.step()
    assert kept.a_com[2] == 0.0
    assert standing.controller.reference.a_com[2] == 0.5
