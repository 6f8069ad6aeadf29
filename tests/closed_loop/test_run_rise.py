# SPDX-License-Identifier: BSD-3-Clause
"""A Runner over UDP: arming checks, rise, stand and sit."""

from __future__ import annotations

import socket

import numpy as np
import pytest
import surefoot
from surefoot import FaultId, Mode, RequestStatus, Start
from surefoot.robot.power_level import power_level
from surefoot.sim import Push
from surefoot.virtual_robot import RemoteEvent
from udp_robot_helpers import UdpLinkedRobot

pytestmark = pytest.mark.real_time

IN_FLIGHT = 2  # commands sent or being computed when damping was requested
IN_20_MS = 10  # commands, at 500 Hz


def begin_rise(linked: UdpLinkedRobot) -> None:
    """Arm the robot and let it rise until its legs fold."""
    linked.arm()
    assert linked.request(Mode.RISE) == RequestStatus.ACCEPTED
    linked.run(1.0)
    assert linked.snapshot.phase == "rising", linked.snapshot.damping_fault
    assert linked.torque_cycles(since=0) > 100


def lift_body(linked: UdpLinkedRobot) -> None:
    """Arm the robot and let it rise until its legs carry the body."""
    begin_rise(linked)
    assert linked.until(lambda now: now.rise_progress > 0.3, 15.0), (
        linked.snapshot.phase,
        linked.snapshot.damping_fault,
    )


def test_a_lying_robot_gets_up_is_pushed_and_lies_down() -> None:
    name = "b1"  # a go1 rises and sits in test_run_rise_command
    with UdpLinkedRobot(name) as linked:
        linked.arm()
        assert linked.torque_cycles(since=0) == 0
        assert linked.request(Mode.RISE) == RequestStatus.ACCEPTED
        assert linked.reaches("standing"), (linked.snapshot.phase, linked.snapshot.damping_fault)
        linked.run(0.5)
        plant, height = linked.robot.plant, linked.robot.height
        impulse = 0.5 * plant.lip_push_limit("lateral")
        plant.add_push(Push("lateral", impulse, time=plant.time + 0.02))
        linked.run(2.0)
        assert linked.snapshot.phase == "standing" and linked.robot.tilt < np.radians(2.0)
        assert linked.robot.height == pytest.approx(height, abs=0.01)
        assert linked.request(Mode.SIT) == RequestStatus.ACCEPTED
        assert linked.reaches("passive")
        linked.run(0.5)
        down = len(linked.damped)
        linked.run(0.2)
        assert len(linked.damped) > down and linked.torque_cycles(since=down) == 0
        assert linked.robot.height < 0.4 * height
        linked.runner.finish()
        assert linked.reaches("ended", 1.0)
        end = linked.snapshot
    assert linked.robot.fell_at is None
    assert (end.reason, end.stood, end.dampings - end.resumed_dampings) == ("asked", True, 0)
    assert end.greatest_power < 2.0 * 100.0 * power_level(name)  # for fewer than six samples


def test_out_of_order_requests_over_udp_send_no_torque() -> None:
    with UdpLinkedRobot() as linked:
        runner = linked.runner
        assert runner.request(Mode.RISE) == RequestStatus.NO_STATE
        assert runner.arm() == RequestStatus.NO_STATE
        assert linked.reaches("passive", 1.0)
        assert linked.request_answer(runner.arm) == RequestStatus.NOT_READY
        for mode in (Mode.RISE, Mode.STAND, Mode.SIT):
            assert linked.request(mode) == RequestStatus.NOT_ARMED
        linked.arm()
        for mode in (Mode.STAND, Mode.SIT, Mode.PASSIVE, Mode.DAMPING):
            assert linked.request(mode) == RequestStatus.OUT_OF_ORDER
        linked.run(0.2)
        assert linked.snapshot.phase == "passive" and linked.torque_cycles(since=0) == 0
        assert linked.request(Mode.RISE) == RequestStatus.ACCEPTED
        assert linked.reaches("rising", 1.0)
        assert linked.request(Mode.RISE) == RequestStatus.OUT_OF_ORDER
        assert linked.request_answer(runner.arm) == RequestStatus.OUT_OF_ORDER
        runner.damp()
        assert linked.reaches("damping", 1.0)
        assert linked.request(Mode.RISE) == RequestStatus.LATCHED


@pytest.mark.parametrize("end", [False, True])
def test_stop_during_a_rise_damps_and_latches(end: bool) -> None:
    with UdpLinkedRobot() as linked:
        begin_rise(linked) if end else lift_body(linked)
        before = len(linked.damped)
        linked.runner.stop() if end else linked.runner.damp()
        linked.run(0.15)
        assert linked.torque_cycles(since=before) <= IN_FLIGHT < IN_20_MS
        now = linked.snapshot
        assert (now.phase, now.reason) == ("ended" if end else "damping", "asked")
        assert end or now.damping_fault == FaultId.STOP
        before = len(linked.damped)
        linked.run(0.5)
        assert linked.torque_cycles(since=before) == 0


def test_lost_link_during_a_rise_damps_and_latches() -> None:
    with UdpLinkedRobot() as linked:
        begin_rise(linked)
        before = len(linked.damped)
        linked.port.interrupted = True
        linked.run(0.15)
        assert len(linked.damped) > before + IN_20_MS
        assert linked.torque_cycles(since=before) <= IN_20_MS
        assert (linked.snapshot.phase, linked.snapshot.reason) == ("damping", "stale")
        assert linked.runner.request(Mode.SIT) == RequestStatus.NO_STATE
        assert linked.runner.arm() == RequestStatus.NO_STATE
        before = len(linked.damped)
        linked.port.interrupted = False
        linked.run(0.2)
        assert (linked.snapshot.phase, linked.snapshot.damping_fault) == ("damping", FaultId.LINK)
        assert linked.request_answer(linked.runner.arm) == RequestStatus.NOT_READY
        assert linked.request(Mode.SIT) == RequestStatus.LATCHED
        linked.arm()
        assert linked.snapshot.phase == "passive" and linked.snapshot.rearms == 1
        assert linked.torque_cycles(since=before) == 0


def test_missing_operator_heartbeat_sits_the_robot_down() -> None:
    with UdpLinkedRobot(operator_timeout=0.3, start=Start.STANDING) as linked:
        for _ in range(10):
            linked.runner.heartbeat()
            linked.run(0.1)
        assert linked.snapshot.phase == "standing", linked.snapshot.damping_fault
        assert linked.until(lambda now: now.phase == "sitting", 0.6)
        assert FaultId.OPERATOR in linked.snapshot.faults.active
        assert linked.reaches("passive")


def test_remote_button_damps_during_a_rise() -> None:
    with UdpLinkedRobot() as linked:
        begin_rise(linked)
        before = len(linked.damped)
        linked.robot.remote.apply(RemoteEvent(0.0, "press", surefoot.Button.B))
        linked.run(0.15)
        assert linked.torque_cycles(since=before) <= IN_20_MS
        assert (linked.snapshot.reason, linked.snapshot.damping_fault) == ("button", FaultId.BUTTON)


def test_real_robot_flag_allows_a_host_beyond_loopback() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # sends nothing: it selects a local address
        except OSError:
            pytest.skip("this machine has only a loopback address")
        address = probe.getsockname()[0]
    with UdpLinkedRobot(host=address) as linked:
        linked.arm()
        assert linked.snapshot.link.valid > 500 and linked.torque_cycles(since=0) == 0


def test_finish_during_a_rise_sits_the_robot_down() -> None:
    with UdpLinkedRobot() as linked:
        lift_body(linked)
        before = len(linked.damped)
        linked.runner.finish()
        assert linked.reaches("sitting", 1.0)
        assert linked.reaches("ended"), linked.snapshot.phase
        assert linked.torque_cycles(since=before) > 100
        before = len(linked.damped)
        linked.run(0.15)
        assert linked.torque_cycles(since=before) == 0
        assert linked.snapshot.reason == "asked"
