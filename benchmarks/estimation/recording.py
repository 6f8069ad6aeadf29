"""A closed-loop run as a sensor log with the truth of the same instants."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt
from surefoot import LowCmd, LowState, StandController
from surefoot.sim import Lift, Plant, PlantSettings
from surefoot.sim.rotations import matrix_from_wxyz
from surefoot.sim.wire import LOW_STATE, MOTORS
from surefoot.stand import PushRequest, ReferenceRequest
from surefoot.stand.references import body_references

from estimation.stepping import Step, Stepper

Array = npt.NDArray[Any]
Log = dict[str, Array]
"""Rows of a run by name; every array is (n, k) or (n,), the last five are single.

tick (n,) [ms], accelerometer (n, 3), gyroscope (n, 3), quaternion (n, 4) w x y z, q dq tauEst
(n, 12) in SDK order, footForce footForceEst (n, 4): as the controller got them. truth_p (n, 3) and
truth_v (n, 3) of the base's origin, truth_quaternion (n, 4) w x y z, truth_com (n, 3), all in the
world; truth_q truth_dq (n, 12); truth_foot_forces (n, 12) ground on foot x y z, FR FL RR RL;
truth_contact (n, 4): the truth of the instant in which the report was read. truth_gyro_bias and
truth_accelerometer_bias (3,) in base axes, push_times (k,) [s] since the log's first row,
weight () [N] of the model, fell ().
"""

_SENSORS = ("accelerometer", "gyroscope", "quaternion", "footForce", "footForceEst")
_MOTORS = ("q", "dq", "tauEst")
SINGLE = ("truth_gyro_bias", "truth_accelerometer_bias", "push_times", "weight", "fell")


@dataclass(frozen=True)
class Recording:
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


def record(recording: Recording) -> Log:
    """Run the robot under its controller and return what it sensed and what was true."""
    plant = Plant(recording.robot, recording.plant)
    if not plant.settings.real:
        raise ValueError("sensors: got 'ideal', expected 'real'")
    for push in [request.resolve(plant) for request in recording.pushes]:
        plant.add_push(push)
    for lift in recording.lifts:
        plant.add_lift(lift)
    rows = _Rows(round(recording.duration * plant.settings.control_rate))
    state = plant.reset()
    control = _control(recording, plant)
    for k in range(rows.size):
        command = control(k, state)
        # step() hands out the reading of this instant and keeps that of the next for later.
        truth = _truth(plant)
        state = plant.step(command)
        rows.add(state.raw, truth)
        if plant.truth.fell:
            break
    return {**rows.log(), **_head(recording, plant)}


def _control(recording: Recording, plant: Plant) -> Callable[[int, LowState], LowCmd]:
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


def _head(recording: Recording, plant: Plant) -> Log:
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


class _Rows:
    """Rows that fill up.

    Args:
        size: How many there may be.
    """

    def __init__(self, size: int) -> None:
        self.size = size
        self._frames = np.zeros((size, LOW_STATE.itemsize), np.uint8)
        self._truth: dict[str, list[Array]] = {}
        self._count = 0

    def add(self, frame: Array, truth: Log) -> None:
        self._frames[self._count] = frame
        for name, value in truth.items():
            self._truth.setdefault(name, []).append(value)
        self._count += 1

    def log(self) -> Log:
        """Return all rows so far by name, in single precision what a LowState has so."""
        frames = self._frames[: self._count].view(LOW_STATE)[:, 0]
        log = {name: frames[name].copy() for name in (*_SENSORS, "tick")}
        for name in _MOTORS:
            log[name] = frames["motorState"][name][:, :MOTORS].copy()
        truth = {name: np.array(rows) for name, rows in self._truth.items()}
        return {**log, **truth}


def cut(log: Log, rows: slice | Array) -> Log:
    """Return a log of some rows only."""
    return {name: array if name in SINGLE else array[rows] for name, array in log.items()}


def rate_of(log: Log) -> float:
    """Return reports per second [Hz]."""
    return 1000.0 / float(log["tick"][1] - log["tick"][0])
