# SPDX-License-Identifier: BSD-3-Clause
"""External lifts: lift or drop standing robots, and count how many stand afterwards.

    python benchmarks/external_lifts.py --robot go1 --count 500 --jobs 2 --json FILE

The robot has real sensors and a Supervisor at power level 10. Each seed draws the friction of the
floor, the foot force fields that have data, and the duration of the lift. In a run of kind "lift",
the seed also draws the height (5 to 30 cm) and the speeds; the trunk is put down and then released.
In a run of kind "drop", the trunk is released at a height of 10 cm, within 20 ms. The supervisor
continues despite the fault `lifted` (see fault_table()). A run passes if only feet touch the
ground, the supervisor neither damps nor sits, and the power protection does not trip. Three seconds
after the release the robot must stand still at its previous height.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from dataclasses import asdict, dataclass

import numpy as np
import surefoot
from seed_runs import ROBOTS, Job, RunOutcome, add_seed_options, run_seeds, seeds_of
from surefoot import Mode, Start, Status
from surefoot.cli.output_files import write_json
from surefoot.sim import Lift, Plant, PlantSettings
from surefoot.sim.truth import has_fallen

KINDS = ("lift", "drop")
POWER_LEVEL = 10  # level of the power protection; high, because a landing takes power
TIME_BEFORE, TIME_AFTER = 1.0, 3.0  # [s] duration of standing before the lift and after it
PERIOD = 0.002  # [s] time between two ticks
# [m/s], [rad/s] Largest speed of the base and of every joint with which the robot stands still.
MAX_STILL_SPEED = 0.05
HEIGHT_TOLERANCE = 0.01  # [m] allowed change of the base height


@dataclass
class Outcome(RunOutcome):
    """Result of one seed."""

    robot: str
    kind: str
    seed: int
    height: float  # height of the lift [m]
    watts: float  # largest average power that the power protection computed [W]
    tilt_deg: float  # largest tilt after the release [deg]
    step_mm: float  # largest displacement of a foot at the end [mm]
    faults: dict[str, int]


class LiftRun:
    """One run of a standing robot with its supervisor, with the measured power and tilt."""

    def __init__(self, robot: str, kind: str, seed: int) -> None:
        rng = np.random.default_rng([seed, KINDS.index(kind), 41])
        force = str(rng.choice(["est", "raw", "dead"]))
        friction = float(rng.uniform(0.5, 1.0))
        self.plant = Plant(robot, PlantSettings(seed=seed, friction=friction, foot_force=force))
        self.lift = random_lift(kind, rng)
        self.plant.add_lift(self.lift)
        options = surefoot.SupervisorOptions(power_level=POWER_LEVEL, start=Start.STANDING)
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        self._safety = surefoot.Safety(self.plant.robot)
        self._state = self.plant.reset()
        self.start = self.plant.truth
        self.watts = self.tilt_deg = 0.0

    def step(self) -> str:
        """Run one control period; return the reason to end the run, or "" to continue."""
        command = self.supervisor.update(self._state)
        refused = self._safety.power_protect(command, self._state, POWER_LEVEL) < 0
        self.watts = max(self.watts, self._safety.power)
        self._state = self.plant.step(command)
        upright = float(self.plant.data.xmat[self.plant.handles.root, 8])
        if self.plant.time > self.lift.time + self.lift.duration:
            self.tilt_deg = max(self.tilt_deg, float(np.degrees(np.arccos(min(upright, 1.0)))))
        when = f"{self.plant.time - self.lift.time:.2f} s after the lift began"
        if self.supervisor.mode != Mode.STAND:
            return f"{self.supervisor.mode.name} for {self.supervisor.damping_fault.name}, {when}"
        if has_fallen(self.plant.data, self.plant.handles):
            return f"fell, {when}"
        return f"power protection, {when}" if refused else ""

    def verdict(self) -> str:
        """Return why the robot does not stand at the end, or "" if it stands."""
        truth, status = self.plant.truth, self.supervisor.controller.status
        if status != Status.OK or np.abs(truth.v).max() > MAX_STILL_SPEED:
            return f"does not stand still: {status.name}, {np.abs(truth.v).max():.2f}"
        if not np.all(truth.contact):
            return "a foot is in the air"
        height_loss = self.start.q[2] - truth.q[2]
        return (
            ""
            if abs(height_loss) < HEIGHT_TOLERANCE
            else f"stands {1e3 * height_loss:.0f} mm lower"
        )


def random_lift(kind: str, rng: np.random.Generator) -> Lift:
    """Draw the external lift."""
    if kind == "drop":
        return Lift("trunk", TIME_BEFORE, float(rng.uniform(0.4, 1.5)), 0.1)
    height, up, down = (float(x) for x in rng.uniform([0.05, 0.1, 0.1], [0.3, 0.6, 0.5]))
    held = float(rng.uniform(0.5, 3.0))
    return Lift("trunk", TIME_BEFORE, height / up + held + height / down, height, up, 0.1, down)


def run(job: Job) -> Outcome:
    """Lift or drop one robot."""
    robot, kind, seed = str(job[0]), str(job[1]), int(job[2])
    lift_run = LiftRun(robot, kind, seed)
    why = ""
    while not why and lift_run.plant.time < TIME_BEFORE + lift_run.lift.duration + TIME_AFTER:
        why = lift_run.step()
    why = why or lift_run.verdict()
    moved = lift_run.plant.truth.p_world_feet - lift_run.start.p_world_feet
    counts = {i.name: lift_run.supervisor.faults.count(i.id) for i in surefoot.fault_table()}
    return Outcome(
        not why,
        why,
        robot,
        kind,
        seed,
        round(lift_run.lift.height, 3),
        round(lift_run.watts, 1),
        round(lift_run.tilt_deg, 2),
        round(1e3 * float(np.linalg.norm(moved, axis=0).max()), 1),
        {name: count for name, count in counts.items() if count},
    )


def summarise(outcomes: list[Outcome]) -> dict[str, object]:
    """Return the figures of one robot and kind of lift."""
    stand = [o for o in outcomes if o.ok]
    return {
        "robot": outcomes[0].robot,
        "kind": outcomes[0].kind,
        "count": len(outcomes),
        "stand": len(stand),
        "peak_watts": max(o.watts for o in outcomes),
        "greatest_tilt_deg": max((o.tilt_deg for o in stand), default=None),
        "greatest_step_mm": max((o.step_mm for o in stand), default=None),
        "runs_that_told": dict(Counter(name for o in outcomes for name in o.faults)),
        "failures": [asdict(o) for o in sorted(outcomes, key=lambda o: o.seed) if not o.ok],
    }


def summary_line(summary: dict[str, object]) -> str:
    """Return the figures of one robot and kind as a line of text."""
    line = (
        "{robot} {kind}: {stand} of {count} stand, peak {peak_watts:.0f} W, tilt up to "
        "{greatest_tilt_deg} deg, feet up to {greatest_step_mm} mm from where they stood; "
        "runs by fault: {runs_that_told}"
    )
    return line.format(**summary)


def main() -> int:
    """Run all seeds and print figures; return 3 if a robot did not stand afterwards, else 0."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--robot", action="append", choices=ROBOTS, help="default: all")
    parser.add_argument("--kind", action="append", choices=KINDS, help="default: both")
    add_seed_options(parser, 500)
    options = parser.parse_args()
    groups = [(r, k) for r in options.robot or ROBOTS for k in options.kind or KINDS]
    jobs: list[Job] = [(*group, seed) for seed in seeds_of(options) for group in groups]
    outcomes = run_seeds(run, Outcome, jobs, options)
    parts = [[o for o in outcomes if (o.robot, o.kind) == group] for group in groups]
    summaries = [summarise(part) for part in parts]
    print("\n".join(summary_line(summary) for summary in summaries))
    if options.json:
        runs = [asdict(o) for o in sorted(outcomes, key=lambda o: (o.robot, o.kind, o.seed))]
        write_json(options.json, {"groups": summaries, "runs": runs}, 1)
    return 0 if all(o.ok for o in outcomes) else 3


if __name__ == "__main__":
    sys.exit(main())
