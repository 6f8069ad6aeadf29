"""Steps of a robot, one foot at a time, with a controller that receives the true state."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from surefoot import LowCmd, Reference, WholeBodyController
from surefoot.bench.problems.three_legged_stance import smoothstep, torque_command, true_state
from surefoot.sim import Plant

LOAD_TRANSFER_TIME = 0.01  # [s] duration of unloading a foot, and of loading it again
LEAN_SHARE = 0.45  # lean as a share of the distance from the centre of four feet to that of three
LEAN_TIME = 0.5  # [s] duration of leaning before a step, and of returning after the step


@dataclass(frozen=True)
class Step:
    """One step in place.

    Attributes:
        foot: 0 FR, 1 FL, 2 RR, 3 RL.
        time: Time of the lift-off [s], at which unloading ends.
        duration: Time from lift-off to touch-down [s]; loading starts at touch-down.
        height: Largest height of the foot [m].
    """

    foot: int
    time: float
    duration: float
    height: float


class Stepper:
    """Controller of a sequence of steps.

    Args:
        plant: Plant after reset().
        steps: Steps in order of time, more than 2 LEAN_TIME apart.
    """

    def __init__(self, plant: Plant, steps: tuple[Step, ...]) -> None:
        self._plant, self._steps = plant, steps
        self._controller = WholeBodyController(plant.robot)
        self._reference = self._controller.hold(true_state(self._plant))
        self._start = np.array(self._reference.p_com)
        feet = [np.array(self._reference.foot(k).p_world) for k in range(4)]
        self._anchors = np.array(feet)

    def update(self) -> LowCmd:
        """Return the command for the current state of the plant."""
        time = self._plant.time
        step = min(self._steps, key=lambda s: abs(time - s.time - 0.5 * s.duration))
        self._set_reference(step, time - step.time)
        airborne = step.foot if 0.0 <= time - step.time < step.duration else None
        solution = self._controller.update(true_state(self._plant, airborne), self._reference)
        return torque_command(self._plant.robot, solution.torques)

    def _set_reference(self, step: Step, time: float) -> None:
        """Set the reference for a time [s] since the lift-off of a step."""
        r: Reference = self._reference
        others = [k for k in range(4) if k != step.foot]
        lean_direction = self._anchors[others].mean(axis=0) - self._anchors.mean(axis=0)
        load_time = time - step.duration
        lean = smoothstep(1.0 + time / LEAN_TIME) * (1.0 - smoothstep(load_time / LEAN_TIME))
        r.p_com = self._start + LEAN_SHARE * lean * np.array(
            [lean_direction[0], lean_direction[1], 0.0]
        )
        foot = r.foot(step.foot)
        foot.load = float(np.clip(max(-time, load_time) / LOAD_TRANSFER_TIME, 0.0, 1.0))
        foot.stance = foot.load > 0.0
        phase = np.clip(time / step.duration, 0.0, 1.0)
        foot.p_world = self._anchors[step.foot] + [0.0, 0.0, step.height * np.sin(np.pi * phase)]
        in_swing = 0.0 < phase < 1.0
        rate = np.pi / step.duration
        speed = step.height * rate * np.cos(np.pi * phase) if in_swing else 0.0
        acceleration = -step.height * rate**2 * np.sin(np.pi * phase) if in_swing else 0.0
        foot.v_world, foot.a_world = [0.0, 0.0, speed], [0.0, 0.0, acceleration]
