# SPDX-License-Identifier: BSD-3-Clause
"""How often the supervisor trips over nothing: hours of healthy running, every fault counted.

    python benchmarks/healthy_hours.py --robot go1 --hours 10 --jobs 2 --json FILE

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
from seed_runs import ROBOTS, Job, Outcome, add_seed_options, run_seeds
from surefoot import BodyReference, FaultReaction, Mode
from surefoot.cli.simulation import write_json
from surefoot.faults.joint_faults import power_level
from surefoot.sim import Plant, PlantSettings, Push

STANDING = 60.0  # [s]
PATIENCE = 60.0  # [s] to get up, legs freed first, and to lie down
LOOK = 10  # ticks between looks at what lasts: counts and falls
EVERY = 5.0  # [s] between pushes, and between what the body is asked for
SHARE = 0.1, 0.4  # of the pendulum's limit
PAYLOAD = 0.3  # of the robot's mass, at most
SLOPE = 8.0  # [deg] at most
REACTIONS = FaultReaction.SIT, FaultReaction.DAMP


@dataclass
class Run(Outcome):
    """What came of one run; why: what was reacted to, or why else it did not stand to the end."""

    seed: int
    seconds: float  # simulated
    ended: bool  # it stood its time and lay down, or tripped
    faults: dict[str, int]  # how often each began


def main() -> int:
    """Run until the hours are over, print, write JSON; 3 if anything tripped or did not end."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robot", default="go1", choices=ROBOTS)
    parser.add_argument("--hours", type=hours, default=10.0, help="simulated (10)")
    add_seed_options(parser)
    options = parser.parse_args()
    count = math.ceil(3600.0 * options.hours / (STANDING + 10.0))
    jobs: list[Job] = [(options.robot, options.first + k) for k in range(count)]
    result = summary(options.robot, run_seeds(healthy, Run, jobs, options))
    print(text(result))
    write_json(options.json, result, 1)
    return 3 if result["trips"] or result["unfinished"] else 0


def hours(text: str) -> float:
    """Return the hours that an option's text is."""
    value = float(text)
    if not 0.0 < value < 1e5:
        raise argparse.ArgumentTypeError(f"got {value:g}, expected hours, above 0")
    return value


def healthy(job: Job, standing: float = STANDING) -> Run:
    """Run one seed: get up, stand for a time [s], be pushed and moved, sit down."""
    robot, seed = str(job[0]), int(job[1])
    rng = np.random.default_rng([seed, 12])
    plant = Plant(robot, drawn(robot, seed, rng))
    state = plant.reset_lying(rng)
    options = surefoot.SupervisorOptions(power_level=power_level(robot))
    supervisor = surefoot.Supervisor(plant.robot, options=options)
    why, ended = "", True
    stood, moved, asked = 0.0, 0.0, {Mode.PASSIVE: Mode.RISE}
    before: dict[str, int] = {}  # it was armed
    for tick in range(round((standing + PATIENCE) / 0.002)):
        if not supervisor.armed:
            before = begun(supervisor)
            supervisor.arm()
        elif supervisor.mode in asked:
            supervisor.request(asked[supervisor.mode])
        if supervisor.mode == Mode.STAND:
            stood += 0.002
            if stood - moved > EVERY:
                moved = stood
                disturb(plant, supervisor, rng)
            if stood > standing:
                asked = {Mode.STAND: Mode.SIT}
        elif stood > standing and supervisor.mode == Mode.PASSIVE:
            break
        state = plant.step(supervisor.update(state))
        if tick % LOOK == 0:
            why = tripped(plant, supervisor, before, stood > standing)
        if why:
            break
    else:
        ended = False
        why = f"did not end: {supervisor.mode.name}, {supervisor.arming.failures(plant.robot)}"
    return Run(not why, why, seed, round(plant.time, 3), ended, begun(supervisor))


def begun(supervisor: surefoot.Supervisor) -> dict[str, int]:
    """Return how often each fault began."""
    faults = supervisor.faults
    return {info.name: faults.count(info.id) for info in surefoot.fault_table()}


def tripped(
    plant: Plant, supervisor: surefoot.Supervisor, before: dict[str, int], over: bool
) -> str:
    """Return what the supervisor reacted to since it was armed, or ""."""
    if supervisor.mode == Mode.DAMPING:
        return f"{plant.time:.1f} s: damping for {supervisor.reason.name}"
    now = begun(supervisor)
    names = [
        info.name
        for info in surefoot.fault_table()
        if info.reaction in REACTIONS and now[info.name] > before[info.name]
    ]
    if names:
        return f"{plant.time:.1f} s: {supervisor.mode.name} after {', '.join(names)}"
    if supervisor.mode == Mode.SIT and not over:
        return f"{plant.time:.1f} s: sits for a leg that is stuck"
    if supervisor.mode == Mode.STAND and plant.truth.fell:
        return f"{plant.time:.1f} s: fell"
    return ""


def drawn(robot: str, seed: int, rng: np.random.Generator) -> PlantSettings:
    """Draw ground, payload and motors."""
    mass = surefoot.load_robot(robot).mass
    x, y = (0.03 * rng.uniform(-1.0, 1.0, 2)).tolist()
    return PlantSettings(
        seed=seed,
        physics_dt=0.001,
        friction=float(rng.uniform(0.5, 1.0)),
        slope_deg=float(rng.uniform(0.0, SLOPE)),
        slope_heading_deg=float(rng.uniform(-180.0, 180.0)),
        payload_kg=float(PAYLOAD * mass * rng.uniform()),
        payload_position=(x, y, 0.05),
        motor_lag=float(rng.uniform(0.001, 0.004)),
        extra_delay=0.001 * int(rng.integers(5)),
        joint_friction_scale=float(rng.uniform(0.5, 2.0)),
        foot_force=str(rng.choice(["est", "raw", "dead"])),
    )


def disturb(plant: Plant, supervisor: surefoot.Supervisor, rng: np.random.Generator) -> None:
    """Push the robot, and ask its body for another pose."""
    degrees = float(rng.uniform(-180.0, 180.0))
    impulse = float(rng.uniform(*SHARE)) * plant.lip_limit(degrees)
    plant.add_push(Push(degrees, impulse, time=plant.time + 2.0))
    x, y, height = rng.uniform([-0.02, -0.02, -0.04], [0.02, 0.02, 0.01])
    roll, pitch, yaw = np.radians(rng.uniform(-6.0, 6.0, 3))
    supervisor.set_body_reference(BodyReference(x, y, height, roll, pitch, yaw))


def summary(robot: str, runs: list[Run]) -> dict[str, object]:
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
