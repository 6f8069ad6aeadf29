"""A stand on three feet: the centre of mass moves over three, the fourth goes up and comes back."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from surefoot._core import (
    Error,
    Form,
    LowCmd,
    QpProblem,
    Robot,
    RobotState,
    WholeBodyController,
    WholeBodyOptions,
    is_usable,
)
from surefoot.robot_files import RobotDescription
from surefoot.sim import Plant, PlantSettings

LIFTED = 0  # FR
SHIFT, UNLOAD, LIFT, REST = 1.5, 0.3, 0.4, 0.8  # [s]
HEIGHT = 0.03  # [m] of the foot in the air
UP = np.array([0.0, 0.0, 1.0])
DURATION = 2 * (SHIFT + UNLOAD + LIFT) + 2 * REST


@dataclass(frozen=True)
class Limp:
    """How far along it is: each 0 .. 1.

    Attributes:
        over: The centre of mass, from where it was to over three feet.
        load: Planned share of the fourth foot.
        up: The fourth foot, from the ground to HEIGHT.
    """

    over: float
    load: float
    up: float


def limp_at(time: float) -> Limp:
    """Return the plan at a time [s]: there, a rest, and the same way back."""
    t = min(time, DURATION - REST - time)  # the last rest is on four feet
    over = ease(t / SHIFT)
    load = 1.0 - ease((t - SHIFT) / UNLOAD)
    return Limp(over, load, ease((t - SHIFT - UNLOAD) / LIFT))


def run_limp(
    robot: str | RobotDescription, form: Form, rate: float, seed: int
) -> Iterator[tuple[int, QpProblem]]:
    """Yield (tick, program) of a controller that is given the true state; raises Error if it falls.

    Estimation is not what is recorded, and the stand controller keeps all its feet down.
    """
    plant = Plant(robot, PlantSettings(sensors="ideal", control_rate=rate, seed=seed))
    controller = WholeBodyController(plant.robot, options=WholeBodyOptions(form=form))
    plant.reset()
    reference = controller.hold(true_state(plant))
    start, anchor = reference.p_com.copy(), reference.foot(LIFTED).p_world.copy()
    goal = start.copy()
    goal[:2] = np.mean([reference.foot(k).p_world[:2] for k in range(4) if k != LIFTED], axis=0)
    for tick in range(round(DURATION * rate)):
        limp = limp_at(tick / rate)
        reference.p_com = start + limp.over * (goal - start)
        foot = reference.foot(LIFTED)
        foot.stance, foot.load = limp.load > 0.0, limp.load
        foot.p_world = anchor + HEIGHT * limp.up * UP
        solution = controller.update(
            true_state(plant, None if limp.load > 0.0 else LIFTED), reference
        )
        if plant.truth.fell or not is_usable(solution.status):
            raise Error(
                f"limp: got a {plant.robot.name} {solution.status.name} at {plant.time:.2f} s"
            )
        yield tick, controller.program
        plant.step(torque_command(plant.robot, solution.torques))


def true_state(plant: Plant, airborne: int | None = None) -> RobotState:
    """Return the plant's state; contact is what was planned: all feet but one that is airborne."""
    truth = plant.truth
    state = RobotState(plant.robot.nq, plant.robot.nv)
    state.q, state.v = truth.q, truth.v
    contact = np.ones(4)
    if airborne is not None:
        contact[airborne] = 0.0
    state.contact = contact
    return state


def torque_command(robot: Robot, torques: np.ndarray) -> LowCmd:
    """Return the command that has the motors make these torques (order of v[6:])."""
    command = LowCmd()
    for motor, v in enumerate(robot.motor_to_v):
        command.motorCmd[motor].tau = torques[v - 6]
    return command


def ease(x: float) -> float:
    """Return 0 .. 1 for x from 0 to 1, at rest at both ends."""
    x = min(max(x, 0.0), 1.0)
    return x * x * (3.0 - 2.0 * x)
