"""What a matrix of faults is asked to be."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from surefoot._core import Error
from surefoot.robot.description import RobotDescription, describe_robot
from surefoot.robot.loading import build_robot, robot_identity

MAX_JOBS = 256


@dataclass(frozen=True)
class FaultSettings:
    """Robot, cells and processes.

    Attributes:
        robot: A name of surefoot.available_robots(), or what describe_robot() returns of files.
        seed: Of sensors, motors and the lying pose.
        jobs: Processes; 1 runs in this one.
        only: Patterns of cells (see catalogue.choose_cells); all if empty.
        store: File that keeps every cell when it is done; a run that ended goes on with it.
        taken_over: The supervisor finds the robot standing, and takes it over unchecked: cells that
            begin while it stands or is pushed, less those of faults that are there before.
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
        """The robot's files; raises Error."""
        return describe_robot(self.robot) if isinstance(self.robot, str) else self.robot

    def identity_values(self) -> dict[str, Any]:
        """Return as plain data what makes a cell of two runs the same; raises Error."""
        robot = build_robot(self.description)
        requested = {"seed": self.seed, "taken_over": self.taken_over}
        return {**robot_identity(self.description, robot), **requested}
