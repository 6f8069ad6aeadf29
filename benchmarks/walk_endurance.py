# SPDX-License-Identifier: BSD-3-Clause
"""Endurance of a walk: hours of random commands, pushes and ground under the supervisor.

    python benchmarks/walk_endurance.py --robots go1 --hours 1 --store FILE --json FILE
    python benchmarks/walk_endurance.py --robots go1 --first 17 --hours 0.01
    python benchmarks/walk_endurance.py --robots b1 --power-level 0

Each episode is a minute with the sensor errors, soles and collisions of a walking robot. Its seed
draws everything (random_walk.py) and reproduces it alone. The robot has no fault: an episode fails
if the robot falls, or if a fault with a reaction begins; the fault "slip" may be true and does not
end an episode. The power protection is at level 10, the highest of the SDK: level 5 carries walks
on level ground, but a pushed robot that steps off an edge trips it. A tick's time is thread CPU
time. The tracking error is that of the true velocity, from 1 s after each command and 2 s after
each push on, against the clamped command.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections import Counter
from typing import Any

from false_trips import positive_hours
from seed_runs import ROBOTS, Job, add_seed_options, parse_integer, run_seeds
from surefoot.cli.output_files import write_json
from walk_episode import Episode, EpisodeRun

EPISODE_TIME = 60.0  # [s]
POWER_LEVEL = 10
PERCENTILES = {"p50": 0.5, "p99": 0.99, "p99.9": 0.999, "max": 1.0}


def main() -> int:
    """Run the requested hours of each robot, print and write JSON; return 3 if an episode fails."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robots", nargs="+", default=list(ROBOTS), choices=ROBOTS)
    parser.add_argument(
        "--hours", type=positive_hours, default=1.0, help="simulated hours per robot (1)"
    )
    parser.add_argument(
        "--power-level",
        type=lambda text: parse_integer(text, 0),
        default=POWER_LEVEL,
        help=f"level of the power protection, 0: off ({POWER_LEVEL})",
    )
    add_seed_options(parser)
    options = parser.parse_args()
    count = math.ceil(3600.0 * options.hours / EPISODE_TIME)
    jobs: list[Job] = [
        (robot, options.power_level, options.first + k)
        for robot in options.robots
        for k in range(count)
    ]
    episodes = dict(zip(jobs, run_seeds(run_episode, Episode, jobs, options), strict=True))
    results = []
    for robot in options.robots:
        own = {int(seed): one for (name, _, seed), one in episodes.items() if name == robot}
        results.append(summary(robot, own))
        print(text(results[-1]))
    write_json(options.json, {"robots": results}, 1)
    return 3 if any(result["failures"] for result in results) else 0


def run_episode(job: Job, duration: float = EPISODE_TIME) -> Episode:
    """Run the episode of a robot, a power level and a seed for a time [s]."""
    robot, power_level, seed = job
    return EpisodeRun(str(robot), int(power_level), int(seed), duration).run()


def summary(robot: str, episodes: dict[int, Episode]) -> dict[str, Any]:
    """Return the figures of all episodes of a robot, by seed, as JSON values."""
    runs = list(episodes.values())
    faults = sum((Counter(run.faults) for run in runs), Counter[str]())
    tracked = max(1, sum(run.tracked_ticks for run in runs))
    times = {
        phase: percentiles(sum((_histogram(run, phase) for run in runs), Counter[int]()))
        for phase in ("stand", "walk")
    }
    stand, walk = times["stand"]["p50"], times["walk"]["p50"]
    return {
        "robot": robot,
        "episodes": len(runs),
        "hours": sum(run.seconds for run in runs) / 3600.0,
        "walking_ticks": sum(run.walking_ticks for run in runs),
        "failures": {seed: run.why for seed, run in episodes.items() if not run.ok},
        "faults": dict(sorted(faults.items())),
        "false_slips": sum(run.false_slips for run in runs),
        "not_first": sum(run.not_first for run in runs),
        "not_solved": sum(run.not_solved for run in runs),
        "leg_contacts": sum(run.leg_contacts for run in runs),
        "tick_us": times,
        "walk_to_stand": walk / stand if stand and walk else None,
        "velocity_rmse": [
            math.sqrt(sum(run.squares[axis] for run in runs) / tracked) for axis in range(3)
        ],
    }


def percentiles(counts: Counter[int]) -> dict[str, int | None]:
    """Return percentiles of a histogram of whole numbers; None if it is empty."""
    found: dict[str, int | None] = dict.fromkeys(PERCENTILES)
    seen = 0
    for value, count in sorted(counts.items()):
        seen += count
        for name, share in PERCENTILES.items():
            if found[name] is None and seen >= share * counts.total():
                found[name] = value
    return found


def text(result: dict[str, Any]) -> str:
    """Return the figures of a robot as lines of text."""
    faults = ", ".join(f"{name} {count}" for name, count in result["faults"].items()) or "none"
    times = {
        phase: ", ".join(f"{name} {value}" for name, value in values.items())
        for phase, values in result["tick_us"].items()
    }
    ratio = result["walk_to_stand"]
    vx, vy, yaw_rate = result["velocity_rmse"]
    return "\n".join(
        [
            f"{result['robot']}: {result['episodes']} episodes, {result['hours']:.2f} hours, "
            f"{result['walking_ticks']} walking ticks, {len(result['failures'])} failed",
            *(f"  seed {seed}: {why}" for seed, why in result["failures"].items()),
            f"  faults that began: {faults}; slips without a slide: {result['false_slips']}",
            f"  ticks not solved at first {result['not_first']}, not solved "
            f"{result['not_solved']}; leg contacts {result['leg_contacts']}",
            f"  tick [us] standing: {times['stand']}",
            f"  tick [us] walking: {times['walk']}"
            + (f"; p50 {ratio:.2f} of standing" if ratio else ""),
            f"  RMSE: vx {vx:.3f} m/s, vy {vy:.3f} m/s, yaw rate {yaw_rate:.3f} rad/s",
        ]
    )


def _histogram(run: Episode, phase: str) -> Counter[int]:
    return Counter({int(us): n for us, n in run.tick_us[phase].items()})


if __name__ == "__main__":
    sys.exit(main())
