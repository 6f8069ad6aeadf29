# SPDX-License-Identifier: BSD-3-Clause
"""A Runner over UDP whose robot walks: remote, velocities and gaits."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from surefoot import Button, Gait, Mode, RequestStatus, Start, WalkVelocity
from surefoot.virtual_robot import RemoteEvent
from udp_robot_helpers import UdpLinkedRobot

pytestmark = pytest.mark.real_time

POWER_LEVEL = 5  # carries 1.3 m/s; level 1 carries no walk


@pytest.fixture
def linked() -> Iterator[UdpLinkedRobot]:
    """A robot on UDP that stands; it must not fall."""
    with UdpLinkedRobot(power_level=POWER_LEVEL, start=Start.STANDING) as linked:
        assert linked.reaches("standing", 2.0), linked.snapshot.damping_fault
        linked.run(0.5)
        yield linked
    assert linked.robot.fell_at is None


def click(linked: UdpLinkedRobot, button: Button) -> None:
    for action in ("press", "release"):
        linked.robot.remote.apply(RemoteEvent(0.0, action, button))
        linked.run(0.05)


def test_remote_walks_the_robot_and_chooses_its_gait(linked: UdpLinkedRobot) -> None:
    linked.robot.remote.apply(RemoteEvent(0.0, "ly", value=1.0))
    start = linked.robot.plant.truth.q[:2].copy()
    click(linked, Button.START)
    assert linked.snapshot.start_answer == RequestStatus.ACCEPTED
    assert linked.reaches("walking", 1.0), linked.snapshot.phase
    linked.run(2.5)
    assert np.linalg.norm(linked.robot.plant.truth.q[:2] - start) > 0.5
    gaits = []
    for _ in Gait:
        gaits.append(linked.snapshot.gait)
        click(linked, Button.SELECT)
    assert gaits == [Gait.AUTO, Gait.TROT, Gait.WALK] and linked.snapshot.gait == Gait.AUTO
    linked.robot.remote.apply(RemoteEvent(0.0, "ly", value=0.0))
    click(linked, Button.START)
    assert linked.reaches("standing", 4.0), linked.snapshot.phase


def test_program_sets_velocity_and_gait_of_a_runner(linked: UdpLinkedRobot) -> None:
    assert linked.request(Mode.WALK) == RequestStatus.ACCEPTED
    linked.runner.set_gait(Gait.WALK)
    for _ in range(30):
        linked.runner.set_velocity(WalkVelocity(vx=0.1))
        linked.run(0.1)
    now = linked.snapshot
    assert (now.phase, now.gait) == ("walking", Gait.WALK)
    assert now.commanded_velocity.vx == pytest.approx(0.1)
    # On level ground the true height is above z = 0; the estimated position drifts.
    assert now.height == pytest.approx(linked.robot.plant.truth.q[2], abs=0.01)
    linked.run(0.7)  # the velocity times out
    assert linked.snapshot.commanded_velocity.vx == 0.0
