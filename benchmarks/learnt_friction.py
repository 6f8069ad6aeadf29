# SPDX-License-Identifier: BSD-3-Clause
"""Learnt friction: walk and push robots on floors with different friction.

    python benchmarks/learnt_friction.py --robots go1 --motions walk --floors 0.3 0.8

A robot trots in place or at 0.5 m/s, or is pushed to the side while it stands, with 0.6 of the LIP
push limit. Each row prints mean, least and largest learnt friction at the end, the slip, and how
many runs fell. With --rigid the soles are rigid.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from seed_runs import ROBOTS
from surefoot import Gait
from surefoot.stand import parse_push
from surefoot.walk import WalkLog, WalkSettings, parse_velocity, run_walk, summarise

FLOORS = (0.2, 0.3, 0.4, 0.5, 0.65, 0.8)
SEEDS = (1, 2, 3)
DURATION = 5.0  # [s]
MOTIONS = {
    "walk": WalkSettings(
        duration=DURATION, gait=Gait.TROT, velocities=(parse_velocity("0.5,0,0@0.5"),)
    ),
    "in place": WalkSettings(duration=DURATION, gait=Gait.TROT),
    "pushed": WalkSettings(duration=DURATION, pushes=(parse_push("lateral:60%:0.1@2.0"),)),
}
LOADED = 0.05  # [m g] load above which a moving contact point slips


def run(robot: str, motion: str, friction: float, soft: bool, seed: int) -> WalkLog:
    """Simulate one robot."""
    settings = replace(MOTIONS[motion], robot=robot)
    plant = replace(settings.plant, friction=friction, soft_soles=soft, seed=seed)
    return run_walk(replace(settings, plant=plant))


def slip(log: WalkLog) -> float:
    """Return the slip [mm]: per step of a trot, and in all for each foot of a stand."""
    per_step = summarise(log)["slip_mm_per_step"]
    if log.settings.gait == Gait.TROT and per_step is not None:
        return float(per_step)
    speed = np.linalg.norm(log.slip_velocity[:, :2], axis=1)
    loaded = log.normal_forces > LOADED * log.weight
    return 250.0 * float((speed * loaded).sum()) / log.settings.plant.control_rate


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a row for each robot, motion and floor."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--robots", nargs="+", choices=ROBOTS, default=["go1", "go2", "a1", "b1"])
    parser.add_argument("--motions", nargs="+", choices=list(MOTIONS), default=list(MOTIONS))
    parser.add_argument("--floors", nargs="+", type=float, default=FLOORS, help="coefficients")
    parser.add_argument("--rigid", action="store_true", help="rigid soles")
    options = parser.parse_args(arguments)
    for robot in options.robots:
        for motion in options.motions:
            for floor in options.floors:
                logs = [run(robot, motion, floor, not options.rigid, seed) for seed in SEEDS]
                learnt = np.array([log.friction[-1] for log in logs])
                print(
                    f"{robot} {motion}, floor {floor:g}: learnt {learnt.mean():.2f} "
                    f"({learnt.min():.2f} .. {learnt.max():.2f}), slip "
                    f"{np.mean([slip(log) for log in logs]):.1f} mm, "
                    f"{sum(log.fell for log in logs)} of {len(logs)} fell",
                    flush=True,
                )
    return 0


if __name__ == "__main__":
    sys.exit(main())
