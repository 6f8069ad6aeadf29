"""Faults of the surroundings and the QP: strong pushes, external lifts, corrupt QP data."""

from __future__ import annotations

from dataclasses import replace

from surefoot._core import LowCmd, RobotState, Supervisor, Task, TaskRows, WalkVelocity
from surefoot.faults.kinds.fault import Fault
from surefoot.sim import Lift, Plant, PlantSettings, Push

PUSH_DURATION = 0.1  # [s] duration of pushes, as STANDARD_PUSH of the scorecard


class PushFault(Fault):
    """A lateral push far above the LIP push limit.

    Args:
        push_ratio: Ratio of the impulse to the LIP push limit.
        height: Height of the line of action above the centre of mass, as a share of the height of
            the centre of mass.
        until_down: True: reaction times count from the fall: a part other than a foot touches the
            ground, or the tilt exceeds 60 degrees. False: reaction times count from the push.
    """

    def __init__(self, push_ratio: float, height: float, until_down: bool) -> None:
        self._push_ratio, self._height, self._until_down = push_ratio, height, until_down

    def begin(self, plant: Plant) -> None:
        """Start the push."""
        height = self._height * float(plant.data.subtree_com[plant.handles.root][2])
        impulse = self._push_ratio * plant.lip_push_limit("lateral")
        plant.add_push(Push("lateral", impulse, PUSH_DURATION, plant.time, height))

    def is_observable(self, plant: Plant) -> bool:
        """Return True if the robot has fallen; without until_down, always return True."""
        return plant.truth.fell if self._until_down else True


class LiftFault(Fault):
    """An external lift of the trunk or of a foot; the part is released at the full height.

    Args:
        part: "trunk", or the name of a leg for its foot.
        height: Height of the lift [m].
        duration: Time from the start of the lift until the release begins [s].
        ramp: Duration of the release [s].
    """

    def __init__(self, part: str, height: float, duration: float, ramp: float = 0.02) -> None:
        self._part, self._height, self._duration, self._ramp = part, height, duration, ramp

    def begin(self, plant: Plant) -> None:
        """Start the lift."""
        lift = Lift(self._part, plant.time, self._duration, self._height, ramp=self._ramp)
        plant.add_lift(lift)


class SlipperyPatch(Fault):
    """The robot turns back on a patch with low friction, so its feet slip.

    Args:
        friction: Friction coefficient of the patch.
        periods: Number of control periods until the robot has passed the patch.
    """

    def __init__(self, friction: float, periods: int) -> None:
        self._friction, self._periods = friction, periods
        self._plant: Plant | None = None

    def begin(self, plant: Plant) -> None:
        """Lower the friction of all contacts."""
        self._plant = plant
        model = plant.model  # soft soles touch the ground as pairs of geoms
        self._normal_friction = model.geom_friction.copy(), model.pair_friction.copy()
        model.geom_friction[:, 0] = model.pair_friction[:, :2] = self._friction

    def change_velocity(self, velocity: WalkVelocity, k: int) -> WalkVelocity | None:
        """Return the opposite velocity."""
        return WalkVelocity(-velocity.vx, -velocity.vy, -velocity.yaw_rate)

    def change_command(self, command: LowCmd, k: int) -> None:
        """Restore the friction at the end of the patch; leave the command unchanged."""
        if k == self._periods and self._plant is not None:
            model = self._plant.model
            model.geom_friction[:], model.pair_friction[:] = self._normal_friction


class WorkingFootSensors(Fault):
    """The plant has working foot force sensors, even if the real robot has none."""

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the plant settings with foot force sensors."""
        return replace(settings, foot_force="est")


class _CorruptTask(Task):
    """Task with one row; while `active`, the row has the corrupt value, otherwise weight 0."""

    def __init__(self, value: float, weight: float) -> None:
        super().__init__()
        self.value, self.weight, self.active = value, weight, False

    def rows(self) -> int:
        return 1

    def write(self, state: RobotState, rows: TaskRows) -> bool:
        rows.A_a[:] = 0.0
        rows.A_f[:] = 0.0
        rows.A_a[0, 1] = 1.0
        rows.weight[:] = self.weight if self.active else 0.0
        rows.b[:] = self.value if self.active else 0.0
        return True


class CorruptQp(Fault):
    """A task in the StandController makes the data of the QP corrupt.

    Args:
        value: Desired lateral base acceleration of the task [m/s^2].
        every: Number of periods in a cycle.
        burst: Number of periods at the start of each cycle in which the task is active.
        weight: Weight of the task's row.
    """

    def __init__(self, value: float, every: int = 1, burst: int = 1, weight: float = 1.0) -> None:
        self._task, self._every, self._burst = _CorruptTask(value, weight), every, burst

    def prepare(self, supervisor: Supervisor) -> None:
        """Add the task to the StandController."""
        supervisor.controller.add_task(self._task)

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Activate or deactivate the task."""
        self._task.active = k % self._every < self._burst
