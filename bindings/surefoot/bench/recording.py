"""Recording of the LowStates of a simulated run.

Simulation would disturb the timing of ticks, so the run is recorded first and timed later.
"""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import BodyReference, LowState, Robot, StandController
from surefoot.bench.problems import SCENARIOS
from surefoot.bench.settings import BenchSettings


@dataclass(frozen=True)
class Recording:
    """LowStates and body references of one simulated run.

    Attributes:
        scenario: A name in SCENARIOS.
        robot: Robot model of the controller.
        low_states: One LowState per tick, from the start until the end or the fall.
        period: Time between LowStates [s].
        fell: True if the run ended because the robot fell.
        references: Body reference of each tick; empty if the scenario sets none.
    """

    scenario: str
    robot: Robot
    low_states: list[LowState]
    period: float
    fell: bool
    references: tuple[BodyReference, ...] = ()


def record(settings: BenchSettings, scenario: str = "push50") -> Recording:
    """Run a scenario in simulation and record every LowState.

    The controller of this run chooses the form of the QP by itself. So all forms are timed on the
    same LowStates.
    """
    definition = SCENARIOS[scenario]
    plant = definition.make_plant(settings.robot, settings.rate, settings.seed)
    robot = definition.controller_robot(plant.robot)
    controller = StandController(robot)
    low_state = plant.reset()
    low_states, references = [], []
    for tick in range(round(definition.duration * settings.rate)):
        # Append a copy, because the plant may reuse the memory of its LowState.
        low_states.append(LowState.from_bytes(low_state.to_bytes()))
        definition.apply_reference(controller, tick / settings.rate)
        if definition.body_reference is not None:
            references.append(definition.body_reference(tick / settings.rate))
        low_state = plant.step(controller.update(low_state))
        if plant.truth.fell:
            break
    period = 1.0 / settings.rate
    return Recording(scenario, robot, low_states, period, plant.truth.fell, tuple(references))
