"""Simulation loop of a stand: passes LowStates to the controller and LowCmds to the plant.

The loop logs the true state, the estimates and the commands of every tick.
"""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter_ns

from surefoot._core import StandController
from surefoot.sim import Plant
from surefoot.stand.log_recorder import LogRecorder, log_header
from surefoot.stand.reference_request import body_references
from surefoot.stand.sensor_recorder import SensorRecorder
from surefoot.stand.settings import StandSettings
from surefoot.stand.simulation_settings import SimulationSettings
from surefoot.stand.stand_log import StandLog

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
    header = log_header(settings, plant)
    recorder = LogRecorder(settings.ticks, plant.robot.nq, plant.robot.nv)
    state = plant.reset()
    truth, sample_truth = plant.truth, plant.first_truth
    for k in range(settings.ticks):
        if sensors is not None:
            sensors.record(state, sample_truth)
        if k in references:
            controller.set_body_reference(references[k])
        start = perf_counter_ns()
        command = controller.update(state)
        tick_us = (perf_counter_ns() - start) / 1000.0
        recorder.record(truth, controller, command, tick_us)
        state = plant.step(command)
        # step() returns a sample that is one period old with real sensors. So the true state of
        # this sample is the state before the step.
        previous, truth = truth, plant.truth
        sample_truth = previous if plant.settings.real else truth
        if progress is not None:
            progress("stand", k + 1, settings.ticks)
        if truth.fell:
            break
    return StandLog(**header, fell=truth.fell, **recorder.arrays())


def make_plant(settings: SimulationSettings) -> Plant:
    """Build the plant of a run, with its pushes.

    Raises:
        Error: The robot is unknown, or a push is out of range.
    """
    plant = Plant(settings.robot, settings.plant)
    # Convert all pushes to N.s at once: the LIP push limit refers to the robot at rest.
    for push in [request.resolve(plant) for request in settings.pushes]:
        plant.add_push(push)
    return plant
