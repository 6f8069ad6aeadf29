"""Unit of work that runs one cell of the fault matrix."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, ClassVar

from surefoot._core import Robot, Supervisor, SupervisorOptions
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.robot_source import RobotSource, describe_source
from surefoot.assess.work_units import Heartbeat
from surefoot.faults.matrix.matrix_setup import MatrixSetup, make_setup
from surefoot.faults.matrix.run_matrix import run_or_error_result
from surefoot.robot.gain_files import gains_from_values


@dataclass(frozen=True)
class FaultUnit:
    """A cell of the fault matrix.

    Attributes:
        cell: Id of the cell.
    """

    cell: str
    # Chosen: the robot of a cell first gets up, and the whole cell sends only one heartbeat.
    deadline_factor: ClassVar[float] = 20.0

    @property
    def key(self) -> str:
        """Key of the unit in the store."""
        return f"fault | {self.cell}"

    def run(
        self, source: RobotSource, controller_under_test: ControllerUnderTest, heartbeat: Heartbeat
    ) -> dict[str, Any]:
        """Run the cell; return its row, its verdict and the verdict's reason as JSON values."""
        setup = _setup(source)
        if controller_under_test.gains:
            setup = replace(setup, make_supervisor=_supervisor_factory(controller_under_test.gains))
        heartbeat()
        cell_result = run_or_error_result(setup, self.cell)
        return {name: cell_result[name] for name in ("row", "verdict", "reason")}


def _supervisor_factory(
    values: dict[str, float],
) -> Callable[[Robot, SupervisorOptions], Supervisor]:
    gains = gains_from_values(values)
    return lambda robot, options: Supervisor(robot, gains, options)


@lru_cache(maxsize=1)
def _setup(source: RobotSource) -> MatrixSetup:
    return make_setup(describe_source(source), 0)
