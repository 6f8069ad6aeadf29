"""Simulation loop of a walk: passes LowStates and velocities to the controller.

The loop logs the true state, the estimates and the commands of every tick.
"""

from __future__ import annotations

import copy
from time import thread_time_ns
from typing import Any

import numpy as np

from surefoot._core import WalkController, WalkVelocity
from surefoot.sim import Plant, Truth
from surefoot.sim.lost_frames import lost_frames
from surefoot.stand.log_recorder import LogRecorder, log_header
from surefoot.stand.reference_request import body_references
from surefoot.stand.simulation_loop import Progress, make_plant
from surefoot.walk.settings import WalkSettings
from surefoot.walk.slip import slip_velocities
from surefoot.walk.velocity_request import velocity_ticks
from surefoot.walk.walk_log import WalkLog

_ARRAYS: dict[str, tuple[tuple[int, ...], type]] = {
    "com_velocity": ((3,), float),
    "slip_velocity": ((3, 4), float),
    "leg_contacts": ((), int),
    "body_reference": ((3,), float),
    "commanded": ((3,), float),
    "reference": ((3,), float),
    "limit": ((), int),
    "walking": ((), bool),
    "friction": ((), float),
    "planned_loads": ((4,), float),
    "footholds": ((3, 4), float),
}


def run_walk(settings: WalkSettings, progress: Progress | None = None) -> WalkLog:
    """Simulate a walking robot for settings.duration, or until the robot falls.

    The controller receives only LowStates, the commanded velocities and the model of its robot.

    Args:
        settings: Settings of the run.
        progress: Function that is called after every tick.

    Raises:
        Error: The robot is unknown, or a gain, an option or a push is out of range. The error is
            raised before the first tick.
    """
    return simulate_walk(make_plant(settings), settings, progress)


def simulate_walk(
    plant: Plant, settings: WalkSettings, progress: Progress | None = None
) -> WalkLog:
    """Simulate a walk on a plant that exists; repeated runs on one plant give equal logs.

    Args:
        plant: Result of make_plant(settings). The function resets the plant first.
        settings: Settings of the run; its gains may differ from those of an earlier run.
        progress: Function that is called after every tick.

    Raises:
        Error: A gain or an option is out of range.
    """
    state = plant.reset()
    gains = settings.gains or plant.robot.config.gains
    controller = WalkController(plant.robot, gains, settings.walk_options)
    controller.gait = settings.gait
    ticks = velocity_ticks(settings.velocities, settings.plant.control_rate)
    velocities = {k: request.velocity for k, request in ticks}
    references = body_references(settings.references, settings.plant.control_rate)
    header = log_header(settings, plant)
    recorder = LogRecorder(settings.ticks, plant.robot.nq, plant.robot.nv, _ARRAYS)
    lost = lost_frames(settings.lost_frames, settings.plant.seed, settings.ticks)
    velocity, received, applied = WalkVelocity(), state, None
    truth = plant.truth
    touching: frozenset[tuple[str, str]] = frozenset()
    for k in range(settings.ticks):
        velocity = velocities.get(k, velocity)
        if k in references:
            controller.set_body_reference(references[k])
        controller.set_velocity(velocity)  # in every tick: a velocity times out
        received = received if lost[0, k] else state
        start = thread_time_ns()
        command = controller.update(received)
        tick_us = (thread_time_ns() - start) / 1000.0
        before, touching = touching, plant.leg_contacts
        row = _walk_row(plant, truth, controller)
        row["leg_contacts"] = len(touching - before)
        applied = applied if lost[1, k] and applied is not None else copy.copy(command)
        recorder.record(truth, controller, applied, tick_us, row)
        state = plant.step(applied)
        truth = plant.truth
        if progress is not None:
            progress("walk", k + 1, settings.ticks)
        if truth.fell:
            break
    return WalkLog(
        **header,
        mass=float(plant.model.body_subtreemass[plant.handles.root]),
        ground_normal=plant.handles.ground_normal,
        fell=truth.fell,
        **recorder.arrays(),
    )


def _walk_row(plant: Plant, truth: Truth, controller: WalkController) -> dict[str, Any]:
    body = controller.body_reference
    return {
        "com_velocity": truth.com_velocity,
        "body_reference": (body.height, body.roll, body.pitch),
        "slip_velocity": slip_velocities(plant),
        "commanded": _as_array(controller.commanded_velocity),
        "reference": _as_array(controller.reference_velocity),
        "limit": controller.velocity_limit.value,
        "walking": controller.walking,
        "friction": controller.estimator_report.friction,
        "planned_loads": controller.planned_loads,
        "footholds": controller.footholds,
    }


def _as_array(velocity: WalkVelocity) -> np.ndarray:
    return np.array([velocity.vx, velocity.vy, velocity.yaw_rate])
