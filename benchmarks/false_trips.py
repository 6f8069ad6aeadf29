# SPDX-License-Identifier: BSD-3-Clause
"""How often the supervisor trips over nothing: hours of healthy running, every fault counted.

    python benchmarks/false_trips.py --robot go1 --hours 10 --jobs 2 --json FILE

Each run gets up from lying, stands for a minute while its body is asked to move and pushed, and
sits down, on ground, with a payload and with motors drawn from its seed. None of that is a fault:
a fault that is reacted to (sit or damp) is a false trip, and so is a fall. One that gives its rise
up, lying down again, has not tripped, and is told apart. tests/closed_loop has a short form.
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
from surefoot.cli.environment import write_json
from surefoot.robot.power_level import power_level
from surefoot.sim import Plant, PlantSettings, Push

STAND_TIME = 60.0  # [s]
MAX_TRANSITION_TIME = 60.0  # [s] to get up, legs freed first, and to lie down
CHECK_TICKS = 10  # ticks between looks at what lasts: counts and falls
DISTURBANCE_PERIOD = 5.0  # [s] between pushes, and between what the body is asked for
PUSH_SHARE = 0.1, 0.4  # of the pendulum's limit
MAX_PAYLOAD_SHARE = 0.3  # of the robot's mass, at most
MAX_SLOPE = 8.0  # [deg] at most
TRIP_REACTIONS = FaultReaction.SIT, FaultReaction.DAMP


@dataclass
class HealthyRun(RunOutcome):
    """What came of one run; why: what was reacted to, or why else it did not stand to the end."""

    seed: int
    seconds: float  # simulated
    ended: bool  # it stood its time and lay down, or tripped
    faults: dict[str, int]  # how often each began


def main() -> int:
    """Run until the hours are over, print, write JSON; 3 if anything tripped or did not end."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robot", default="go1", choices=ROBOTS)
    parser.add_argument("--hours", type=positive_hours, default=10.0, help="simulated (10)")
    add_seed_options(parser)
    options = parser.parse_args()
    count = math.ceil(3600.0 * options.hours / (STAND_TIME + 10.0))
    jobs: list[Job] = [(options.robot, options.first + k) for k in range(count)]
    result = summary(options.robot, run_seeds(run_healthy, HealthyRun, jobs, options))
    print(text(result))
    write_json(options.json, result, 1)
    return 3 if result["trips"] or result["unfinished"] else 0


def positive_hours(text: str) -> float:
    """Return the hours that an option's text is."""
    value = float(text)
    if not 0.0 < value < 1e5:
        raise argparse.ArgumentTypeError(f"got {value:g}, expected hours, above 0")
    return value


def run_healthy(job: Job, standing: float = STAND_TIME) -> HealthyRun:
    """Run one seed: get up, stand for a time [s], be pushed and moved, sit down."""
    robot, seed = str(job[0]), int(job[1])
    rng = np.random.default_rng([seed, 12])
    plant = Plant(robot, random_settings(robot, seed, rng))
    state = plant.reset_lying(rng)
    options = surefoot.SupervisorOptions(power_level=power_level(robot))
    supervisor = surefoot.Supervisor(plant.robot, options=options)
    why, ended = "", True
    stand_time, last_disturbance, requests = 0.0, 0.0, {Mode.PASSIVE: Mode.RISE}
    counts_at_arming: dict[str, int] = {}  # it was armed
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
    """Return how often each fault began."""
    faults = supervisor.faults
    return {info.name: faults.count(info.id) for info in surefoot.fault_table()}


def trip_reason(
    plant: Plant,
    supervisor: surefoot.Supervisor,
    counts_at_arming: dict[str, int],
    sitting_requested: bool,
) -> str:
    """Return what the supervisor reacted to since it was armed, or ""."""
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
        return f"{plant.time:.1f} s: sits for a leg that is stuck"
    if supervisor.mode == Mode.STAND and plant.truth.fell:
        return f"{plant.time:.1f} s: fell"
    return ""


def random_settings(robot: str, seed: int, rng: np.random.Generator) -> PlantSettings:
    """Draw ground, payload and motors."""
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
    """Push the robot, and ask its body for another pose."""
    degrees = float(rng.uniform(-180.0, 180.0))
    impulse = float(rng.uniform(*PUSH_SHARE)) * plant.lip_push_limit(degrees)
    plant.add_push(Push(degrees, impulse, time=plant.time + 2.0))
    x, y, height = rng.uniform([-0.02, -0.02, -0.04], [0.02, 0.02, 0.01])
    roll, pitch, yaw = np.radians(rng.uniform(-6.0, 6.0, 3))
    supervisor.set_body_reference(BodyReference(x, y, height, roll, pitch, yaw))


def summary(robot: str, runs: list[HealthyRun]) -> dict[str, object]:
    """Return the numbers of all runs."""
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
    """Return the numbers as a few lines."""
    trips, unfinished, faults = result["trips"], result["unfinished"], result["faults"]
    assert isinstance(trips, dict) and isinstance(unfinished, dict) and isinstance(faults, dict)
    seen = ", ".join(f"{name} {count}" for name, count in faults.items() if count) or "none"
    return (
        f"{result['robot']}: {result['runs']} runs, {result['hours']:.2f} simulated hours, "
        f"{len(trips)} false trips, {len(unfinished)} did not end\n  faults told: {seen}"
    )


if __name__ == "__main__":
    sys.exit(main())
