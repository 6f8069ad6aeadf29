# SPDX-License-Identifier: BSD-3-Clause
"""From lying to standing and back over UDP: a StandRunner behind arming checks."""

from __future__ import annotations

import socket
import threading

import numpy as np
import pytest
import surefoot
from surefoot import FaultId, Mode, RequestStatus
from surefoot.faults.joint_faults import power_level
from surefoot.sim import Push
from surefoot.virtual_robot import RemoteEvent
from wired_helpers import Wired

pytestmark = pytest.mark.alone

IN_FLIGHT = 2  # commands that were on their way, or being made, when they were taken back
IN_20_MS = 10  # commands, at 500 Hz


def rising(wired: Wired) -> None:
    wired.arm()
    assert wired.request(Mode.RISE) == RequestStatus.ACCEPTED
    assert wired.until(lambda now: now.way_up > 0.3, 15.0), (
        wired.now.phase,
        wired.now.damping,
    )


@pytest.mark.parametrize("name", ["go1", "b1"])
def test_a_lying_robot_gets_up_is_pushed_and_lies_down(name: str) -> None:
    with Wired(name) as wired:
        wired.arm()
        assert wired.with_torque(since=0) == 0
        assert wired.request(Mode.RISE) == RequestStatus.ACCEPTED
        assert wired.reaches("standing"), (wired.now.phase, wired.now.damping)
        wired.run(0.5)
        plant, height = wired.robot.plant, wired.robot.height
        impulse = 0.5 * plant.lip_limit("lateral")
        plant.add_push(Push("lateral", impulse, time=plant.time + 0.02))
        wired.run(3.0)
        assert wired.now.phase == "standing" and wired.robot.tilt < np.radians(2.0)
        assert wired.robot.height == pytest.approx(height, abs=0.01)
        assert wired.request(Mode.SIT) == RequestStatus.ACCEPTED
        assert wired.reaches("passive")
        wired.run(0.5)
        down = len(wired.damped)
        wired.run(0.2)
        assert len(wired.damped) > down and wired.with_torque(since=down) == 0
        assert wired.robot.height < 0.4 * height
        wired.runner.finish()
        assert wired.reaches("ended", 1.0)
        end = wired.now
    assert wired.robot.fell_at is None
    assert (end.reason, end.stood, end.dampings - end.pauses) == ("asked", True, 0)
    assert end.greatest_power < 2.0 * 100.0 * power_level(name)  # for less than six reports


def test_what_is_out_of_order_is_refused_and_moves_nothing() -> None:
    with Wired() as wired:
        runner = wired.runner
        assert runner.request(Mode.RISE) == RequestStatus.NO_STATE
        assert runner.arm() == RequestStatus.NO_STATE
        assert wired.reaches("passive", 1.0)
        assert wired.answer(runner.arm) == RequestStatus.NOT_READY
        for mode in (Mode.RISE, Mode.STAND, Mode.SIT):
            assert wired.request(mode) == RequestStatus.NOT_ARMED
        wired.arm()
        for mode in (Mode.STAND, Mode.SIT, Mode.PASSIVE, Mode.DAMPING):
            assert wired.request(mode) == RequestStatus.OUT_OF_ORDER
        wired.run(0.2)
        assert wired.now.phase == "passive" and wired.with_torque(since=0) == 0
        assert wired.request(Mode.RISE) == RequestStatus.ACCEPTED
        assert wired.reaches("rising", 1.0)
        assert wired.request(Mode.RISE) == RequestStatus.OUT_OF_ORDER
        assert wired.answer(runner.arm) == RequestStatus.OUT_OF_ORDER
        runner.damp()
        assert wired.reaches("damping", 1.0)
        assert wired.request(Mode.RISE) == RequestStatus.LATCHED


@pytest.mark.parametrize("end", [False, True])
def test_a_stop_in_a_rise_damps_at_once_and_for_good(end: bool) -> None:
    with Wired() as wired:
        rising(wired)
        before = len(wired.damped)
        wired.runner.stop() if end else wired.runner.damp()
        wired.run(0.15)
        assert wired.with_torque(since=before) <= IN_FLIGHT < IN_20_MS
        now = wired.now
        assert (now.phase, now.reason) == ("ended" if end else "damping", "asked")
        assert end or now.damping == FaultId.STOP
        before = len(wired.damped)
        wired.run(0.5)
        assert wired.with_torque(since=before) == 0


def test_silence_in_a_rise_damps_and_latches() -> None:
    with Wired() as wired:
        rising(wired)
        before = len(wired.damped)
        wired.port.cut = True
        wired.run(0.15)
        assert len(wired.damped) > before + IN_20_MS
        assert wired.with_torque(since=before) <= IN_20_MS
        assert (wired.now.phase, wired.now.reason) == ("damping", "stale")
        assert wired.runner.request(Mode.SIT) == RequestStatus.NO_STATE
        assert wired.runner.arm() == RequestStatus.NO_STATE
        before = len(wired.damped)
        wired.port.cut = False
        wired.run(0.2)
        assert (wired.now.phase, wired.now.damping) == ("damping", FaultId.LINK)
        assert wired.answer(wired.runner.arm) == RequestStatus.NOT_READY
        assert wired.request(Mode.SIT) == RequestStatus.LATCHED
        wired.arm()
        assert wired.now.phase == "passive" and wired.now.rearms == 1
        assert wired.with_torque(since=before) == 0


def test_an_operator_who_is_gone_has_the_robot_sit_down() -> None:
    with Wired(operator_timeout=0.3) as wired:
        beats = threading.Event()

        def beat() -> None:
            while not beats.wait(0.05):
                wired.runner.heartbeat()

        operator = threading.Thread(target=beat)
        operator.start()
        try:
            rising(wired)
            assert wired.reaches("standing"), wired.now.damping
        finally:
            beats.set()
            operator.join()
        assert wired.until(lambda now: now.phase == "sitting", 0.6)
        assert FaultId.OPERATOR in wired.now.faults.active
        assert wired.reaches("passive")


def test_the_remotes_button_damps_in_a_rise() -> None:
    with Wired() as wired:
        rising(wired)
        before = len(wired.damped)
        wired.robot.remote.apply(RemoteEvent(0.0, "press", surefoot.Button.B))
        wired.run(0.15)
        assert wired.with_torque(since=before) <= IN_20_MS
        assert (wired.now.reason, wired.now.damping) == ("button", FaultId.BUTTON)


def test_a_peer_beyond_loopback_is_talked_to_when_told_so() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # sends nothing: it chooses an address of ours
        except OSError:
            pytest.skip("this machine has no address but loopback")
        address = probe.getsockname()[0]
    with Wired(host=address) as wired:
        wired.arm()
        assert wired.now.link.valid > 500 and wired.with_torque(since=0) == 0


def test_the_end_of_a_rise_is_lying_down() -> None:
    with Wired() as wired:
        rising(wired)
        before = len(wired.damped)
        wired.runner.finish()
        assert wired.reaches("sitting", 1.0)
        assert wired.reaches("ended"), wired.now.phase
        assert wired.with_torque(since=before) > 100
        before = len(wired.damped)
        wired.run(0.15)
        assert wired.with_torque(since=before) == 0
        assert wired.now.reason == "asked"
