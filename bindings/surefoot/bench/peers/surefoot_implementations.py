"""Implementations of a comparison: each computes ticks of the recording on request."""

from __future__ import annotations

from time import perf_counter_ns, thread_time_ns
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from surefoot._core import LowState, StandController, WholeBodyController, is_usable
from surefoot.bench.peers.problem import Problem

# Columns of Ticks. FORCES is the first column of the forces, TORQUES the first of the torques.
WALL, CPU, SOLVED, FORCES = 0, 1, 2, 3
TORQUES = FORCES + 12
Ticks = NDArray[np.float64]
"""One row per tick: wall time [ns], CPU time [ns], solved, forces (12) [N], torques [N.m]."""


def tick_width(problem: Problem) -> int:
    """Return the number of values per row of Ticks."""
    return TORQUES + problem.robot.nv - 6


class Implementation(Protocol):
    """Interface of an implementation that is timed in turns with other implementations."""

    def run_ticks(self, first: int, count: int) -> Ticks:
        """Compute the ticks first .. first + count - 1; raise PeerError on failure."""
        ...

    def close(self) -> None:
        """Release the resources of the implementation."""
        ...


class StateToTorque:
    """Surefoot from RobotState to torques: WholeBodyController.update()."""

    def __init__(self, problem: Problem) -> None:
        self._controller = WholeBodyController(problem.point_robot)
        self._inputs = list(zip(problem.states(), problem.references(), strict=True))

    def run_ticks(self, first: int, count: int) -> Ticks:
        """See Implementation."""
        update, rows = self._controller.update, []
        for state, reference in self._inputs[first : first + count]:
            cpu = thread_time_ns()
            wall = perf_counter_ns()
            solution = update(state, reference)
            wall = perf_counter_ns() - wall
            cpu = thread_time_ns() - cpu
            forces = np.ravel(solution.forces, order="F")
            timing = [wall, cpu, float(is_usable(solution.status))]
            rows.append(np.concatenate([timing, forces, solution.torques]))
        return np.array(rows)

    def close(self) -> None:
        """See Implementation."""


class WholeTick:
    """Surefoot from LowState to LowCmd: StandController.update(), with estimator and limits."""

    def __init__(self, problem: Problem, low_states: list[LowState]) -> None:
        self._controller = StandController(problem.robot)
        self._width = tick_width(problem)
        self._low_states = low_states

    def run_ticks(self, first: int, count: int) -> Ticks:
        """See Implementation.

        Forces and torques stay zero: they cannot be compared with those of the peers, because the
        whole tick solves a larger problem.
        """
        if first == 0:
            self._controller.reset()  # otherwise the controller's clock would go backwards
        update = self._controller.update
        ticks = np.zeros((count, self._width))
        for row, low_state in zip(ticks, self._low_states[first : first + count], strict=True):
            cpu = thread_time_ns()
            wall = perf_counter_ns()
            update(low_state)
            wall = perf_counter_ns() - wall
            cpu = thread_time_ns() - cpu
            row[: SOLVED + 1] = wall, cpu, is_usable(self._controller.status)
        return ticks

    def close(self) -> None:
        """See Implementation."""
