"""A closed-loop run as a sensor log with the truth of the same instants."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from surefoot import LowCmd, LowState, StandController
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.sim import Lift, Plant, PlantSettings
from surefoot.stand import PushRequest, ReferenceRequest
from surefoot.stand.reference_request import body_references

from estimation.log_rows import Array, Log, LogBuilder
from estimation.stepping import Step, Stepper

SINGLE_ENTRIES = ("truth_gyro_bias", "truth_accelerometer_bias", "push_times", "weight", "fell")


@dataclass(frozen=True)
class Scenario:
    """What is to be recorded; the same gives the same log.

    Attributes:
        robot: Its name.
        duration: [s], unless the robot falls.
        plant: Real sensors, or the truth would not belong to the report.
        pushes: In percent of the pendulum's limit or N.s.
        lifts: By hands.
        references: Where the body is asked to be.
        steps: Feet lifted by the robot itself, which then has no StandController.
    """

    robot: str
    duration: float
    plant: PlantSettings
    pushes: tuple[PushRequest, ...] = ()
    lifts: tuple[Lift, ...] = ()
    references: tuple[ReferenceRequest, ...] = field(default=())
    steps: tuple[Step, ...] = ()


def record(recording: Scenario) -> Log:
    """Run the robot under its controller and return what it sensed and what was true."""
    plant = Plant(recording.robot, recording.plant)
    if not plant.settings.real:
        raise ValueError("sensors: got 'ideal', expected 'real'")
    for push in [request.resolve(plant) for request in recording.pushes]:
        plant.add_push(push)
    for lift in recording.lifts:
        plant.add_lift(lift)
    rows = LogBuilder(round(recording.duration * plant.settings.control_rate))
    state = plant.reset()
    control = _make_control(recording, plant)
    for k in range(rows.size):
        command = control(k, state)
        # step() hands out the reading of this instant and keeps that of the next for later.
        truth = _truth(plant)
        state = plant.step(command)
        rows.add(state.raw, truth)
        if plant.truth.fell:
            break
    return {**rows.log(), **_single_entries(recording, plant)}


def _make_control(recording: Scenario, plant: Plant) -> Callable[[int, LowState], LowCmd]:
    """Return what makes a command of a row and its report."""
    if recording.steps:
        stepper = Stepper(plant, recording.steps)
        return lambda _row, _state: stepper.update()
    controller = StandController(plant.robot, plant.robot.config.gains)
    references = body_references(recording.references, plant.settings.control_rate)

    def stand(row: int, state: LowState) -> LowCmd:
        if row in references:
            controller.set_body_reference(references[row])
        return controller.update(state)

    return stand


def _single_entries(recording: Scenario, plant: Plant) -> Log:
    R_base_imu = matrix_from_wxyz(plant.robot.config.quat_base_imu)
    return {
        "truth_gyro_bias": R_base_imu @ plant.imu_bias[:3],
        "truth_accelerometer_bias": R_base_imu @ plant.imu_bias[3:],
        "push_times": np.array([push.time for push in recording.pushes]),
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
    """Return a log of some rows only."""
    return {name: array if name in SINGLE_ENTRIES else array[rows] for name, array in log.items()}


def sample_rate(log: Log) -> float:
    """Return reports per second [Hz]."""
    return 1000.0 / float(log["tick"][1] - log["tick"][0])
