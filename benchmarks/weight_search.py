# SPDX-License-Identifier: BSD-3-Clause
"""Search of the QP weights that matter near the push limit, by pushes in all directions.

    python benchmarks/weight_search.py --robot b1 --late 80 85 90 --strict 77.5 --jobs 2

CMA-ES (Optuna) starts from the values of the robot. Pushes last 0.1 s and act through the centre of
mass, as in surefoot assess, with headings over half a circle. The objective is the number of levels
that the robot survives on level ground and with 20 ms of latency; the worst heading counts three
times. A penalty for feet that move too far at the level --strict is subtracted. Feedback gains are
not searched, so stability margins, quiet standing and fault detection do not change. Each better
set is printed as rows of the robot's TOML: friction is for [robot], all other rows are for [gains].
Run surefoot assess to evaluate a set on all headings and on other seeds.
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

SIGMA = 0.1  # initial step size of CMA-ES, as a share of the logarithmic ranges


def search(robot: str, trials: int, jobs: int, seed: int, pushes: PushSet) -> None:
    """Evaluate sets of values in batches of four per process, and print each new best set."""
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    # Optuna 6 removes x0 and sigma0; pyproject.toml excludes it.
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
    """Print a set of values as rows of TOML."""
    counts = " ".join(f"{count:.1f}" for count in survived) or "none: feet move too far"
    print(f"# trial {number}: {value:.1f}; levels survived by heading: {counts}")
    print("\n".join(f"{name} = {value:.4g}" for name, value in values.items()), flush=True)


def parse_level(text: str) -> float:
    """Parse an option as a share of the push limit [%]; raise ArgumentTypeError for other text."""
    value = float(text)
    if not 0.0 < value <= MAX_LEVEL:
        raise argparse.ArgumentTypeError(
            f"got {text}, expected > 0 and <= {MAX_LEVEL:g} [% of the push limit]"
        )
    return value


def main() -> int:
    """Run the search."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--robot", choices=ROBOTS, required=True)
    parser.add_argument("--trials", type=lambda text: parse_integer(text, 1), default=200)
    parser.add_argument(
        "--jobs",
        type=lambda text: parse_integer(text, 1),
        default=1,
        help="number of processes (1)",
    )
    parser.add_argument("--seed", type=int, default=0, help="seed of the search")
    for name, default, what in (
        ("--levels", [100.0, 105.0, 110.0, 115.0, 120.0], "on level ground"),
        ("--late", [90.0, 95.0, 100.0, 105.0], "with 20 ms of latency"),
    ):
        what = f"levels of pushes {what} [%% of the push limit]"
        parser.add_argument(name, type=parse_level, nargs="+", default=default, help=what)
    parser.add_argument(
        "--strict",
        type=parse_level,
        default=80.0,
        help="level at which feet must stay in place [%%]",
    )
    parser.add_argument(
        "--seeds",
        type=lambda text: parse_integer(text, 1),
        default=1,
        help="number of seeds of the sensors (1)",
    )
    options = parser.parse_args()
    levels, late = sorted(options.levels), sorted(options.late)
    pushes = PushSet(levels, late, options.strict, range(options.seeds))
    search(options.robot, options.trials, options.jobs, options.seed, pushes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
