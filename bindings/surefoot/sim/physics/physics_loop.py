"""The physics loop: advances the simulation with delayed commands, pushes and external lifts."""

from __future__ import annotations

from collections import deque

import mujoco
import numpy as np

from surefoot import _plant
from surefoot._core import Robot
from surefoot.geometry.rotations import Array
from surefoot.sim.hardware.motors import MotorLaw, Motors
from surefoot.sim.hardware.sensors import Sensors
from surefoot.sim.model.mujoco_handles import Handles
from surefoot.sim.physics.external_lift import ExternalLift, Lift
from surefoot.sim.physics.pushes import PushSchedule
from surefoot.sim.settings import Push


class PhysicsLoop:
    """Advances the simulation, with one call of C++ for all steps until the next event.

    An event is the time at which a scheduled motor law takes effect, or a step in which a push or
    an external lift acts.

    Args:
        model: MuJoCo's model.
        data: MuJoCo's state, which the loop advances.
        handles: Indices into model and data.
        robot: The robot, for its mass.
        physics: The C++ object that computes the steps.
        dt: Physics step [s].

    Attributes:
        motors: Motors of the present run, from start().
        sensors: Sensors of the present run, from start().
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        data: mujoco.MjData,
        handles: Handles,
        robot: Robot,
        physics: _plant.Physics,
        dt: float,
    ) -> None:
        self._model, self._data, self._handles = model, data, handles
        self._robot, self._physics, self._dt = robot, physics, dt

    def start(self, motors: Motors, sensors: Sensors) -> None:
        """Start a new run, without scheduled laws, external torques, pushes or lifts."""
        self.motors, self.sensors = motors, sensors
        self._scheduled_laws: deque[tuple[int, MotorLaw]] = deque()
        self._physics.external_torque = np.zeros(12)
        self.restart_time()

    def restart_time(self) -> None:
        """Set the clock to zero, and remove all pushes and lifts. Scheduled motor laws stay."""
        self._push_schedule = PushSchedule(self._handles.root, self._dt, ())
        self._lifts: list[ExternalLift] = []
        self._step = 0

    @property
    def time(self) -> float:
        """Time since start() or restart_time() [s]."""
        return self._step * self._dt

    @property
    def push_force(self) -> tuple[Array, Array]:
        """Push force (3,) [N] in the last physics step, and its point (3,) [m], world axes."""
        return self._push_schedule.force, self._push_schedule.point

    def add_push(self, push: Push) -> None:
        """Schedule a push."""
        self._push_schedule.add(push)

    def add_lift(self, lift: Lift) -> None:
        """Schedule an external lift."""
        self._lifts.append(ExternalLift(self._model, self._handles, self._robot, lift))

    def schedule_law(self, law: MotorLaw, steps: int) -> None:
        """Schedule a motor law that takes effect after `steps` physics steps."""
        self._scheduled_laws.append((self._step + steps, law))

    def apply_joint_torque(self, torque: Array) -> None:
        """Apply external torques (12,) [N.m] to the joints from now on."""
        # The torques act on the links. With backlash, the motors act on other coordinates.
        if np.array_equal(self._handles.joint_v, self._handles.motor_v):
            self._physics.external_torque = torque
        else:
            self._data.qfrc_applied[self._handles.joint_v] = torque

    def advance(self, steps: int) -> None:
        """Advance by `steps` physics steps."""
        end = self._step + steps
        while self._step < end:
            while self._scheduled_laws and self._scheduled_laws[0][0] <= self._step:
                self.motors.law = self._scheduled_laws.popleft()[1]
            if self._lifts:
                self._apply_lifts()
            count = min(end - self._step, self._push_schedule.idle_steps(self.time))
            if count == 0:
                self._push_schedule.apply(self._data, self.time)
            if self._scheduled_laws:
                count = min(count, self._scheduled_laws[0][0] - self._step)
            count = 1 if self._lifts else max(1, count)
            self._physics.advance(count, self.motors, self.sensors)
            self._step += count

    def _apply_lifts(self) -> None:
        # MuJoCo keeps xfrc_applied until the next write, so clear it first. An active push later
        # overwrites the trunk's entry.
        self._data.xfrc_applied[:] = 0.0
        for lift in self._lifts:
            lift.apply(self._data, self.time)
