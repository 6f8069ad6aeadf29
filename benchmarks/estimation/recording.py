"""Recording of closed-loop runs as sensor logs, with the true state at the time of each row."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from surefoot import LowCmd, LowState, StandController, WalkController, WalkVelocity
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.sim import Lift, Plant, PlantSettings
from surefoot.stand import PushRequest, ReferenceRequest
from surefoot.stand.reference_request import body_references
from surefoot.walk import VelocityRequest
from surefoot.walk.velocity_request import velocity_ticks

from estimation.log_rows import Array, Log, LogBuilder
from estimation.stepping import Step, Stepper

SINGLE_ENTRIES = ("truth_gyro_bias", "truth_accelerometer_bias", "push_times", "weight", "fell")


@dataclass(frozen=True)
class Scenario:
    """Settings of a recording; equal settings give equal logs.

    Attributes:
        robot: Name of the robot.
        duration: Duration [s]; the run ends earlier if the robot falls.
        plant: Settings of the plant. Sensors must be real, because with ideal sensors the truth and
            the LowState have different times.
        pushes: Pushes in percent of the LIP push limit or in N.s.
        lifts: External lifts.
        references: Body references.
        steps: Steps of the robot; with steps, a Stepper replaces the StandController.
        velocities: Velocity commands; with velocities, a WalkController replaces the
            StandController.
    """

    robot: str
    duration: float
    plant: PlantSettings
    pushes: tuple[PushRequest, ...] = ()
    lifts: tuple[Lift, ...] = ()
    references: tuple[ReferenceRequest, ...] = field(default=())
    steps: tuple[Step, ...] = ()
    velocities: tuple[VelocityRequest, ...] = ()


def record(scenario: Scenario) -> Log:
    """Run the robot with its controller and return the LowStates and the truth as a log."""
    plant = Plant(scenario.robot, scenario.plant)
    if not plant.settings.real:
        raise ValueError("sensors: got 'ideal', expected 'real'")
    for push in [request.resolve(plant) for request in scenario.pushes]:
        plant.add_push(push)
    for lift in scenario.lifts:
        plant.add_lift(lift)
    rows = LogBuilder(round(scenario.duration * plant.settings.control_rate))
    state = plant.reset()
    control = _make_control(scenario, plant)
    for k in range(rows.size):
        command = control(k, state)
        # step() returns the LowState that is sampled at its start, so read the truth before step().
        truth = _truth(plant)
        state = plant.step(command)
        rows.add(state.raw, truth)
        if plant.truth.fell:
            break
    return {**rows.log(), **_single_entries(scenario, plant)}


def _make_control(scenario: Scenario, plant: Plant) -> Callable[[int, LowState], LowCmd]:
    """Return the function that computes the command from a row and its LowState."""
    if scenario.steps:
        stepper = Stepper(plant, scenario.steps)
        return lambda _row, _state: stepper.update()
    if scenario.velocities:
        return _make_walk(scenario, plant)
    controller = StandController(plant.robot, plant.robot.config.gains)
    references = body_references(scenario.references, plant.settings.control_rate)

    def stand(row: int, state: LowState) -> LowCmd:
        if row in references:
            controller.set_body_reference(references[row])
        return controller.update(state)

    return stand


def _make_walk(scenario: Scenario, plant: Plant) -> Callable[[int, LowState], LowCmd]:
    controller = WalkController(plant.robot, plant.robot.config.gains)
    requests = dict(velocity_ticks(scenario.velocities, plant.settings.control_rate))
    velocity = WalkVelocity()

    def walk(row: int, state: LowState) -> LowCmd:
        nonlocal velocity
        if row in requests:
            velocity = requests[row].velocity
        controller.set_velocity(velocity)  # in every tick: a velocity times out
        return controller.update(state)

    return walk


def _single_entries(scenario: Scenario, plant: Plant) -> Log:
    R_base_imu = matrix_from_wxyz(plant.robot.config.quat_base_imu)
    return {
        "truth_gyro_bias": R_base_imu @ plant.imu_bias[:3],
        "truth_accelerometer_bias": R_base_imu @ plant.imu_bias[3:],
        "push_times": np.array([push.time for push in scenario.pushes]),
        "weight": np.array(9.81 * plant.robot.mass),
        "fell": np.array(plant.truth.fell),
    }


def _truth(plant: Plant) -> Log:
    data, handles = plant.data, plant.handles
    forces = data.sensordata[handles.foot_forces]
    return {
        "truth_p": data.qpos[0:3].copy(),
        "truth_quaternion": data.qpos[3:7].copy(),
        "truth_v": data.qvel[0:3].copy(),
        "truth_q": data.qpos[handles.joint_q],
        "truth_dq": data.qvel[handles.joint_v],
        "truth_foot_forces": forces.ravel(),
        "truth_contact": forces @ handles.ground_normal > 0.0,
        "truth_com": data.subtree_com[handles.root].copy(),
    }


def select_rows(log: Log, rows: slice | Array) -> Log:
    """Return a log with a selection of rows."""
    return {name: array if name in SINGLE_ENTRIES else array[rows] for name, array in log.items()}


def sample_rate(log: Log) -> float:
    """Return the rate of the LowStates [Hz]."""
    return 1000.0 / float(log["tick"][1] - log["tick"][0])
