"""One run of a controller on a plant; records the true motion until the robot falls."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from surefoot._core import LowCmd
from surefoot.assess.checked_controller import ControlFunction
from surefoot.assess.condition import Condition
from surefoot.assess.condition_plant import ground_mover
from surefoot.assess.motion_without_rolling import remove_rolling
from surefoot.geometry.rotations import Array
from surefoot.sim import Plant
from surefoot.sim.lost_frames import lost_frames
from surefoot.sim.truth import has_fallen

TickCallback = Callable[[Plant, int], None]
"""Function that receives the plant and the number of the tick."""


@dataclass(frozen=True)
class TrueTrajectory:
    """True motion of a run. Row 0 is the initial state; every control period adds one row.

    Attributes:
        base: (n, 7) world position [m] and quaternion w x y z of the base.
        feet: (n, 4, 3) centres of the foot spheres in the world frame [m].
        feet_without_roll: (n, 4, 3) `feet` without the motion of rolling: only slides and lifts
            [m].
        fall_tick: Index of the last row if the robot has fallen in it; None if it did not fall.
        rate: Rows per second [Hz].
    """

    base: Array
    feet: Array
    feet_without_roll: Array
    fall_tick: int | None
    rate: float


def roll_out(
    plant: Plant,
    condition: Condition,
    control: ControlFunction,
    duration: float,
    on_tick: TickCallback | None = None,
) -> TrueTrajectory:
    """Run a controller on a plant. The caller must call plant.reseed() first.

    When a LowState frame is lost, the controller receives the previous sample again, as GetRecv()
    of the SDK would return it. When a LowCmd frame is lost, the motors keep the previous command.

    Args:
        plant: Plant of the condition; this function resets the plant.
        condition: Condition of the run; this function applies its frame losses and ground motion.
        control: Controller, LowState -> LowCmd.
        duration: Duration of the run [s].
        on_tick: Function that is called in every tick, before the step of the plant.

    Returns:
        The true motion until the end of the run or until the fall.

    Raises:
        ControllerFailure: The controller failed; see the class.
    """
    ticks = round(duration * plant.settings.control_rate)
    lost = lost_frames(condition.loss_percent, plant.settings.seed, ticks)
    move_ground = ground_mover(condition, plant)
    recorder = _TrajectoryRecorder(plant, ticks + 1)
    received = plant.reset()
    recorder.record(0)
    state, applied = received, None
    for k in range(ticks):
        if not lost[0, k]:
            received = state
        command = control(received)
        if not lost[1, k] or applied is None:
            applied = (
                LowCmd.from_bytes(command.raw.tobytes()) if condition.loss_percent else command
            )
        if on_tick is not None:
            on_tick(plant, k)
        if move_ground is not None:
            move_ground(k / plant.settings.control_rate - condition.quiet_s)
        state = plant.step(applied)
        recorder.record(k + 1)
        if has_fallen(plant.data, plant.handles):
            return recorder.trajectory(k + 2, k + 1)
    return recorder.trajectory(ticks + 1, None)


class _TrajectoryRecorder:
    """Arrays for the true motion of a run; record() fills one row of each array."""

    def __init__(self, plant: Plant, rows: int) -> None:
        self._plant = plant
        self._base = np.zeros((rows, 7))
        self._feet, self._forces = np.zeros((rows, 4, 3)), np.zeros((rows, 4, 3))
        self._attitudes = np.zeros((rows, 4, 4))

    def record(self, row: int) -> None:
        """Write the plant's state into a row."""
        data, handles = self._plant.data, self._plant.handles
        self._base[row] = data.qpos[:7]
        # This runs in every tick, and take() with `out` is four times as fast as indexing. The mode
        # "clip" is safe because all indices are in range; the mode "raise" would make a copy.
        data.xpos.take(handles.foot_bodies, 0, self._feet[row], "clip")
        data.xquat.take(handles.foot_bodies, 0, self._attitudes[row], "clip")
        data.sensordata.take(handles.foot_forces, None, self._forces[row], "clip")

    def trajectory(self, rows: int, fall_tick: int | None) -> TrueTrajectory:
        """Return the trajectory of the first `rows` rows."""
        normal = self._plant.handles.ground_normal
        feet = self._feet[:rows]
        feet_without_roll = remove_rolling(
            feet,
            self._attitudes[:rows],
            self._forces[:rows] @ normal > 0.0,
            self._plant.handles.foot_radius,
            normal,
        )
        rate = self._plant.settings.control_rate
        return TrueTrajectory(self._base[:rows], feet, feet_without_roll, fall_tick, rate)
