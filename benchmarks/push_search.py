# SPDX-License-Identifier: BSD-3-Clause
"""Search the weights that decide near the edge of balance by pushes all around.

    python benchmarks/push_search.py --robot b1 --late 80,85,90 --strict 77.5 --jobs 2

CMA-ES (Optuna) begins at the robot's own values. What counts are pushes of 0.1 s through the centre
of mass, as those of surefoot assess, half way around: how many of the levels the robot survives on
level ground and with 20 ms of latency, the worst heading thrice, less what feet move by too far at
--strict. Gains of feedback are not searched: margins, quiet standing and what watches them stay as
they are. Every better set is said, as rows of the robot's TOML, friction of [robot], the others of
[gains]; what it is worth on all headings and other seeds, surefoot assess says.
"""

from __future__ import annotations

import argparse
import sys
import warnings
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import optuna
from optuna.distributions import FloatDistribution
from optuna.samplers import CmaEsSampler
from push_worth import RANGES, Pushes, own_values, score
from seed_runs import ROBOTS, whole
from surefoot.processes import killable_pool

SIGMA = 0.1  # first step of CMA-ES, as a share of the logarithmic ranges


def search(robot: str, trials: int, jobs: int, seed: int, pushes: Pushes) -> None:
    """Try sets of values, four a process at a time, and say each that beats those before."""
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    # x0 and sigma0 go with Optuna 6, which pyproject.toml excludes.
    warnings.filterwarnings("ignore", "`(x0|sigma0)`", FutureWarning)
    own = own_values(robot)
    space = {name: FloatDistribution(*ends, log=True) for name, ends in RANGES.items()}
    study = optuna.create_study(
        direction="maximize", sampler=CmaEsSampler(x0=own, sigma0=SIGMA, seed=seed)
    )
    study.enqueue_trial(own)
    best = -float("inf")
    with killable_pool(jobs) as pool:
        left = trials
        while left > 0:
            asked = [study.ask(space) for _ in range(min(left, 4 * jobs))]
            runs = [pool.submit(score, robot, trial.params, pushes) for trial in asked]
            for trial, run in zip(asked, runs, strict=True):
                value, survived = run.result()
                study.tell(trial, value)
                if value > best:
                    best = value
                    tell(trial.number, value, survived, trial.params)
            left -= len(asked)


def tell(number: int, value: float, survived: list[float], values: dict[str, float]) -> None:
    """Print a set of values."""
    counts = " ".join(f"{count:.1f}" for count in survived) or "none: feet move too far"
    print(f"# trial {number}: {value:.1f}; levels survived by heading: {counts}")
    print("\n".join(f"{name} = {value:.4g}" for name, value in values.items()), flush=True)


def numbers(text: str) -> list[float]:
    """Return comma-separated levels [%] in rising order; raises ValueError."""
    levels = sorted(float(part) for part in text.split(","))
    if not all(0.0 < level <= 200.0 for level in levels):
        raise ValueError(text)
    return levels


def main() -> int:
    """Search."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--robot", choices=ROBOTS, required=True)
    parser.add_argument("--trials", type=lambda text: whole(text, 1), default=200)
    parser.add_argument("--jobs", type=lambda text: whole(text, 1), default=1, help="processes (1)")
    parser.add_argument("--seed", type=int, default=0, help="of the search")
    parser.add_argument("--levels", type=numbers, default=[100.0, 105.0, 110.0, 115.0, 120.0])
    parser.add_argument("--late", type=numbers, default=[90.0, 95.0, 100.0, 105.0])
    parser.add_argument("--strict", type=float, default=80.0, help="level for feet that stay [%%]")
    parser.add_argument("--seeds", type=int, default=1, help="of sensors and motors, from 0 (1)")
    options = parser.parse_args()
    pushes = Pushes(options.levels, options.late, options.strict, range(options.seeds))
    search(options.robot, options.trials, options.jobs, options.seed, pushes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
