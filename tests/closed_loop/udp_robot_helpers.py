# SPDX-License-Identifier: BSD-3-Clause
"""A virtual robot, stepped by the test, and a Runner, linked by UDP."""

from __future__ import annotations

import threading
from collections.abc import Callable

import numpy as np
from surefoot import Mode, RequestStatus, Runner, RunOptions, RunSnapshot, Start
from surefoot.robot.power_level import power_level
from surefoot.sim.hardware.wire_format import MotorCommands
from surefoot.virtual_robot import UdpPort, VirtualRobot, VirtualRobotSettings
from surefoot.virtual_robot.real_time_pacer import RealTimePacer
from surefoot.virtual_robot.udp_port import Address

SEEDS = {"go1": 9, "b1": 1}  # seeds whose robot lies at rest after few drops


class InterruptiblePort(UdpPort):
    """A port that can stop sending samples."""

    interrupted = False

    def send(self, data: bytes, address: Address) -> bool:
        return True if self.interrupted else super().send(data, address)


class UdpLinkedRobot:
    """A virtual robot and its Runner; a context manager that stops the runner.

    The robot lies, or stands with the option start=Start.STANDING.

    Attributes:
        runner: Runner, in its own thread.
        robot: Virtual robot; cycle() advances it by 1 ms in real time.
        damped: Whether the command is damping, for each cycle that received a command.
    """

    def __init__(self, name: str = "go1", host: str = "127.0.0.1", **options: object) -> None:
        options = {"power_level": power_level(name), "start": Start.LYING, **options}
        self.port = InterruptiblePort(host, 0)
        lying = options["start"] == Start.LYING
        settings = VirtualRobotSettings(robot=name, lying=lying, seed=SEEDS[name])
        self.robot = VirtualRobot(settings, self.port)
        self.runner = Runner(
            self.robot.plant.robot,
            *self.port.address,
            settings.generation,
            options=RunOptions(**options),
            real_robot=host != "127.0.0.1",
        )
        self.damped: list[bool] = []
        self._command_count = 0
        self._thread = threading.Thread(target=self.runner.run)

    def __enter__(self) -> UdpLinkedRobot:
        self._thread.start()
        self._clock = RealTimePacer(0.001)
        return self

    def __exit__(self, *_: object) -> None:
        self.runner.stop()
        self._thread.join()
        self.port.close()

    @property
    def snapshot(self) -> RunSnapshot:
        return self.runner.snapshot()

    def cycle(self) -> None:
        self.robot.cycle()
        if self.robot.link.commands > self._command_count:
            self._command_count = self.robot.link.commands
            assert self.robot.command is not None
            self.damped.append(is_damping(self.robot.command))
        self._clock.wait()

    def run(self, seconds: float) -> None:
        for _ in range(round(1000 * seconds)):
            self.cycle()

    def until(self, condition: Callable[[RunSnapshot], bool], seconds: float) -> bool:
        """Run until the condition is true or the time is over; return whether it is true."""
        for k in range(round(1000 * seconds)):
            if k % 20 == 0 and condition(self.snapshot):
                return True
            self.cycle()
        return condition(self.snapshot)

    def reaches(self, phase: str, seconds: float = 15.0) -> bool:
        return self.until(lambda now: now.phase == phase, seconds)

    def request_answer(self, ask: Callable[[], RequestStatus]) -> RequestStatus:
        """Make a request while cycle() sends samples; return the answer."""
        for _ in range(100):
            self.run(0.01)
            if (answer := ask()) != RequestStatus.NO_STATE:
                break
        return answer

    def request(self, mode: Mode) -> RequestStatus:
        return self.request_answer(lambda: self.runner.request(mode))

    def arm(self) -> None:
        ready = self.until(lambda now: now.arming.ready, 5.0)
        assert ready, self.snapshot.arming.failures(self.robot.plant.robot)
        assert self.request_answer(self.runner.arm) == RequestStatus.ACCEPTED
        assert self.until(lambda now: now.armed, 1.0)

    def torque_cycles(self, since: int) -> int:
        """Return the number of commands from index `since` on that are not damping."""
        return self.damped[since:].count(False)


def is_damping(command: MotorCommands) -> bool:
    braking = np.all(command.kd > 0) and np.all(command.dq == 0)
    return bool(braking and np.all(command.tau == 0) and np.all(command.kp == 0))
