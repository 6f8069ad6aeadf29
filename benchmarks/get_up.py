# SPDX-License-Identifier: BSD-3-Clause
"""Get-up: let robots rise from random lying poses; count successes, measure power and time.

    python benchmarks/get_up.py --robot go1 --count 1000 --jobs 2 --json FILE

Each seed drops the robot with random leg angles (Plant.reset_lying) and real sensors. A Supervisor
then lets it rise at power level 1 (b1: 10). A run passes if the robot stands still 1.5 s after the
rise and the power protection never tripped.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import asdict, dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "tests" / "closed_loop"))

import mujoco
import numpy as np
from monitored_robot import MonitoredRobot
from seed_runs import ROBOTS, Job, RunOutcome, add_seed_options, run_seeds, seeds_of
from surefoot import Error, Mode, RequestStatus, Status
from surefoot.cli.output_files import write_json
from surefoot.robot.power_level import power_level

MAX_ARMING_TIME = 20.0  # [s] longest time until all arming checks pass; some robots sink slowly
MAX_RISE_TIME = 60.0  # [s] longest time of a rise, with retries
STAND_TIME = 1.5  # [s] duration of standing after the rise
MAX_STILL_SPEED = 0.05  # [m/s], [rad/s] base speed below which the robot stands still


@dataclass
class Outcome(RunOutcome):
    """Result of one seed."""

    robot: str
    seed: int
    seconds: float  # time from the request to standing, or to giving up [s]
    watts: float  # largest average power that the power protection computed [W]
    tilt_deg: float  # largest tilt during the run [deg]
    mode_step: float  # largest torque step at a change of mode, over tau_max
    refused: int  # ticks in which the power protection tripped


def run(job: Job) -> Outcome:
    """Drop one robot and let it rise."""
    name, seed = str(job[0]), int(job[1])
    try:
        robot = MonitoredRobot(name, seed)
    except Error as error:
        return Outcome(False, f"no pose: {error}", name, seed, 0.0, 0.0, 0.0, 0.0, 0)
    why, seconds = get_up(robot)
    if not why and robot.protection_trips:
        why = "power protection"
    return Outcome(
        not why,
        why,
        name,
        seed,
        round(seconds, 2),
        round(robot.power, 1),
        round(robot.tilt_deg, 1),
        round(robot.torque_step_at_mode_change, 4),
        robot.protection_trips,
    )


def get_up(robot: MonitoredRobot) -> tuple[str, float]:
    """Arm, rise and stand; return the reason of a failure or "", and the time of the rise [s]."""
    supervisor = robot.supervisor
    if not robot.run(MAX_ARMING_TIME, lambda: supervisor.arming.ready):
        return f"not armed: {robot.failures}", 0.0
    robot.arm()
    if supervisor.request(Mode.RISE) != RequestStatus.ACCEPTED:
        return "rise refused", 0.0
    start = robot.plant.time
    robot.tick()
    robot.run(MAX_RISE_TIME, lambda: supervisor.mode != Mode.RISE)
    seconds = robot.plant.time - start
    if supervisor.mode != Mode.STAND:
        return f"{supervisor.mode}, {supervisor.damping_fault}; {contacts_text(robot)}", seconds
    robot.run(STAND_TIME)
    truth = robot.plant.truth
    stands = supervisor.mode == Mode.STAND and supervisor.controller.status == Status.OK
    if not stands or truth.fell or np.abs(truth.v[:6]).max() > MAX_STILL_SPEED:
        return f"does not stand: {supervisor.mode}, {supervisor.controller.status}", seconds
    return "", seconds


def contacts_text(robot: MonitoredRobot) -> str:
    """Return the contacts between links, and of links other than feet with the ground, as text."""
    model, data = robot.plant.model, robot.plant.data
    feet = {int(body) for body in robot.plant.handles.foot_bodies}
    found = set()
    for i in range(data.ncon):
        force = np.zeros(6)
        mujoco.mj_contactForce(model, data, i, force)
        bodies = [int(model.geom_bodyid[geom]) for geom in data.contact[i].geom]
        if force[0] > 1.0 and not (0 in bodies and feet & set(bodies)):
            names = [mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, b) for b in bodies]
            found.add(f"{names[1]} on {names[0]} {force[0]:.0f} N")
    return ", ".join(sorted(found)) or "nothing touches"


def summarise(outcomes: list[Outcome]) -> dict[str, object]:
    """Return the figures of one robot."""
    standing = [o for o in outcomes if o.ok]
    seconds = [o.seconds for o in standing] or [0.0]
    return {
        "robot": outcomes[0].robot,
        "level": power_level(outcomes[0].robot),
        "count": len(outcomes),
        "stand": len(standing),
        "trips": sum(o.refused > 0 for o in outcomes),
        "peak_watts": max(o.watts for o in outcomes),
        "median_seconds": float(np.median(seconds)),
        "longest_seconds": max(seconds),
        "greatest_tilt_deg": max(o.tilt_deg for o in outcomes),
        "greatest_mode_step": max(o.mode_step for o in outcomes),
        "failures": [asdict(o) for o in sorted(outcomes, key=lambda o: o.seed) if not o.ok],
    }


def summary_line(summary: dict[str, object]) -> str:
    """Return the figures of one robot as a line of text."""
    return (
        "{robot}: {stand} of {count} stand, level {level}, trips {trips}, peak {peak_watts:.0f} W, "
        "time {median_seconds:.1f} s median {longest_seconds:.1f} s longest, tilt up to "
        "{greatest_tilt_deg:.0f} deg, mode step {greatest_mode_step:.3f} of tau_max"
    ).format(**summary)


def main() -> int:
    """Run all seeds and print figures; return 3 if a robot did not get up, else 0."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--robot", action="append", choices=ROBOTS, help="default: all")
    add_seed_options(parser, 1000)
    options = parser.parse_args()
    jobs: list[Job] = [(r, seed) for seed in seeds_of(options) for r in options.robot or ROBOTS]
    outcomes = run_seeds(run, Outcome, jobs, options)
    robots = [[o for o in outcomes if o.robot == r] for r in options.robot or ROBOTS]
    summaries = [summarise(of_robot) for of_robot in robots]
    print("\n".join(summary_line(summary) for summary in summaries))
    if options.json:
        runs = [asdict(o) for o in sorted(outcomes, key=lambda o: (o.robot, o.seed))]
        write_json(options.json, {"robots": summaries, "runs": runs}, 1)
    return 0 if all(o.ok for o in outcomes) else 3


if __name__ == "__main__":
    sys.exit(main())
