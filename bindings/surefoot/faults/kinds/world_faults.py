"""Faults of the world: pushes that nothing saves, hands that lift, solvers that fail."""

from __future__ import annotations

from dataclasses import replace

from surefoot._core import RobotState, Supervisor, Task, TaskRows
from surefoot.faults.kinds.fault import Fault
from surefoot.sim import Lift, Plant, PlantSettings, Push

PUSH_DURATION = 0.1  # [s] of pushes


class PushFault(Fault):
    """A push far beyond what the robot survives.

    Args:
        push_ratio: Of the push that the pendulum survives.
        height: Above the centre of mass, as a share of its own height.
        until_down: Judged from when a body part touches the ground or the tilt is beyond 60
            degrees; else from when the push begins.
    """

    def __init__(self, push_ratio: float, height: float, until_down: bool) -> None:
        self._push_ratio, self._height, self._until_down = push_ratio, height, until_down

    def begin(self, plant: Plant) -> None:
        """Push."""
        height = self._height * float(plant.data.subtree_com[plant.handles.root][2])
        impulse = self._push_ratio * plant.lip_push_limit("lateral")
        plant.add_push(Push("lateral", impulse, PUSH_DURATION, plant.time, height))

    def is_observable(self, plant: Plant) -> bool:
        """Return whether it lies."""
        return plant.truth.fell if self._until_down else True


class LiftFault(Fault):
    """A hand lifts the trunk, or a foot, and puts or lets it down.

    Args:
        part: "trunk" or a foot.
        height: [m].
        duration: [s].
        ramp: In which the grip opens [s].
    """

    def __init__(self, part: str, height: float, duration: float, ramp: float = 0.02) -> None:
        self._part, self._height, self._duration, self._ramp = part, height, duration, ramp

    def begin(self, plant: Plant) -> None:
        """Take hold."""
        lift = Lift(self._part, plant.time, self._duration, self._height, ramp=self._ramp)
        plant.add_lift(lift)


class WorkingFootSensors(Fault):
    """Feet have sensors that work, whatever the real robot's do."""

    def plant_settings(self, settings: PlantSettings) -> PlantSettings:
        """Return the settings with them."""
        return replace(settings, foot_force="est")


class _CorruptTask(Task):
    """A task of one row that asks for nothing, until it asks for a value."""

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
    """The program's numbers are spoilt, by a task among those of the StandController.

    Args:
        value: That is asked for, of the base's acceleration sideways.
        every: In every so many'th period ...
        burst: ... and in so many in all, one after the other.
        weight: Of the row.
    """

    def __init__(self, value: float, every: int = 1, burst: int = 1, weight: float = 1.0) -> None:
        self._task, self._every, self._burst = _CorruptTask(value, weight), every, burst

    def prepare(self, supervisor: Supervisor) -> None:
        """Add the task."""
        supervisor.stand_controller.add_task(self._task)

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Spoil, or not."""
        self._task.active = k % self._every < self._burst
