"""Recording of the LowStates of a simulated run.

Simulation would disturb the timing of ticks, so the run is recorded first and timed later.
"""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import BodyReference, Gait, LowState, Robot, WalkVelocity
from surefoot.bench.problems import SCENARIOS
from surefoot.bench.settings import BenchSettings


@dataclass(frozen=True)
class Recording:
    """LowStates and requests of one simulated run.

    Attributes:
        scenario: A name in SCENARIOS.
        robot: Robot model of the controller.
        low_states: One LowState per tick, from the start until the end or the fall.
        period: Time between LowStates [s].
        fell: True if the run ended because the robot fell.
        references: Body reference of each tick; empty if the scenario sets none.
        velocities: Commanded velocity of each tick; empty if the robot only stands.
        gait: Gait of a robot that walks.
        walking_ticks: Number of ticks in which the controller planned steps.
    """

    scenario: str
    robot: Robot
    low_states: list[LowState]
    period: float
    fell: bool
    references: tuple[BodyReference, ...] = ()
    velocities: tuple[WalkVelocity, ...] = ()
    gait: Gait = Gait.AUTO
    walking_ticks: int = 0


def record(settings: BenchSettings, scenario: str = "push50") -> Recording:
    """Run a scenario in simulation and record every LowState.

    The controller of this run chooses the form of the QP by itself. So all forms are timed on the
    same LowStates.
    """
    definition = SCENARIOS[scenario]
    plant = definition.make_plant(settings.robot, settings.rate, settings.seed)
    robot = definition.controller_robot(plant.robot)
    controller = definition.make_controller(robot)
    low_state = plant.reset()
    low_states, references, velocities, walking_ticks = [], [], [], 0
    for tick in range(round(definition.duration * settings.rate)):
        time = tick / settings.rate
        # Append a copy, because the plant may reuse the memory of its LowState.
        low_states.append(LowState.from_bytes(low_state.to_bytes()))
        definition.apply_requests(controller, time)
        if definition.body_reference is not None:
            references.append(definition.body_reference(time))
        if definition.velocities:
            velocities.append(definition.velocity(time))
        low_state = plant.step(controller.update(low_state))
        walking_ticks += controller.reference.stepping
        if plant.truth.fell:
            break
    return Recording(
        scenario,
        robot,
        low_states,
        1.0 / settings.rate,
        plant.truth.fell,
        tuple(references),
        tuple(velocities),
        definition.gait,
        walking_ticks,
    )
