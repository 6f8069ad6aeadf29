"""Settings of a fault matrix."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from surefoot._core import Error
from surefoot.robot.description import RobotDescription, describe_robot
from surefoot.robot.loading import build_robot, robot_identity

MAX_JOBS = 256  # sanity limit of the number of processes


@dataclass(frozen=True)
class FaultSettings:
    """Settings of a fault matrix: robot, cells and processes.

    Attributes:
        robot: A name of surefoot.available_robots(), or a description from describe_robot().
        seed: Seed of sensors, motors and the lying pose.
        jobs: Number of processes; 1: all cells run in this process.
        only: Patterns of cells (see catalogue.choose_cells); empty: all cells.
        store: File that keeps the result of every cell, so that a run can be resumed; None: no
            file.
        taken_over: True: the supervisor starts with a standing robot and without arming checks.
            Only the cells whose property can_start_standing is True run.
    """

    robot: str | RobotDescription = "go1"
    seed: int = 0
    jobs: int = 1
    only: tuple[str, ...] = ()
    store: str | None = None
    taken_over: bool = False

    def __post_init__(self) -> None:
        if not 1 <= self.jobs <= MAX_JOBS:
            raise Error(f"jobs: got {self.jobs}, expected 1 to {MAX_JOBS}")
        if self.seed < 0:
            raise Error(f"seed: got {self.seed}, expected a whole number from 0 up")

    @property
    def description(self) -> RobotDescription:
        """Description of the robot.

        Raises:
            Error: The robot is unknown.
        """
        return describe_robot(self.robot) if isinstance(self.robot, str) else self.robot

    def identity_values(self) -> dict[str, Any]:
        """Return the JSON values that identify a matrix; equal values give equal results.

        Raises:
            Error: The robot is unknown or invalid.
        """
        robot = build_robot(self.description)
        requested = {"seed": self.seed, "taken_over": self.taken_over}
        return {**robot_identity(self.description, robot), **requested}
