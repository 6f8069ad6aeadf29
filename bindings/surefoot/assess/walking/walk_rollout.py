"""One walk of a controller on a plant."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from surefoot._core import LowCmd, WalkVelocity
from surefoot.assess.checked_controller import WalkingControl
from surefoot.assess.condition import Condition
from surefoot.assess.condition_plant import source_settings
from surefoot.assess.robot_source import RobotSource, describe_source
from surefoot.assess.walking.true_walk import TrueWalk, WalkRecorder
from surefoot.sim import Plant
from surefoot.sim.lost_frames import lost_frames

Schedule = Sequence[tuple[float, tuple[float, float, float]]]
"""Times [s] in ascending order, each with the velocity from then on; before the first one: 0."""


@lru_cache(maxsize=32)
def walking_plant_of(source: RobotSource, condition: Condition) -> Plant:
    """Return the cached plant of a condition, with sensor errors and soft soles of a walk.

    Call reseed() before each run.
    """
    settings = source_settings(source, condition)
    return Plant(
        describe_source(source),
        replace(settings, walking_sensors=True, soft_soles=True, leg_collisions=True),
    )


def walk_out(
    plant: Plant,
    condition: Condition,
    control: WalkingControl,
    schedule: Schedule,
    duration: float,
    on_tick: Callable[[Plant, int], None] | None = None,
) -> TrueWalk:
    """Run a controller that walks. The caller must call plant.reseed() first.

    Lost frames are as in roll_out().

    Args:
        plant: Plant of the condition; this function resets the plant.
        condition: Condition of the run; this function applies its frame losses.
        control: Controller that walks; it receives the velocity in every tick.
        schedule: Commanded velocities.
        duration: Duration of the run [s]; a fall ends it earlier.
        on_tick: Function that is called in every tick, before the step of the plant.

    Raises:
        ControllerFailure: The controller failed; see the class.
    """
    rate = plant.settings.control_rate
    ticks = round(duration * rate)
    lost = lost_frames(condition.loss_percent, plant.settings.seed, ticks)
    starts = {round(time * rate): velocity for time, velocity in schedule}
    recorder = WalkRecorder(plant, ticks)
    state = received = plant.reset()
    applied: LowCmd | None = None
    truth, velocity = plant.truth, WalkVelocity()
    for k in range(ticks):
        velocity = WalkVelocity(*starts[k]) if k in starts else velocity
        if not lost[0, k]:
            received = state
        command = control.update(received, velocity)
        if not lost[1, k] or applied is None:
            applied = LowCmd.from_bytes(command.raw.tobytes())
        recorder.record(truth, np.array([velocity.vx, velocity.vy, velocity.yaw_rate]))
        if on_tick is not None:
            on_tick(plant, k)
        state = plant.step(applied)
        truth = plant.truth
        if truth.fell:
            break
    return recorder.walk(truth.fell)
