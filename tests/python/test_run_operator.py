# SPDX-License-Identifier: BSD-3-Clause
"""Typed lines of surefoot run, and what it prints about the readiness of a robot for arming."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
import surefoot
from surefoot import Gait, Mode, WalkLimit, WalkVelocity
from surefoot.cli.run_operator import ArmingMonitor, Operator


def snapshot(phase: str, mode: Mode, ready: bool, armed: bool) -> SimpleNamespace:
    arming = SimpleNamespace(checks={}, ready=ready)
    return SimpleNamespace(time=1.0, phase=phase, mode=mode, armed=armed, arming=arming)


@pytest.mark.parametrize("mode", [Mode.STAND, Mode.PASSIVE])
def test_silent_robot_is_not_reported_as_ready(mode: Mode) -> None:
    said: list[str] = []
    readiness = ArmingMonitor(surefoot.load_robot("go1"), said.append)
    readiness.update(snapshot("standing", Mode.STAND, ready=True, armed=True), False)
    # The robot damps, but damping is not latched yet: the robot may be silent.
    readiness.update(snapshot("damping", mode, ready=True, armed=True), False)
    readiness.update(snapshot("damping", Mode.DAMPING, ready=False, armed=False), False)
    assert said == []
    readiness.update(snapshot("damping", Mode.DAMPING, ready=True, armed=False), False)
    assert said == ["   1.00 s ready"]


def test_typed_gait_is_set_and_an_unknown_one_is_refused() -> None:
    said: list[str] = []
    gaits: list[Gait] = []
    runner = SimpleNamespace(set_gait=gaits.append)
    operator = Operator(runner, surefoot.load_robot("go1"), True, said.append)  # type: ignore[arg-type]
    walking = snapshot("walking", Mode.WALK, ready=True, armed=True)
    for line in ("gait walk", "gait  auto", "gait", "gait trott"):
        operator.handle_line(line, walking)  # type: ignore[arg-type]
    assert gaits == [Gait.WALK, Gait.AUTO]
    assert said[:2] == ["   1.00 s gait walk", "   1.00 s gait auto"]
    assert said[2] == "   1.00 s gait: got ''; valid names: auto, trot, walk"
    assert "gait: got 'trott'" in said[3]


def test_keys_start_from_the_velocity_in_force_if_a_limit_reduced_it() -> None:
    said: list[str] = []
    operator = Operator(SimpleNamespace(), surefoot.load_robot("go1"), True, said.append)  # type: ignore[arg-type]
    walking = snapshot("walking", Mode.WALK, ready=True, armed=True)
    walking.velocity_limit, walking.commanded_velocity = WalkLimit.NONE, WalkVelocity()
    operator.handle_line("v 9 0 0", walking)  # type: ignore[arg-type]
    walking.velocity_limit = WalkLimit.FORWARD
    walking.commanded_velocity = WalkVelocity(1.5, 0.0, 0.0)
    operator.handle_line("k", walking)  # type: ignore[arg-type]
    assert said[-1] == "   1.00 s velocity 1.40 0.00 m/s 0.00 rad/s"
