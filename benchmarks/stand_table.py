"""Table of `surefoot stand` results: every robot, five seeds, quiet and pushed.

The benchmark prints the worst values over the seeds as a Markdown table. The foot force fields are
zero without the option `--foot-force est` or `--foot-force raw`.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from typing import Any

ROBOTS = ("a1", "go1", "go2", "b1")
RUNS = {
    "quiet": ("--duration", "10"),
    "lateral": ("--duration", "5", "--push", "lateral:50%:0.1@2.0"),
    "forward": ("--duration", "5", "--push", "forward:50%:0.1@2.0"),
}


def stand(robot: str, run: str, seed: int, foot_force: str) -> dict[str, Any]:
    """Run the command once and return its JSON."""
    command = [sys.executable, "-m", "surefoot.cli", "stand", "--robot", robot, "--json", "-"]
    command += ["--seed", str(seed), "--foot-force", foot_force, *RUNS[run]]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):  # 3: the robot fell
        raise SystemExit(f"{' '.join(command)}: {done.stderr}")
    result: dict[str, Any] = json.loads(done.stdout)
    return result


def worst(results: list[dict[str, Any]], key: str) -> float:
    """Return the largest value of a field over all runs."""
    return max(float(result[key]) for result in results)


def row(robot: str, runs: dict[str, list[dict[str, Any]]]) -> str:
    """Return the table row of one robot."""
    quiet, pushed = runs["quiet"], runs["lateral"] + runs["forward"]
    everything = quiet + pushed
    settled = sum(r["settled"] and not r["fell"] for r in pushed)
    cells = [
        robot,
        f"{worst(quiet, 'height_error_mm'):.2f} mm",
        f"{worst(quiet, 'tilt_error_deg'):.3f} / {worst(quiet, 'yaw_error_deg'):.3f} deg",
        f"{worst(quiet, 'com_rms_mm'):.2f} mm",
        f"{worst(quiet, 'joint_velocity_rms'):.4f} rad/s",
        f"{worst(quiet, 'torque_hf_rms'):.3f} N.m",
        f"{worst(quiet, 'max_foot_travel_mm'):.2f} mm",
        f"{settled} of {len(pushed)}",
        f"{worst(pushed, 'max_tilt_deg'):.1f} deg",
        f"{worst(everything, 'estimator_velocity_rmse'):.4f} m/s",
        f"{worst(everything, 'estimator_tilt_rmse_deg'):.2f} deg",
        f"{sum(r['qp_failures'] for r in everything)}",
    ]
    return "| " + " | ".join(cells) + " |"


def main() -> None:
    """Run all commands, two at a time, and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--foot-force", default="dead", choices=("est", "raw", "dead"))
    parser.add_argument("--seeds", type=int, default=5)
    options = parser.parse_args()
    jobs = [(r, k, s) for r in ROBOTS for k in RUNS for s in range(options.seeds)]
    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda job: stand(*job, options.foot_force), jobs))
    print(
        "| robot | height error | tilt / yaw error | CoM RMS | joint velocity RMS "
        "| torque above 30 Hz | foot travel | pushes settled | largest tilt, pushed "
        "| velocity RMSE | tilt RMSE | failed ticks |"
    )
    print("|" + "---|" * 12)
    for robot in ROBOTS:
        runs = {
            kind: [x for x, job in zip(results, jobs, strict=True) if job[:2] == (robot, kind)]
            for kind in RUNS
        }
        assert all(not r["fell"] and r["torque_mode_only"] for rs in runs.values() for r in rs)
        print(row(robot, runs))


if __name__ == "__main__":
    main()
