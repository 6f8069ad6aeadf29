# SPDX-License-Identifier: BSD-3-Clause
"""What surefoot run prints about the readiness of a robot for arming."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
import surefoot
from surefoot import Mode
from surefoot.cli.run_operator import ArmingMonitor


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
