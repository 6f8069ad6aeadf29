"""Main loop of a worker: read the problem, compute ticks on request, return times and results.

A worker runs in the environment of the peer, without surefoot. Protocol: when the worker is ready,
it writes a line of JSON with its versions to standard output. Then it reads lines "play FIRST
COUNT" from standard input. For each tick it writes float64 values: wall time [ns], CPU time [ns],
solved (0 or 1), 12 forces on the feet FR FL RR RL (world axes) [N], and the joint torques
(Pinocchio's order) [N.m].
"""

from __future__ import annotations

import gc
import importlib.metadata
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from time import perf_counter_ns, thread_time_ns
from typing import Any

import numpy as np


class Problem:
    """Contents of the problem files; numbers as arrays, names as lists."""

    def __init__(self, file: Path) -> None:
        rows = [line.split() for line in file.read_text(encoding="utf-8").splitlines()]
        self._rows = {row[0]: row[1:] for row in rows}
        n, nq, nv = (int(word) for word in self._rows["size"])
        states = np.fromfile(file.parent / "states.bin").reshape(n, nq + nv + 7)
        self.q = [np.array(row[:nq]) for row in states]
        self.v = [np.array(row[nq : nq + nv]) for row in states]
        self.com = [np.array(row[nq + nv : nq + nv + 3]) for row in states]
        self.rotation = [rotation(*row[nq + nv + 3 :]) for row in states]
        self.nv = nv
        self.urdf = str(file.parent / "robot.urdf")

    def names(self, key: str) -> list[str]:
        """Return the words of the line `key`."""
        return self._rows[key]

    def array(self, key: str) -> Any:
        """Return the numbers of the line `key`, shape (n,)."""
        return np.array([float(word) for word in self._rows[key]])

    def check_joints(self, names: list[str]) -> None:
        """Raise ValueError unless the joints of the peer are in the order of the states."""
        if names != self.names("joints"):
            raise ValueError(f"joints: got {names}, expected {self.names('joints')}")

    def number(self, key: str) -> float:
        """Return the number of the line `key`, which has one value."""
        return float(self._rows[key][0])


def rotation(x: float, y: float, z: float, w: float) -> Any:
    """Return the rotation matrix of a unit quaternion, shape (3, 3)."""
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def serve(make: Callable[[Problem], Any], packages: list[str]) -> None:
    """Build the peer's solver and compute ticks until standard input ends.

    Args:
        make: Factory of the peer's object. load(k) sets state and target of tick k, tick() is
            timed, and read_result() returns solved, forces (12,) and torques (nv - 6,).
        packages: Names of the packages whose versions are written.
    """
    # Libraries may print: send their output to stderr, so that it does not mix with the replies.
    replies = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    problem = Problem(Path(sys.argv[1]))
    peer = make(problem)
    versions = {name: importlib.metadata.version(name) for name in packages}
    replies.write(json.dumps({"versions": versions}).encode() + b"\n")
    replies.flush()
    gc.disable()
    for line in sys.stdin:
        _, first, count = line.split()
        rows = [_play(peer, problem, k) for k in range(int(first), int(first) + int(count))]
        replies.write(np.array(rows, dtype="<f8").tobytes())
        replies.flush()


def _play(peer: Any, problem: Problem, k: int) -> Any:
    peer.load(k)
    tick = peer.tick
    cpu = thread_time_ns()
    wall = perf_counter_ns()
    tick()
    wall = perf_counter_ns() - wall
    cpu = thread_time_ns() - cpu
    solved, forces, torques = peer.read_result()
    return np.concatenate([[wall, cpu, solved], forces, torques])
