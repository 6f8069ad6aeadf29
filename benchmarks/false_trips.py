# SPDX-License-Identifier: BSD-3-Clause
"""False trips: count all faults in hours of a healthy robot under its supervisor.

    python benchmarks/false_trips.py --robot go1 --hours 10 --jobs 2 --json FILE

In each run the robot gets up, stands for a minute with pushes and changes of its body reference,
and sits down. The seed draws ground, payload and motors. The robot has no fault, so every reaction
(sit or damp) is a false trip. A fall also counts as a false trip. A robot that gives up its rise
and lies down again is counted separately. tests/closed_loop has a short form of this benchmark;
walk_endurance.py has robots that walk.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections import Counter
from dataclasses import dataclass

import numpy as np
import surefoot
from seed_runs import ROBOTS, Job, RunOutcome, add_seed_options, run_seeds
from surefoot import BodyReference, FaultReaction, Mode
from surefoot.cli.output_files import write_json
from surefoot.robot.power_level import power_level
from surefoot.sim import Plant, PlantSettings, Push

STAND_TIME = 60.0  # [s] duration of standing in each run
MAX_TRANSITION_TIME = 60.0  # [s] longest time to get up (with leg interference), or to lie down
CHECK_TICKS = 10  # [ticks] interval of the checks of fault counts and falls
DISTURBANCE_PERIOD = 5.0  # [s] time between two pushes, and between two body references
PUSH_SHARE = 0.1, 0.4  # range of the impulse as a share of the LIP push limit
MAX_PAYLOAD_SHARE = 0.3  # largest payload as a share of the robot's mass
MAX_SLOPE = 8.0  # [deg] largest slope of the ground
TRIP_REACTIONS = FaultReaction.SIT, FaultReaction.DAMP


@dataclass
class HealthyRun(RunOutcome):
    """Result of one run; `why` names the fault with a reaction, or why the run did not end well."""

    seed: int
    seconds: float  # simulated time [s]
    ended: bool  # true if the robot stood for the whole time and lay down, or tripped
    faults: dict[str, int]  # number of times that each fault began


def main() -> int:
    """Run the requested hours, print and write JSON; return 3 if a run tripped or did not end."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robot", default="go1", choices=ROBOTS)
    parser.add_argument("--hours", type=positive_hours, default=10.0, help="simulated hours (10)")
    add_seed_options(parser)
    options = parser.parse_args()
    count = math.ceil(3600.0 * options.hours / (STAND_TIME + 10.0))
    jobs: list[Job] = [(options.robot, options.first + k) for k in range(count)]
    result = summary(options.robot, run_seeds(run_healthy, HealthyRun, jobs, options))
    print(text(result))
    write_json(options.json, result, 1)
    return 3 if result["trips"] or result["unfinished"] else 0


def positive_hours(text: str) -> float:
    """Parse an option as a positive number of hours; raise ArgumentTypeError for other text."""
    value = float(text)
    if not 0.0 < value < 1e5:
        raise argparse.ArgumentTypeError(f"got {value:g}, expected a number > 0 and < 1e5")
    return value


def run_healthy(job: Job, standing: float = STAND_TIME) -> HealthyRun:
    """Run one seed: get up, stand for a time [s] with disturbances, sit down.

    Args:
        job: Robot, seed.
        standing: Time [s] of standing.
    """
    robot, seed = str(job[0]), int(job[1])
    rng = np.random.default_rng([seed, 12])
    plant = Plant(robot, random_settings(robot, seed, rng))
    state = plant.reset_lying(rng)
    options = surefoot.SupervisorOptions(power_level=power_level(robot))
    supervisor = surefoot.Supervisor(plant.robot, options=options)
    why, ended = "", True
    stand_time = 0.0
    last_disturbance = 0.0
    requests = {Mode.PASSIVE: Mode.RISE}
    counts_at_arming: dict[str, int] = {}  # fault counts when the robot was last armed
    for tick in range(round((standing + MAX_TRANSITION_TIME) / 0.002)):
        if not supervisor.armed:
            counts_at_arming = fault_counts(supervisor)
            supervisor.arm()
        elif supervisor.mode in requests:
            supervisor.request(requests[supervisor.mode])
        if supervisor.mode == Mode.STAND:
            stand_time += 0.002
            if stand_time - last_disturbance > DISTURBANCE_PERIOD:
                last_disturbance = stand_time
                disturb(plant, supervisor, rng)
            if stand_time > standing:
                requests = {Mode.STAND: Mode.SIT}
        elif stand_time > standing and supervisor.mode == Mode.PASSIVE:
            break
        state = plant.step(supervisor.update(state))
        if tick % CHECK_TICKS == 0:
            why = trip_reason(plant, supervisor, counts_at_arming, stand_time > standing)
        if why:
            break
    else:
        ended = False
        why = f"did not end: {supervisor.mode.name}, {supervisor.arming.failures(plant.robot)}"
    return HealthyRun(not why, why, seed, round(plant.time, 3), ended, fault_counts(supervisor))


def fault_counts(supervisor: surefoot.Supervisor) -> dict[str, int]:
    """Return the number of times that each fault began."""
    faults = supervisor.faults
    return {info.name: faults.count(info.id) for info in surefoot.fault_table()}


def trip_reason(
    plant: Plant,
    supervisor: surefoot.Supervisor,
    counts_at_arming: dict[str, int],
    sitting_requested: bool,
) -> str:
    """Return the fault to which the supervisor reacted since arming, a fall, or "" for no trip."""
    if supervisor.mode == Mode.DAMPING:
        return f"{plant.time:.1f} s: damping for {supervisor.damping_fault.name}"
    counts = fault_counts(supervisor)
    names = [
        info.name
        for info in surefoot.fault_table()
        if info.reaction in TRIP_REACTIONS and counts[info.name] > counts_at_arming[info.name]
    ]
    if names:
        return f"{plant.time:.1f} s: {supervisor.mode.name} after {', '.join(names)}"
    if supervisor.mode == Mode.SIT and not sitting_requested:
        return f"{plant.time:.1f} s: sits because a leg is blocked"
    if supervisor.mode == Mode.STAND and plant.truth.fell:
        return f"{plant.time:.1f} s: fell"
    return ""


def random_settings(robot: str, seed: int, rng: np.random.Generator) -> PlantSettings:
    """Draw the settings of ground, payload and motors."""
    mass = surefoot.load_robot(robot).mass
    x, y = (0.03 * rng.uniform(-1.0, 1.0, 2)).tolist()
    return PlantSettings(
        seed=seed,
        physics_dt=0.001,
        friction=float(rng.uniform(0.5, 1.0)),
        slope_deg=float(rng.uniform(0.0, MAX_SLOPE)),
        slope_heading_deg=float(rng.uniform(-180.0, 180.0)),
        payload_kg=float(MAX_PAYLOAD_SHARE * mass * rng.uniform()),
        payload_position=(x, y, 0.05),
        motor_lag=float(rng.uniform(0.001, 0.004)),
        extra_delay=0.001 * int(rng.integers(5)),
        joint_friction_scale=float(rng.uniform(0.5, 2.0)),
        foot_force=str(rng.choice(["est", "raw", "dead"])),
    )


def disturb(plant: Plant, supervisor: surefoot.Supervisor, rng: np.random.Generator) -> None:
    """Push the robot, and set a random body reference."""
    degrees = float(rng.uniform(-180.0, 180.0))
    impulse = float(rng.uniform(*PUSH_SHARE)) * plant.lip_push_limit(degrees)
    plant.add_push(Push(degrees, impulse, time=plant.time + 2.0))
    x, y, height = rng.uniform([-0.02, -0.02, -0.04], [0.02, 0.02, 0.01])
    roll, pitch, yaw = np.radians(rng.uniform(-6.0, 6.0, 3))
    supervisor.set_body_reference(BodyReference(x, y, height, roll, pitch, yaw))


def summary(robot: str, runs: list[HealthyRun]) -> dict[str, object]:
    """Return the figures of all runs."""
    faults: Counter[str] = sum((Counter(run.faults) for run in runs), Counter())
    failed = {run.seed: run.why for run in runs if not run.ok}
    unfinished = {run.seed: run.why for run in runs if not run.ended}
    simulated = sum(run.seconds for run in runs) / 3600.0
    return {
        "robot": robot,
        "runs": len(runs),
        "hours": simulated,
        "trips": {seed: why for seed, why in failed.items() if seed not in unfinished},
        "unfinished": unfinished,
        "faults": {info.name: faults[info.name] for info in surefoot.fault_table()},
    }


def text(result: dict[str, object]) -> str:
    """Return the figures as a few lines of text."""
    trips, unfinished, faults = result["trips"], result["unfinished"], result["faults"]
    assert isinstance(trips, dict) and isinstance(unfinished, dict) and isinstance(faults, dict)
    seen = ", ".join(f"{name} {count}" for name, count in faults.items() if count) or "none"
    return (
        f"{result['robot']}: {result['runs']} runs, {result['hours']:.2f} simulated hours, "
        f"{len(trips)} false trips, {len(unfinished)} did not end\n  faults that began: {seen}"
    )


if __name__ == "__main__":
    sys.exit(main())
