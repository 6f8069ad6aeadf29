# SPDX-License-Identifier: BSD-3-Clause
"""How often the supervisor trips over nothing: hours of healthy running, every fault counted.

    python benchmarks/healthy_hours.py --robot go1 --hours 10 --jobs 2 --json FILE

Each run gets up from lying, stands for a minute while its body is asked to move and pushed, and
sits down, on ground, with a payload and with motors drawn from its seed. None of that is a fault:
a reaction to one (sit or damp) is a false trip, and so is a fall. `tests/closed_loop` has a short
form.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
from collections import Counter
from concurrent.futures import as_completed
from dataclasses import dataclass, field

import numpy as np
import surefoot
from surefoot import BodyReference, FaultReaction, Mode
from surefoot.processes import spawn_pool
from surefoot.sim import Plant, PlantSettings, Push

LEVELS = {"a1": 1, "go1": 1, "go2": 1, "b1": 10}  # that a get-up keeps to
STANDING = 60.0  # [s]
PATIENCE = 30.0  # [s] to get up and to lie down
EVERY = 5.0  # [s] between pushes, and between what the body is asked for
SHARE = 0.1, 0.4  # of the pendulum's limit
PAYLOAD = 0.3  # of the robot's mass, at most
SLOPE = 8.0  # [deg] at most


@dataclass
class Run:
    """What came of one run.

    Attributes:
        seed: Which.
        seconds: Simulated [s].
        faults: How often each fault began.
        trip: What was reacted to, or another reason that it did not stand to the end; None: fine.
    """

    seed: int
    seconds: float = 0.0
    faults: Counter[str] = field(default_factory=Counter)
    trip: str | None = None


def main() -> None:
    """Run until the hours are over, print, write JSON; exit with 1 if anything tripped."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robot", default="go1", choices=sorted(LEVELS))
    parser.add_argument("--hours", type=float, default=10.0, help="simulated")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--first", type=int, default=0, help="first seed")
    parser.add_argument("--json")
    arguments = parser.parse_args()
    count = math.ceil(3600.0 * arguments.hours / (STANDING + 10.0))
    seeds = range(arguments.first, arguments.first + count)
    runs: list[Run] = []
    with spawn_pool(arguments.jobs) as pool:
        waiting = [pool.submit(healthy, arguments.robot, seed) for seed in seeds]
        for done in as_completed(waiting):
            runs.append(done.result())
            if runs[-1].trip:
                print(f"seed {runs[-1].seed}: {runs[-1].trip}", flush=True)
            if sys.stderr.isatty():
                print(f"\r{len(runs)}/{count}", end="", file=sys.stderr)
    result = summary(arguments.robot, runs)
    print(text(result))
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(result, file, indent=2)
    sys.exit(1 if result["trips"] else 0)


def healthy(robot: str, seed: int) -> Run:
    """Run one seed: get up, stand, be pushed and moved, sit down."""
    rng = np.random.default_rng([seed, 12])
    plant = Plant(robot, drawn(robot, seed, rng))
    state = plant.reset_lying(rng)
    options = surefoot.SupervisorOptions(power_level=LEVELS[robot])
    supervisor = surefoot.Supervisor(plant.robot, options=options)
    run = Run(seed)
    stood, moved, asked = 0.0, 0.0, {Mode.PASSIVE: Mode.RISE}
    while run.seconds < STANDING + PATIENCE:
        if not supervisor.armed:
            supervisor.arm()
        elif supervisor.mode in asked:
            supervisor.request(asked[supervisor.mode])
        if supervisor.mode == Mode.STAND:
            stood += 0.002
            if stood - moved > EVERY:
                moved = stood
                disturb(plant, supervisor, rng)
            if stood > STANDING:
                asked = {Mode.STAND: Mode.SIT}
        elif stood > STANDING and supervisor.mode == Mode.PASSIVE:
            break
        state = plant.step(supervisor.update(state))
        run.seconds += 0.002
        run.trip = tripped(plant, supervisor, stood > STANDING)
        if run.trip:
            break
    else:
        run.trip = f"did not end: {supervisor.mode.name}, {supervisor.arming.failures(plant.robot)}"
    for info in surefoot.fault_table():
        run.faults[info.name] = supervisor.faults.count(info.id)
    return run


def tripped(plant: Plant, supervisor: surefoot.Supervisor, over: bool) -> str | None:
    """Return what the supervisor reacted to, or None."""
    if supervisor.mode == Mode.DAMPING:
        return f"{plant.time:.1f} s: damping for {supervisor.reason.name}"
    if supervisor.mode == Mode.SIT and not over:
        names = [
            info.name
            for info in surefoot.fault_table()
            if info.id in supervisor.faults.active and info.reaction == FaultReaction.SIT
        ]
        return f"{plant.time:.1f} s: sits for {', '.join(names) or 'a leg that is stuck'}"
    if supervisor.mode == Mode.STAND and plant.truth.fell:
        return f"{plant.time:.1f} s: fell"
    return None


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
    faults: Counter[str] = sum((run.faults for run in runs), Counter())
    trips = {run.seed: run.trip for run in runs if run.trip}
    hours = sum(run.seconds for run in runs) / 3600.0
    return {
        "robot": robot,
        "runs": len(runs),
        "hours": hours,
        "trips": trips,
        "faults": {info.name: faults[info.name] for info in surefoot.fault_table()},
    }


def text(result: dict[str, object]) -> str:
    """Return the numbers as a few lines."""
    trips, faults = result["trips"], result["faults"]
    assert isinstance(trips, dict) and isinstance(faults, dict)
    seen = ", ".join(f"{name} {count}" for name, count in faults.items() if count) or "none"
    return (
        f"{result['robot']}: {result['runs']} runs, {result['hours']:.2f} simulated hours, "
        f"{len(trips)} false trips\n  faults told: {seen}"
    )


if __name__ == "__main__":
    main()
