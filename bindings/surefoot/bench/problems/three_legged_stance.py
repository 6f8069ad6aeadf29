"""Scenario of a three-legged stance.

The centre of mass moves over three feet. The fourth foot is unloaded and lifted. Then the motion is
reversed. The whole-body controller receives the true state, without estimator.
"""

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
# [s] Durations of the phases. Chosen: slow, so that the motion is quasi-static.
SHIFT_TIME, UNLOAD_TIME, LIFT_TIME, REST_TIME = 1.5, 0.3, 0.4, 0.8
LIFT_HEIGHT = 0.03  # [m] height of the lifted foot; chosen: about 1.5 foot radii
UP = np.array([0.0, 0.0, 1.0])
DURATION = 2 * (SHIFT_TIME + UNLOAD_TIME + LIFT_TIME) + 2 * REST_TIME


@dataclass(frozen=True)
class StancePlan:
    """Progress of the three-legged stance, each value 0 .. 1.

    Attributes:
        com_shift: Horizontal displacement of the centre of mass: 0 at its initial position, 1 above
            the centroid of the three other feet.
        load: Planned load of the foot that is lifted.
        lift: Height of the lifted foot, as a share of LIFT_HEIGHT.
    """

    com_shift: float
    load: float
    lift: float


def stance_plan_at(time: float) -> StancePlan:
    """Return the plan at a time [s]. Phases: shift, unload, lift, rest, then the reverse."""
    t = min(time, DURATION - REST_TIME - time)  # the final rest is on four feet
    com_shift = smoothstep(t / SHIFT_TIME)
    load = 1.0 - smoothstep((t - SHIFT_TIME) / UNLOAD_TIME)
    return StancePlan(com_shift, load, smoothstep((t - SHIFT_TIME - UNLOAD_TIME) / LIFT_TIME))


def run_three_legged_stance(
    robot: str | RobotDescription, form: QpForm, rate: float, seed: int
) -> Iterator[tuple[int, QpProblem]]:
    """Yield (tick, QP) of a three-legged stance; raise Error if the robot falls.

    The function calls the whole-body controller, because the stand controller keeps four stance
    feet.
    """
    plant = Plant(robot, PlantSettings(sensors="ideal", control_rate=rate, seed=seed))
    controller = WholeBodyController(plant.robot, options=WholeBodyOptions(form=form))
    plant.reset()
    reference = controller.hold(true_state(plant))
    start, anchor = reference.p_com.copy(), reference.foot(LIFTED_LEG).p_world.copy()
    goal = start.copy()
    goal[:2] = np.mean([reference.foot(k).p_world[:2] for k in range(4) if k != LIFTED_LEG], axis=0)
    for tick in range(round(DURATION * rate)):
        stance_plan = stance_plan_at(tick / rate)
        reference.p_com = start + stance_plan.com_shift * (goal - start)
        foot = reference.foot(LIFTED_LEG)
        foot.stance, foot.load = stance_plan.load > 0.0, stance_plan.load
        foot.p_world = anchor + LIFT_HEIGHT * stance_plan.lift * UP
        solution = controller.update(
            true_state(plant, None if stance_plan.load > 0.0 else LIFTED_LEG), reference
        )
        if plant.truth.fell or not is_usable(solution.status):
            raise Error(
                f"three-legged stance: {plant.robot.name} fell or got status "
                f"{solution.status.name} at {plant.time:.2f} s; try other gains"
            )
        yield tick, controller.qp
        plant.step(torque_command(plant.robot, solution.torques))


def true_state(plant: Plant, airborne: int | None = None) -> RobotState:
    """Return the true state of the plant, with contact of all feet except the foot `airborne`."""
    truth = plant.truth
    state = RobotState(plant.robot.nq, plant.robot.nv)
    state.q, state.v = truth.q, truth.v
    contact = np.ones(4)
    if airborne is not None:
        contact[airborne] = 0.0
    state.contact = contact
    return state


def torque_command(robot: Robot, torques: np.ndarray) -> LowCmd:
    """Return the command with these joint torques [N.m], in the order of v[6:]."""
    command = LowCmd()
    for motor, v in enumerate(robot.motor_to_v):
        command.motorCmd[motor].tau = torques[v - 6]
    return command


def smoothstep(x: float) -> float:
    """Return 3 x^2 - 2 x^3, with x clamped to [0, 1]; the slope is zero at both ends."""
    x = min(max(x, 0.0), 1.0)
    return x * x * (3.0 - 2.0 * x)
