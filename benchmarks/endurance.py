# SPDX-License-Identifier: BSD-3-Clause
"""Endurance test: quiet standing for a day, with checks of drift, memory, faults and tick wrap.

    python benchmarks/endurance.py --robot go1 --hours 24 --json FILE

A Supervisor controls a standing robot with real sensors and receives no requests. LowState.tick
wraps at 2^32 ms in the middle of the run. Every tick must have the fallback level SOLVED, and no
fault may begin. Every 0.1 s the true pose is compared with the true pose after 10 s. Every minute
the memory of this process is compared with the memory after 10 s. LIMITS has the allowed
differences. Heap allocations are not counted, because every command allocates in Python; the C++
test surefoot_allocations counts the allocations of a tick.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
import surefoot
from seed_runs import ROBOTS
from surefoot import FallbackLevel, Mode, Start, Status
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.robot.power_level import power_level
from surefoot.sim import Plant, PlantSettings

CONTROL_PERIOD = 0.002  # [s] time between two ticks
SETTLE_TIME = 10.0  # [s] time at which the reference pose and the reference memory are taken
# [ticks] Interval of the pose checks, interval of the memory checks, and number of ticks per hour.
DRIFT_TICKS, MEMORY_TICKS, HOUR_TICKS = 50, 30_000, 1_800_000
TICK_WRAP = 2**32  # [ms] value at which LowState.tick starts again from 0
# Allowed differences from the pose at SETTLE_TIME; positions are relative to the mean of the feet.
LIMITS = {
    "height_mm": 1.0,
    "tilt_deg": 0.2,
    "believed_tilt_deg": 0.7,  # tilt error of the estimate; 0.41 deg with the largest IMU bias
    "yaw_deg": 0.5,
    "foot_travel_mm": 5.0,
    "com_mm": 2.0,
    "memory_mb": 4.0,
}


def angle_deg(a: np.ndarray, b: np.ndarray) -> float:
    """Return the angle [deg] between two unit vectors (3,); NaN if one of them has NaN."""
    return math.degrees(math.acos(float(np.clip(a @ b, -1.0, 1.0))))


@dataclass(frozen=True)
class Pose:
    """True pose of a robot.

    Attributes:
        feet: (3, 4) foot centres in the world frame [m].
        height: Height of the base above the mean of the feet [m].
        R_world_base: (3, 3) attitude of the base.
        com: (3,) centre of mass relative to the mean of the feet, world axes [m].
    """

    feet: np.ndarray
    height: float
    R_world_base: np.ndarray
    com: np.ndarray

    @staticmethod
    def of(plant: Plant) -> Pose:
        """Return the true pose of a plant."""
        data, handles = plant.data, plant.handles
        feet = data.xpos[handles.foot_bodies].T.copy()
        feet_mean = feet.mean(axis=1)
        com = data.subtree_com[handles.root] - feet_mean
        R = matrix_from_wxyz(data.qpos[3:7])
        return Pose(feet, float(data.qpos[2] - feet_mean[2]), R, com)

    def drift(self, start: Pose) -> dict[str, float]:
        """Return the differences between this pose and `start`, by name as in LIMITS."""
        turned = self.R_world_base @ start.R_world_base.T
        return {
            "height_mm": 1e3 * abs(self.height - start.height),
            "tilt_deg": angle_deg(self.R_world_base[2], start.R_world_base[2]),
            "yaw_deg": abs(math.degrees(math.atan2(turned[1, 0], turned[0, 0]))),
            "foot_travel_mm": 1e3 * float(np.linalg.norm(self.feet - start.feet, axis=0).max()),
            "com_mm": 1e3 * float(np.linalg.norm(self.com - start.com)),
        }


@dataclass
class DriftMonitor:
    """Record of a run: largest and last drifts, bad ticks, and the memory [MB] every minute."""

    worst: dict[str, float] = field(default_factory=lambda: dict.fromkeys(LIMITS, 0.0))
    last: dict[str, float] = field(default_factory=dict)
    memory: list[float] = field(default_factory=list)
    memory_start: float = 0.0
    failed_ticks: int = 0
    fallback_ticks: int = 0
    wraps: int = 0
    end_reason: str = ""

    def record_drift(self, drift: dict[str, float]) -> None:
        """Record drifts by name."""
        self.last = {**self.last, **drift}
        for name, value in drift.items():
            self.worst[name] = float(np.maximum(self.worst[name], value))  # propagates NaN

    def record_memory(self) -> None:
        """Record the memory of this process."""
        self.memory.append(resident_mb())
        self.record_drift({"memory_mb": self.memory[-1] - self.memory_start})


def estimated_tilt_error(plant: Plant, supervisor: surefoot.Supervisor) -> float:
    """Return the angle [deg] between the estimated and the true vertical."""
    q = supervisor.controller.state.q
    estimated, true = np.roll(q[3:7], 1), plant.data.qpos[3:7]
    return angle_deg(matrix_from_wxyz(estimated)[2], matrix_from_wxyz(true)[2])


def resident_mb() -> float:
    """Return the resident memory of this process [MB]."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


Progress = Callable[[float, DriftMonitor], None]
"""Function that receives the simulated time [s] and the record so far."""


def run_endurance(
    robot: str, seconds: float, seed: int = 0, progress: Progress | None = None
) -> dict[str, Any]:
    """Let the robot stand for `seconds`; return the figures as JSON values.

    LowState.tick wraps in the middle of the run.
    """
    ticks = round(seconds / CONTROL_PERIOD)
    tick0 = (TICK_WRAP - round(500.0 * seconds)) % TICK_WRAP
    plant = Plant(robot, PlantSettings(seed=seed, physics_dt=0.001), tick0=tick0)
    options = surefoot.SupervisorOptions(power_level=power_level(robot), start=Start.STANDING)
    supervisor = surefoot.Supervisor(plant.robot, options=options)
    monitor, begin = DriftMonitor(), time.process_time()
    start, state, previous_tick = Pose.of(plant), plant.reset(), 0
    for k in range(ticks):
        tick = int(state.tick)
        monitor.wraps += tick < previous_tick
        previous_tick = tick
        state = plant.step(supervisor.update(state))
        monitor.failed_ticks += supervisor.controller.status != Status.OK
        monitor.fallback_ticks += supervisor.controller.fallback_level != FallbackLevel.SOLVED
        if k == round(SETTLE_TIME / CONTROL_PERIOD):
            start, monitor.memory_start = Pose.of(plant), resident_mb()
        elif k * CONTROL_PERIOD > SETTLE_TIME and k % DRIFT_TICKS == 0:
            monitor.record_drift(Pose.of(plant).drift(start))
            monitor.record_drift({"believed_tilt_deg": estimated_tilt_error(plant, supervisor)})
            if k % MEMORY_TICKS == 0:
                monitor.record_memory()
                if progress is not None:
                    progress(k * CONTROL_PERIOD, monitor)
        if supervisor.mode != Mode.STAND or (k % DRIFT_TICKS == 0 and plant.truth.fell):
            monitor.end_reason = (
                f"{plant.time:.1f} s: {supervisor.mode.name}, {supervisor.damping_fault.name}"
            )
            break
    monitor.record_memory()
    return summary(plant, supervisor, monitor, time.process_time() - begin)


def summary(
    plant: Plant, supervisor: surefoot.Supervisor, monitor: DriftMonitor, cpu: float
) -> dict[str, Any]:
    """Return the figures of a run; `failures` lists the checks that failed."""
    counts = {info.name: supervisor.faults.count(info.id) for info in surefoot.fault_table()}
    faults = {name: count for name, count in counts.items() if count}
    failures = [
        f"{name} {monitor.worst[name]:.3f}, at most {limit:g}"
        for name, limit in LIMITS.items()
        if not monitor.worst[name] <= limit
    ]
    failures += [f"fault {name} {count} times" for name, count in faults.items()]
    failures += [f"{monitor.failed_ticks} ticks failed"] * bool(monitor.failed_ticks)
    failures += [f"{monitor.fallback_ticks} ticks used a lower fallback level"] * bool(
        monitor.fallback_ticks
    )
    failures += [f"LowState.tick wrapped {monitor.wraps} times, expected once"] * (
        monitor.wraps != 1
    )
    failures += [monitor.end_reason] * bool(monitor.end_reason)
    per_hour = HOUR_TICKS // MEMORY_TICKS
    return {
        "robot": plant.robot.name,
        "hours": plant.time / 3600.0,
        "cpu_hours": cpu / 3600.0,
        "limits": LIMITS,
        "worst": monitor.worst,
        "last": monitor.last,
        "memory_mb": {
            "start": monitor.memory_start,
            "hour": monitor.memory[per_hour - 1] if len(monitor.memory) > per_hour else None,
            "end": monitor.memory[-1],
        },
        "wraps": monitor.wraps,
        "failed_ticks": monitor.failed_ticks,
        "other_rungs": monitor.fallback_ticks,
        "faults": faults,
        "failures": failures,
    }


def text(result: dict[str, Any]) -> str:
    """Return the figures as a few lines of text."""
    memory = result["memory_mb"]
    hour = "" if memory["hour"] is None else f", {memory['hour']:.1f} after an hour"
    drifts = ", ".join(
        f"{name} {value:.3f} ({result['limits'][name]:g})"
        for name, value in result["worst"].items()
    )
    return (
        f"{result['robot']}: {result['hours']:.2f} h in {result['cpu_hours']:.2f} h of CPU time, "
        f"{result['wraps']} wrap, {result['failed_ticks']} failed ticks, faults "
        f"{result['faults'] or 'none'}\n  worst (limit): {drifts}\n"
        f"  memory {memory['start']:.1f} MB at {SETTLE_TIME:g} s{hour}, "
        f"{memory['end']:.1f} at the end\n"
        f"  {'; '.join(result['failures']) or 'all within limits'}"
    )


def main() -> int:
    """Run the test, print the figures and write JSON; return 3 if a check failed, else 0."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robot", default="go1", choices=ROBOTS)
    parser.add_argument("--hours", type=float, default=24.0, help="simulated hours")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    if 3600.0 * options.hours <= SETTLE_TIME:
        parser.error(
            f"--hours: got {options.hours:g}, expected more than {SETTLE_TIME / 3600.0:.4f}"
        )

    def progress(seconds: float, monitor: DriftMonitor) -> None:
        every = 60.0 if sys.stderr.isatty() else 600.0
        if seconds % every < 1e-6:
            end = "\r" if sys.stderr.isatty() else "\n"
            worst = ", ".join(f"{name} {value:.3f}" for name, value in monitor.worst.items())
            print(f"{seconds / 3600.0:.2f} h: {worst}", end=end, file=sys.stderr)

    result = run_endurance(options.robot, 3600.0 * options.hours, options.seed, progress)
    print(text(result))
    if options.json:
        options.json.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 3 if result["failures"] else 0


if __name__ == "__main__":
    sys.exit(main())
