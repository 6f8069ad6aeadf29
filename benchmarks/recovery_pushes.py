# SPDX-License-Identifier: BSD-3-Clause
"""Recovery steps: push standing robots, and see whether they stand again within 3 s.

    python benchmarks/recovery_pushes.py --robots go1 b1 --levels 1.0 1.35 --count 2 --soft --jobs 2

A StandController is pushed for 0.1 s from 16 directions. The levels are in LIP push limits. A push
is survived if the robot does not fall and stands within 3 s, slower than 5 cm/s and tilted by less
than 5 degrees. The robot stayed in place if no foot moved by more than 1 cm. With --soft the plant
has walking sensors and soft soles.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from seed_runs import ROBOTS, Job, RunOutcome, add_seed_options, run_seeds, seeds_of
from surefoot import StandController
from surefoot.cli.output_files import write_json
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.sim import Plant, PlantSettings, Push

HEADINGS = tuple(22.5 * k for k in range(16))  # [deg] of the push
PUSH_TIME, RECOVERY_TIME = 1.0, 3.0  # [s]
STAGGER = 0.013  # [s] by which the push of the next seed is later
MAX_SPEED = 0.05  # [m/s]
MAX_TILT = np.radians(5.0)  # [rad]
IN_PLACE = 0.01  # [m]


@dataclass
class PushOutcome(RunOutcome):
    """Result of one push."""

    in_place: bool
    stepped: bool


def run(job: Job) -> PushOutcome:
    """Push one robot."""
    robot, level, heading, soft, seed = job
    settings = PlantSettings(
        walking_sensors=soft == "soft",
        soft_soles=soft == "soft",
        physics_dt=0.001,
        seed=int(seed) + 1,
    )
    plant = Plant(str(robot), settings)
    state = plant.reset()
    limit = plant.lip_push_limit(float(heading))
    push_time = PUSH_TIME + STAGGER * int(seed)
    plant.add_push(Push(float(heading), float(level) * limit, time=push_time))
    controller = StandController(plant.robot)
    feet, stepped = plant.truth.p_world_feet, False
    while plant.time < push_time + RECOVERY_TIME and not plant.truth.fell:
        state = plant.step(controller.update(state))
        stepped = stepped or controller.reference.stepping
    truth = plant.truth
    tilt = np.arccos(min(1.0, matrix_from_wxyz(np.roll(truth.q[3:7], 1))[2, 2]))
    still = np.linalg.norm(truth.com_velocity) < MAX_SPEED and tilt < MAX_TILT
    why = "fell" if truth.fell else "" if still and not controller.reference.stepping else "steps"
    moved = np.linalg.norm((truth.p_world_feet - feet)[:2], axis=0).max()
    return PushOutcome(not why, why, bool(not why and moved < IN_PLACE), stepped)


def main(arguments: Sequence[str] | None = None) -> int:
    """Push robots at each level, print how many pushes are survived, write JSON."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robots", nargs="+", choices=ROBOTS, default=ROBOTS)
    parser.add_argument("--levels", nargs="+", default=["1.0", "1.2", "1.35", "1.5"])
    parser.add_argument("--soft", action="store_true", help="walking sensors and soft soles")
    add_seed_options(parser, 1)
    options = parser.parse_args(arguments)
    soft = "soft" if options.soft else "rigid"
    table = {}
    for robot in options.robots:
        for level in options.levels:
            jobs: list[Job] = [
                (robot, level, str(h), soft, s) for h in HEADINGS for s in seeds_of(options)
            ]
            runs = run_seeds(run, PushOutcome, jobs, options)
            survived, in_place = sum(r.ok for r in runs), sum(r.in_place for r in runs)
            print(f"{robot} {level}: {survived} of {len(runs)} survived, {in_place} in place")
            table[f"{robot} {level}"] = {
                "pushes": len(runs),
                "survived": survived,
                "in_place": in_place,
                "stepped": sum(r.stepped for r in runs),
            }
    write_json(options.json, {"soles": soft, "levels": table}, 1)
    return 0


if __name__ == "__main__":
    sys.exit(main())
