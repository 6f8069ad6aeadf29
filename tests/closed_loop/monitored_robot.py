# SPDX-License-Identifier: BSD-3-Clause
"""A simulated robot with its supervisor, whose power and torque steps are monitored."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
import surefoot
from surefoot import Mode, RequestStatus
from surefoot.faults.kinds.fault import Fault
from surefoot.robot.power_level import power_level
from surefoot.sim import Plant, PlantSettings


def plant_of(name: str, seed: int) -> Plant:
    return Plant(name, PlantSettings(seed=seed, physics_dt=0.001))


@cache
def lying_qpos(name: str, seed: int) -> np.ndarray:
    """Return MuJoCo's qpos of a robot that lies at rest after a drop."""
    plant = plant_of(name, seed)
    plant.reset_lying(np.random.default_rng([seed, 99]))
    return plant.data.qpos.copy()


class MonitoredRobot:
    """A lying robot with its supervisor.

    Attributes:
        faults: Faults that are injected from now on.
        protection_trips: Number of ticks in which the power protection tripped.
        power: Largest power that the power protection computed [W].
        torque_step_at_mode_change: Largest change of a motor's torque in the two ticks from a mode
            change on, as a share of its limit; the torque includes the motor's own damping.
        max_torque_step: The same over all ticks.
        tilt_deg: Largest true tilt of the body [deg].
    """

    def __init__(self, name: str, seed: int) -> None:
        self.plant = plant_of(name, seed)
        self.state = self.plant.reset_lying_at(lying_qpos(name, seed))
        level = power_level(name)
        options = surefoot.SupervisorOptions(power_level=level)
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        self._safety, self._level = surefoot.Safety(self.plant.robot), level
        self._tau_max = np.array(self.plant.robot.config.tau_max)
        self.command = surefoot.LowCmd()
        self.faults: list[Fault] = []
        self._begin()

    def _begin(self) -> None:
        self._tau: np.ndarray | None = None
        self._mode, self._since_change = self.supervisor.mode, 99
        self.protection_trips, self.power, self.torque_step_at_mode_change, self.max_torque_step = (
            0,
            0.0,
            0.0,
            0.0,
        )
        self.tilt_deg = 0.0

    def hold_by_position_control(self, seconds: float) -> None:
        """Hold the robot by position control while a new supervisor receives its samples."""
        hold = surefoot.LowCmd()
        stiffness = 3.0 * self.plant.robot.mass * 9.81
        for i in range(12):
            motor, joint = hold.motorCmd[i], self.state.motorState[i]
            motor.q, motor.dq, motor.tau = joint.q, 0.0, joint.tauEst
            motor.Kp, motor.Kd = stiffness, 0.02 * stiffness
        options = surefoot.SupervisorOptions(power_level=self._level)
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        for _ in range(round(500 * seconds)):
            self.supervisor.update(self.state)
            self.state = self.plant.step(hold)
        self._begin()

    def tick(self) -> None:
        self.command = self.supervisor.update(self.state)
        protection_trips = self._safety.power_protect(self.command, self.state, self._level) < 0
        self.protection_trips += protection_trips
        self.power = max(self.power, self._safety.power)
        self._record_torque_step()
        for fault in self.faults:
            fault.change_command(self.command, 0)
        self.state = self.plant.step(self.command)
        for fault in self.faults:
            fault.change_state(self.state, 0)
        upright = self.plant.data.xmat[self.plant.handles.root, 8]
        self.tilt_deg = max(self.tilt_deg, float(np.degrees(np.arccos(min(upright, 1.0)))))

    def run(self, seconds: float, until: Callable[[], bool] = lambda: False) -> bool:
        """Run until the condition is true or the time is over; return whether it is true."""
        for _ in range(round(500 * seconds)):
            if until():
                return True
            self.tick()
        return until()

    def reaches(self, mode: Mode, seconds: float) -> bool:
        return self.run(seconds, lambda: self.supervisor.mode == mode)

    def arm(self) -> None:
        assert self.run(3.0, lambda: self.supervisor.arming.ready), self.failures
        assert self.supervisor.arm() == RequestStatus.ACCEPTED
        self.tick()

    def request(self, mode: Mode) -> None:
        assert self.supervisor.request(mode) == RequestStatus.ACCEPTED
        self.tick()

    @property
    def failures(self) -> str:
        return str(self.supervisor.arming.failures(self.plant.robot))

    def _record_torque_step(self) -> None:
        motors = [self.command.motorCmd[i] for i in range(12)]
        speeds = [self.state.motorState[i].dq for i in range(12)]
        tau = np.array([m.tau - m.Kd * dq for m, dq in zip(motors, speeds, strict=True)])
        mode = self.supervisor.mode
        self._since_change = 0 if mode != self._mode else self._since_change + 1
        if self._tau is not None:
            step = float(np.max(np.abs(tau - self._tau) / self._tau_max))
            self.max_torque_step = max(self.max_torque_step, step)
            if self._since_change < 2:
                self.torque_step_at_mode_change = max(self.torque_step_at_mode_change, step)
        self._tau, self._mode = tau, mode


def is_damping(command: surefoot.LowCmd) -> bool:
    """Return whether the command is damping: Kd > 0, dq = 0, Kp = 0 and no torque."""
    motors = [command.motorCmd[i] for i in range(12)]
    return all(m.Kd > 0 and m.dq == 0 and m.tau == 0 and m.Kp == 0 for m in motors)
