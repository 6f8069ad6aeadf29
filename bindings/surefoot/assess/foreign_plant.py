"""Section "foreign plant" of a scorecard: the same controller on the robot of an MJCF."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from surefoot._core import Robot
from surefoot.assess import plan
from surefoot.assess.condition import Condition
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.foreign_stance import plant_stance
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_score import push_section
from surefoot.assess.robot_source import MjcfSource, RobotSource, describe_source
from surefoot.assess.settings import AssessSettings
from surefoot.assess.stand_score import stand_section
from surefoot.assess.walking import walk_plan
from surefoot.assess.walking.walk_score import walk_section
from surefoot.assess.work_units import Heartbeat, WorkUnit
from surefoot.files.json_values import json_value
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.settings import COARSE_DT


@dataclass(frozen=True)
class ForeignUnit:
    """A unit of work that runs on the plant of an MJCF."""

    unit: WorkUnit
    mjcf: str
    # Chosen: MuJoCo takes longer for a model with many collision shapes.
    deadline_factor: ClassVar[float] = 4.0

    @property
    def key(self) -> str:
        """Key of the unit in the store."""
        return f"foreign plant | {self.unit.key}"

    def run(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, heartbeat: Heartbeat
    ) -> dict[str, Any]:
        """Run the unit and return its result as JSON values."""
        assert not isinstance(source, MjcfSource)  # AssessSettings.robot is none
        return self.unit.run(MjcfSource(source, self.mjcf), controller_under_test, heartbeat)


class ForeignPlant:
    """Plan and results of the section "foreign plant".

    The units are the pushes and the quiet stands of the nominal condition, or the walks and pushes
    of the nominal condition. Push limits are those of the MJCF's masses and friction.

    Args:
        settings: Settings of the assessment, with an MJCF.
        robot: The controller's robot.
        mjcf: Path of the MJCF.

    Raises:
        Error: The MJCF is invalid, or a part is missing or not supported.
    """

    def __init__(self, settings: AssessSettings, robot: Robot, mjcf: str) -> None:
        description = describe_source(MjcfSource(settings.robot, mjcf))
        plant = Plant(description, PlantSettings(physics_dt=COARSE_DT))
        self._mjcf = mjcf
        self._condition = Condition("MJCF", friction=plant.friction)
        card = replace(settings.card, conditions=(self._condition,), references=False)
        self._settings = replace(settings, card=card, mjcf=None)
        self._limits = PushLimits(robot, plant_stance(plant))

    def units(self) -> list[ForeignUnit]:
        """Return the units of work."""
        return [ForeignUnit(unit, self._mjcf) for unit in self._inner_units()]

    def section(self, unit_results: Mapping[str, dict[str, Any]]) -> dict[str, Any]:
        """Return the section as JSON values.

        Args:
            unit_results: Results of the units of the controller under test, by key.
        """
        stance = self._limits.stance
        results = {one.unit.key: unit_results[one.key] for one in self.units()}
        section: dict[str, Any] = json_value(
            {
                "mjcf": self._mjcf,
                "friction": self._condition.friction,
                "mass_kg": stance.mass,
                "com_height_m": stance.height,
                "reach_forward_m": stance.edge_distance(0.0),
                "reach_lateral_m": stance.edge_distance(90.0),
                **self._figures(results),
            }
        )
        return section

    def _inner_units(self) -> list[WorkUnit]:
        settings, limits = self._settings, self._limits
        if not settings.controller_under_test.walks:
            card = settings.stand_card
            stands = plan.stand_units(card, self._condition)
            return [*plan.reference_push_units(card, limits), *stands]
        walk = settings.walk_card
        units: list[WorkUnit] = []
        for velocity in walk.velocities:
            units += walk_plan.velocity_units(walk, velocity)
        for velocity in walk.push_velocities:
            units += walk_plan.push_units(walk, velocity, limits)
        return units

    def _figures(self, results: Mapping[str, dict[str, Any]]) -> dict[str, Any]:
        settings, limits = self._settings, self._limits
        if settings.controller_under_test.walks:
            return {"walk": walk_section(settings, limits, results)}
        card = settings.stand_card
        stands = plan.stand_units(card, self._condition)
        return {
            "push": push_section(plan.reference_push_units(card, limits), limits, results),
            "stand": stand_section(stands, results) if stands else None,
        }
