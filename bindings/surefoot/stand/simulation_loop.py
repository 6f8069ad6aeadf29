"""Simulation loop of a run: passes LowStates to the controller and LowCmds to the plant.

The loop logs the true state, the estimates and the commands of every tick.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from time import perf_counter_ns
from typing import Any

import numpy as np

from surefoot._core import LowCmd, PosStopF, StandController, VelStopF
from surefoot.sim import Plant, Push, Truth
from surefoot.stand.reference_request import body_references
from surefoot.stand.sensor_recorder import SensorRecorder
from surefoot.stand.settings import StandSettings
from surefoot.stand.stand_log import StandLog

MOTOR_COUNT = 12
SERVO = 0x0A

Progress = Callable[[str, int, int], None]
"""Function that receives the name of an activity, the steps done, and the total of its steps."""


def run_stand(
    settings: StandSettings,
    progress: Progress | None = None,
    sensors: SensorRecorder | None = None,
) -> StandLog:
    """Simulate a standing robot for settings.duration, or until the robot falls.

    The controller receives only LowStates and the model of its robot. Only the log and `sensors`
    receive the true state.

    Args:
        settings: Settings of the run.
        progress: Function that is called after every tick.
        sensors: Recorder that receives every LowState and the true state at its sampling time.

    Raises:
        Error: The robot is unknown, or a gain, an option or a push is out of range. The error is
            raised before the first tick.
    """
    plant = make_plant(settings)
    gains = settings.gains or plant.robot.config.gains
    controller = StandController(plant.robot, gains, settings.options)
    references = body_references(settings.references, settings.plant.control_rate)
    log_header = _log_header(settings, plant)
    recorder = _LogRecorder(settings.ticks, plant.robot.nq, plant.robot.nv)
    state = plant.reset()
    truth, sample_truth = plant.truth, plant.first_truth
    for k in range(settings.ticks):
        if sensors is not None:
            sensors.record(state, sample_truth)
        if k in references:
            controller.set_body_reference(references[k])
        start = perf_counter_ns()
        command = controller.update(state)
        elapsed = perf_counter_ns() - start
        recorder.record(truth, controller, command, elapsed / 1000.0)
        state = plant.step(command)
        # step() returns a sample that is one period old with real sensors. So the true state of
        # this sample is the state before the step.
        previous, truth = truth, plant.truth
        sample_truth = previous if plant.settings.real else truth
        if progress is not None:
            progress("stand", k + 1, settings.ticks)
        if truth.fell:
            break
    return StandLog(**log_header, fell=truth.fell, **recorder.arrays())


def make_plant(settings: StandSettings) -> Plant:
    """Build the plant of a run, with its pushes.

    Raises:
        Error: The robot is unknown, or a push is out of range.
    """
    plant = Plant(settings.robot, settings.plant)
    # Convert all pushes to N.s at once: the LIP push limit refers to the robot at rest.
    for push in [request.resolve(plant) for request in settings.pushes]:
        plant.add_push(push)
    return plant


def is_torque_mode(command: LowCmd) -> bool:
    """Return True if a command has all twelve motors in torque mode: no stiffness, no damping."""
    motors = (command.motorCmd[i] for i in range(MOTOR_COUNT))
    return all(
        motor.mode == SERVO
        and motor.Kp == 0.0
        and motor.Kd == 0.0
        and motor.q == PosStopF
        and motor.dq == VelStopF
        for motor in motors
    )


def _log_header(settings: StandSettings, plant: Plant) -> dict[str, Any]:
    """Return the fields of the log that are known before the run."""
    pushes = tuple(request.resolve(plant) for request in settings.pushes)
    return {
        "settings": settings,
        "robot": plant.robot,
        "foot_force": plant.settings.foot_force,
        "pushes": pushes,
        "push_shares": tuple(_lip_share(plant, push) for push in pushes),
        "lip_limit": {name: plant.lip_push_limit(name) for name in ("lateral", "forward")},
    }


def _lip_share(plant: Plant, push: Push) -> float:
    limit = plant.lip_push_limit(push.direction, push.duration)
    return push.impulse / limit if limit > 0.0 else math.inf


class _LogRecorder:
    """Arrays of the log; record() fills one row of each array per tick.

    Args:
        ticks: Number of rows to allocate.
        nq: Size of q.
        nv: Size of v.
    """

    def __init__(self, ticks: int, nq: int, nv: int) -> None:
        shapes: dict[str, tuple[int, ...]] = {
            **{"time": (), "tick_us": ()},
            **{"q_true": (nq,), "v_true": (nv,), "q_estimated": (nq,), "v_estimated": (nv,)},
            **{"feet": (3, 4), "forces": (3, 4), "com": (3,), "contact": (4,)},
            **{"tau": (MOTOR_COUNT,), "dq": (MOTOR_COUNT,)},
        }
        self._rows: dict[str, np.ndarray] = {k: np.zeros((ticks, *s)) for k, s in shapes.items()}
        self._rows["status"] = np.zeros(ticks, dtype=np.int64)
        self._rows["fallback_level"] = np.zeros(ticks, dtype=np.int64)
        self._rows["iterations"] = np.zeros(ticks, dtype=np.int64)
        self._rows["reach"] = np.zeros(ticks, dtype=np.int64)
        self._rows["reach_motor"] = np.zeros(ticks, dtype=np.int64)
        self._rows["torque_mode"] = np.zeros(ticks, dtype=np.bool_)
        self._rows["commands"] = np.zeros((ticks, len(LowCmd().raw)), dtype=np.uint8)
        self._count = 0

    def record(
        self, truth: Truth, controller: StandController, command: LowCmd, tick_us: float
    ) -> None:
        """Append the values of one tick as a row."""
        rows, k = self._rows, self._count
        estimate, reach = controller.state, controller.reach
        rows["time"][k], rows["tick_us"][k] = truth.time, tick_us
        rows["q_true"][k], rows["v_true"][k] = truth.q, truth.v
        rows["feet"][k], rows["forces"][k] = truth.p_world_feet, truth.foot_forces
        rows["com"][k], rows["tau"][k], rows["dq"][k] = truth.com, truth.tau, truth.dq
        rows["q_estimated"][k], rows["v_estimated"][k] = estimate.q, estimate.v
        rows["contact"][k] = estimate.contact
        rows["status"][k], rows["fallback_level"][k] = (
            controller.status.value,
            controller.fallback_level.value,
        )
        rows["iterations"][k] = controller.solution.iterations
        rows["reach"][k], rows["reach_motor"][k] = reach.limit.value, reach.motor
        rows["torque_mode"][k] = is_torque_mode(command)
        rows["commands"][k] = command.raw
        self._count += 1

    def arrays(self) -> dict[str, Any]:
        """Return the recorded rows of every array, by the array's name."""
        return {name: rows[: self._count] for name, rows in self._rows.items()}
