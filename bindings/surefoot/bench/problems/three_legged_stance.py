"""A stand on three feet: the centre of mass moves over three, the fourth goes up and comes back."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from surefoot._core import (
    Error,
    LowCmd,
    QpForm,
    QpProblem,
    Robot,
    RobotState,
    WholeBodyController,
    WholeBodyOptions,
    is_usable,
)
from surefoot.robot.description import RobotDescription
from surefoot.sim import Plant, PlantSettings

LIFTED_LEG = 0  # FR
SHIFT_TIME, UNLOAD_TIME, LIFT_TIME, REST_TIME = 1.5, 0.3, 0.4, 0.8  # [s]
LIFT_HEIGHT = 0.03  # [m] of the foot in the air
UP = np.array([0.0, 0.0, 1.0])
DURATION = 2 * (SHIFT_TIME + UNLOAD_TIME + LIFT_TIME) + 2 * REST_TIME


@dataclass(frozen=True)
class Limp:
    """How far along it is: each 0 .. 1.

    Attributes:
        com_shift: The centre of mass, from where it was to over three feet.
        load: Planned share of the fourth foot.
        lift: The fourth foot, from the ground to HEIGHT.
    """

    com_shift: float
    load: float
    lift: float


def limp_at(time: float) -> Limp:
    """Return the plan at a time [s]: there, a rest, and the same way back."""
    t = min(time, DURATION - REST_TIME - time)  # the last rest is on four feet
    com_shift = smoothstep(t / SHIFT_TIME)
    load = 1.0 - smoothstep((t - SHIFT_TIME) / UNLOAD_TIME)
    return Limp(com_shift, load, smoothstep((t - SHIFT_TIME - UNLOAD_TIME) / LIFT_TIME))


def run_limp(
    robot: str | RobotDescription, form: QpForm, rate: float, seed: int
) -> Iterator[tuple[int, QpProblem]]:
    """Yield (tick, program) of a controller that is given the true state; raises Error if it falls.

    Estimation is not what is recorded, and the stand controller keeps all its feet down.
    """
    plant = Plant(robot, PlantSettings(sensors="ideal", control_rate=rate, seed=seed))
    controller = WholeBodyController(plant.robot, options=WholeBodyOptions(form=form))
    plant.reset()
    reference = controller.hold(true_state(plant))
    start, anchor = reference.p_com.copy(), reference.foot(LIFTED_LEG).p_world.copy()
    goal = start.copy()
    goal[:2] = np.mean([reference.foot(k).p_world[:2] for k in range(4) if k != LIFTED_LEG], axis=0)
    for tick in range(round(DURATION * rate)):
        limp = limp_at(tick / rate)
        reference.p_com = start + limp.com_shift * (goal - start)
        foot = reference.foot(LIFTED_LEG)
        foot.stance, foot.load = limp.load > 0.0, limp.load
        foot.p_world = anchor + LIFT_HEIGHT * limp.lift * UP
        solution = controller.update(
            true_state(plant, None if limp.load > 0.0 else LIFTED_LEG), reference
        )
        if plant.truth.fell or not is_usable(solution.status):
            raise Error(
                f"limp: got a {plant.robot.name} {solution.status.name} at {plant.time:.2f} s"
            )
        yield tick, controller.qp
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


def smoothstep(x: float) -> float:
    """Return 0 .. 1 for x from 0 to 1, at rest at both ends."""
    x = min(max(x, 0.0), 1.0)
    return x * x * (3.0 - 2.0 * x)
