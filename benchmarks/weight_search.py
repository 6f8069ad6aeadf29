# SPDX-License-Identifier: BSD-3-Clause
"""Search the weights that decide near the edge of balance by pushes all around.

    python benchmarks/weight_search.py --robot b1 --late 80 85 90 --strict 77.5 --jobs 2

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
from push_objective import RANGES, PushSet, default_values, score
from seed_runs import ROBOTS, parse_integer
from surefoot.assess.sweep import MAX_LEVEL
from surefoot.system.worker_processes import killable_pool

SIGMA = 0.1  # first step of CMA-ES, as a share of the logarithmic ranges


def search(robot: str, trials: int, jobs: int, seed: int, pushes: PushSet) -> None:
    """Try sets of values, four a process at a time, and say each that beats those before."""
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    # x0 and sigma0 go with Optuna 6, which pyproject.toml excludes.
    warnings.filterwarnings("ignore", "`(x0|sigma0)`", FutureWarning)
    own = default_values(robot)
    space = {name: FloatDistribution(*ends, log=True) for name, ends in RANGES.items()}
    study = optuna.create_study(
        direction="maximize", sampler=CmaEsSampler(x0=own, sigma0=SIGMA, seed=seed)
    )
    study.enqueue_trial(own)
    best = -float("inf")
    with killable_pool(jobs) as pool:
        trials_left = trials
        while trials_left > 0:
            pending_trials = [study.ask(space) for _ in range(min(trials_left, 4 * jobs))]
            runs = [pool.submit(score, robot, trial.params, pushes) for trial in pending_trials]
            for trial, run in zip(pending_trials, runs, strict=True):
                value, survived = run.result()
                study.tell(trial, value)
                if value > best:
                    best = value
                    print_values(trial.number, value, survived, trial.params)
            trials_left -= len(pending_trials)


def print_values(
    number: int, value: float, survived: list[float], values: dict[str, float]
) -> None:
    """Print a set of values."""
    counts = " ".join(f"{count:.1f}" for count in survived) or "none: feet move too far"
    print(f"# trial {number}: {value:.1f}; levels survived by heading: {counts}")
    print("\n".join(f"{name} = {value:.4g}" for name, value in values.items()), flush=True)


def parse_level(text: str) -> float:
    """Return the share of the robot's own limit that an option's text is [%]."""
    value = float(text)
    if not 0.0 < value <= MAX_LEVEL:
        raise argparse.ArgumentTypeError(
            f"got {text}, expected more than 0, {MAX_LEVEL:g} % at most"
        )
    return value


def main() -> int:
    """Search."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--robot", choices=ROBOTS, required=True)
    parser.add_argument("--trials", type=lambda text: parse_integer(text, 1), default=200)
    parser.add_argument(
        "--jobs", type=lambda text: parse_integer(text, 1), default=1, help="processes (1)"
    )
    parser.add_argument("--seed", type=int, default=0, help="of the search")
    for name, default, what in (
        ("--levels", [100.0, 105.0, 110.0, 115.0, 120.0], "on level ground"),
        ("--late", [90.0, 95.0, 100.0, 105.0], "with 20 ms of latency"),
    ):
        what = f"levels to survive {what} [%%]"
        parser.add_argument(name, type=parse_level, nargs="+", default=default, help=what)
    parser.add_argument(
        "--strict", type=parse_level, default=80.0, help="level for feet that stay [%%]"
    )
    parser.add_argument(
        "--seeds",
        type=lambda text: parse_integer(text, 1),
        default=1,
        help="of sensors, from 0 (1)",
    )
    options = parser.parse_args()
    levels, late = sorted(options.levels), sorted(options.late)
    pushes = PushSet(levels, late, options.strict, range(options.seeds))
    search(options.robot, options.trials, options.jobs, options.seed, pushes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
