"""Table of a walk: for every row what is asked, and what each robot does, worst of the seeds.

The rows are velocities, the gait walk, straight line, start and stop, pushes, ground, and errors
of the model and of the link. Odd seeds have foot forces in newtons, even seeds none. A row passes
if every figure of every seed is within what is asked; rows of pushes and of the platform may fail
in 5 % of the seeds.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass, field

from seed_runs import (
    ROBOTS,
    Job,
    RunOutcome,
    add_seed_options,
    parse_integer,
    run_seeds,
    write_json,
)
from surefoot import Error, Gait
from surefoot.robot.loading import build_robot, describe_robot
from surefoot.sim import Flaws, Terrain
from surefoot.stand import parse_reference
from surefoot.walk import VelocityRequest, WalkSettings, run_walk, summarise
from walk_rows import (
    SMALL,
    START,
    Check,
    Row,
    check_push,
    check_start_and_stop,
    check_straight,
    check_upright,
    check_velocity,
    check_walk_gait,
    pushed,
    walk,
)

QUICK = ("vx 0.5", "platform 8 cm", "stairs 5 cm", "blocks 3 cm", "slope 15 deg, 45 deg")
B1 = ("b1",)
Velocity = tuple[float, float, float]


def velocity_row(name: str, velocity: tuple[float, float, float], robots: tuple[str, ...]) -> Row:
    """Return a row of one velocity on flat ground."""
    return Row(name, lambda robot, seed: walk(robot, seed, velocity), check_velocity, robots)


def plant_row(
    name: str,
    velocity: tuple[float, float, float] = (0.4, 0.0, 0.0),
    duration: float = 8.0,
    lost_frames: float = 0.0,
    predicted_delay: float = 0.0,
    **plant: object,
) -> Row:
    """Return a row of one ground or model error, on which the robot must not fall."""
    return Row(
        name,
        lambda robot, seed: walk(
            robot,
            seed,
            velocity,
            duration,
            plant,
            lost_frames=lost_frames,
            predicted_delay=predicted_delay,
        ),
        check_upright,
    )


def terrain_row(
    name: str, duration: float, allowed: float = 0.0, seeds: int = 1, **kind: float
) -> Row:
    """Return a row of one terrain; the seed draws its heights and distances."""
    return Row(
        name,
        lambda robot, seed: walk(
            robot, seed, (0.4, 0.0, 0.0), duration, {"terrain": Terrain(**kind, seed=seed)}
        ),
        check_upright,
        allowed=allowed,
        seeds=seeds,
    )


def payload_row(name: str, position: tuple[float, float, float]) -> Row:
    """Return a row with a payload of 30 % of the robot's mass."""

    def settings(robot: str, seed: int) -> WalkSettings:
        mass = 0.3 * build_robot(describe_robot(robot)).mass
        plant = {"payload_kg": mass, "payload_position": position}
        return walk(robot, seed, (0.4, 0.0, 0.0), 8.0, plant)

    return Row(name, settings, check_upright)


def gait_walk_rows() -> list[Row]:
    """Return the rows of the gait walk."""
    velocities = [(0.25, 0, 0), (-0.25, 0, 0), (0, 0.25, 0), (0, -0.25, 0), (0.18, 0.18, 0)]
    velocities += [(0, 0, 0.5), (0, 0, -0.5), (0.25, 0, 0.5), (0, 0.25, -0.5), (-0.18, 0.18, 0.5)]

    def row(name: str, velocity: Velocity, check: Check, duration: float, **plant: object) -> Row:
        return Row(
            f"walk: {name}",
            lambda robot, seed: walk(robot, seed, velocity, duration, plant, gait=Gait.WALK),
            check,
        )

    return [
        *(row(_velocity_name(v), v, check_walk_gait, 8.0) for v in velocities),
        *(
            row(
                f"slope 20 deg, {heading} deg",
                (0.2, 0, 0),
                check_upright,
                8.0,
                slope_deg=20.0,
                slope_heading_deg=heading,
            )
            for heading in (0, 180)
        ),
        *(across_slope_row(f"walk: slope 20 deg, {h} deg", t) for h, t in ((90, -1.0), (270, 1.0))),
        row("platform 8 cm", (0.2, 0, 0), check_upright, 25.0, terrain=Terrain(step_height=0.08)),
    ]


def across_slope_row(name: str, turn: float) -> Row:
    """Return the row of a gait walk across a slope of 20 deg.

    Across the slope, the standing pose would tip over before the first command. So the robot stands
    facing uphill and turns on the slope.

    Args:
        name: Name of the row.
        turn: 1 for a turn to the left, -1 to the right.
    """
    rate = 0.3  # [rad/s]
    walks = START + 0.5 * math.pi / rate
    velocities = (
        VelocityRequest(0.0, 0.0, turn * rate, START),
        VelocityRequest(0.2, 0.0, 0.0, walks),
    )
    return Row(
        name,
        lambda robot, seed: walk(
            robot,
            seed,
            (0.2, 0.0, 0.0),
            walks + 7.5,
            {"slope_deg": 20.0},
            gait=Gait.WALK,
            velocities=velocities,
        ),
        check_upright,
    )


def body_rows() -> list[Row]:
    """Return the rows of a trot with the body moved."""
    return [
        Row(
            f"vx 0.5, {text}",
            lambda robot, seed, text=text: walk(
                robot, seed, (0.5, 0, 0), references=(parse_reference(f"{text}@0.1"),)
            ),
            check_velocity,
        )
        for text in ("height=0.04", "height=-0.04", "pitch=10", "pitch=-10")
    ]


def push_rows(speed: float, share: float, robots: tuple[str, ...]) -> list[Row]:
    """Return a row for each direction; seed s has phase s % 4, and noise of its own."""
    place = f"at {speed:g} m/s" if speed else "in place"
    return [
        Row(
            f"push {share:g} LIP {place}, {direction} deg",
            lambda robot, seed, direction=direction: pushed(
                robot, seed, speed, share, direction, seed % 4
            ),
            check_push,
            robots,
            allowed=0.05,
            seeds=20,
        )
        for direction in range(0, 360, 45)
    ]


def start_and_stop(robot: str, seed: int) -> WalkSettings:
    """Return a walk from a stand to 1 m/s and back to a stand."""
    velocities = (VelocityRequest(1.0, 0.0, 0.0, START), VelocityRequest(0.0, 0.0, 0.0, 4.0))
    return walk(robot, seed, (1.0, 0.0, 0.0), 7.0, velocities=velocities, gait=Gait.AUTO)


def make_rows() -> list[Row]:
    """Return all rows."""
    small = [(-0.8, 0, 0), (0.5, 0, 0), (1, 0, 0), (1.5, 0, 0), (0, 0.5, 0), (0, -0.5, 0)]
    small += [(0, 0, 2), (0, 0, -2), (0.6, 0.3, 1), (-0.4, -0.3, 1)]
    large = [(-0.5, 0, 0), (0.5, 0, 0), (1, 0, 0), (0, 0.4, 0), (0, -0.4, 0), (0, 0, 1), (0, 0, -1)]
    return [
        *(velocity_row(_velocity_name(v), v, SMALL) for v in small),
        *(velocity_row(f"{_velocity_name(v)} (b1)", v, B1) for v in large),
        Row("30 s at 0.5 m/s", lambda r, s: walk(r, s, (0.5, 0, 0), 30.5), check_straight),
        Row("0.6 m/s at 250 Hz", _at_rate(250.0), check_velocity),
        Row("0.6 m/s at 1000 Hz", _at_rate(1000.0), check_velocity),
        Row("stand, 1 m/s, stand", start_and_stop, check_start_and_stop),
        *gait_walk_rows(),
        *body_rows(),
        *push_rows(0.0, 1.3, SMALL),
        *push_rows(0.6, 1.0, SMALL),
        *push_rows(0.0, 1.2, B1),
        *push_rows(0.6, 1.0, B1),
        *(
            plant_row(f"slope 15 deg, {heading} deg", slope_deg=15.0, slope_heading_deg=heading)
            for heading in range(0, 360, 45)
        ),
        terrain_row("platform 8 cm", 13.0, 0.05, 20, step_height=0.08),
        terrain_row("platform 8 cm, 30 deg", 13.0, 0.05, 20, step_height=0.08, step_heading_deg=30),
        terrain_row("stairs 5 cm", 19.0, stairs_height=0.05, stairs_tread=0.3),
        terrain_row("blocks 3 cm", 16.0, block_height=0.03),
        plant_row("soft ground 1 cm", soft_ground_sink=0.01),
        plant_row("friction 0.4 at 0.5 m/s", (0.5, 0, 0), friction=0.4),
        plant_row("friction 0.2 in place", (0, 0, 0), friction=0.2),
        payload_row("payload 30 %, 3 cm ahead", (0.03, 0.0, 0.1)),
        payload_row("payload 30 %, 3 cm left", (0.0, 0.03, 0.1)),
        plant_row("latency 10 ms, 0.6 m/s", (0.6, 0, 0), predicted_delay=0.014, extra_delay=0.01),
        plant_row("latency 10 ms unknown, 0.6 m/s", (0.6, 0, 0), extra_delay=0.01),
        plant_row("5 % lost frames", lost_frames=5.0),
        *(plant_row(f"armature x {x:g}", armature_scale=x) for x in (0.5, 2.0)),
        *(plant_row(f"joint friction x {x:g}", joint_friction_scale=x) for x in (0.5, 2.0)),
        plant_row("motor lag 5 ms", motor_lag=0.005),
        plant_row("backlash 0.5 deg", backlash_deg=0.5),
        *(plant_row(f"trunk mass x {x:g}", flaws=Flaws(trunk_mass_scale=x)) for x in (0.9, 1.1)),
    ]


def _velocity_name(velocity: tuple[float, float, float]) -> str:
    names = ("vx", "vy", "yaw")
    return ", ".join(f"{n} {v:g}" for n, v in zip(names, velocity, strict=True) if v)


def _at_rate(rate: float) -> Callable[[str, int], WalkSettings]:
    return lambda robot, seed: walk(robot, seed, (0.6, 0, 0), plant={"control_rate": rate})


ROWS = {row.name: row for row in make_rows()}


@dataclass
class WalkOutcome(RunOutcome):
    """Figures of a run, each with its largest allowed value."""

    figures: dict[str, tuple[float, float]] = field(default_factory=dict)


def run(job: Job) -> WalkOutcome:
    """Run one row of a robot with a seed."""
    name, robot, seed = str(job[0]), str(job[1]), int(job[2])
    row = ROWS[name]
    try:
        log = run_walk(row.settings(robot, seed))
        figures = row.check(log, summarise(log))
    except Error as problem:
        if "fell while its motors held" not in str(problem):
            raise
        return WalkOutcome(False, str(problem), {"falls before the first tick": (1.0, 0.0)})
    misses = [f"{k} {v:.3g} > {limit:g}" for k, (v, limit) in figures.items() if not v <= limit]
    return WalkOutcome(not misses, ", ".join(misses), figures)


def cell(row: Row, outcomes: list[WalkOutcome]) -> str:
    """Return the cell of a row and a robot: passed seeds, and the worst of each missed figure."""
    passed = sum(outcome.ok for outcome in outcomes)
    text = f"{passed} of {len(outcomes)}"
    if passed >= (1.0 - row.allowed) * len(outcomes):
        return text
    worst: dict[str, tuple[float, float]] = {}
    for outcome in outcomes:
        for name, (value, limit) in outcome.figures.items():
            if not value <= limit:
                worst[name] = (max(value, worst.get(name, (value,))[0]), limit)
    return f"**{text}**: " + "; ".join(f"{k} {v:.3g} (<= {b:g})" for k, (v, b) in worst.items())


def parse_options() -> argparse.Namespace:
    """Return the options of the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_seed_options(parser, 5)
    parser.add_argument("--row", action="append", metavar="NAME", help="rows that begin so; all")
    parser.add_argument("--robots", nargs="+", default=list(ROBOTS), choices=ROBOTS)
    parser.add_argument("--quick", action="store_true", help=f"one seed of {len(QUICK)} rows")
    parser.add_argument(
        "--most",
        type=lambda text: parse_integer(text, 1),
        metavar="N",
        help="largest number of seeds, also of rows that need 20",
    )
    parser.add_argument("--list", action="store_true", help="print the names of all rows")
    return parser.parse_args()


def main() -> int:
    """Run the chosen rows and print the table; return 3 if a row misses what is asked."""
    options = parse_options()
    if options.list:
        print("\n".join(ROWS))
        return 0
    starts = tuple(options.row) if options.row else QUICK if options.quick else ("",)
    rows = [row for row in ROWS.values() if row.name.startswith(starts)]
    if not rows:
        print(f"--row: got {options.row}; --list has the names", file=sys.stderr)
        return 2

    def seeds(row: Row) -> range:
        count = 1 if options.quick else max(options.count, row.seeds)
        return range(options.first, options.first + min(count, options.most or count))

    cases = [(row, robot) for row in rows for robot in options.robots if robot in row.robots]
    jobs: list[Job] = [(row.name, robot, seed) for row, robot in cases for seed in seeds(row)]
    done = dict(zip(jobs, run_seeds(run, WalkOutcome, jobs, options), strict=True))
    print("| row | " + " | ".join(options.robots) + " |")
    print("|---" * (len(options.robots) + 1) + "|")
    missed = 0
    for row in rows:
        cells = []
        for robot in options.robots:
            outcomes = [done[row.name, robot, s] for s in seeds(row)] if robot in row.robots else []
            cells.append(cell(row, outcomes) if outcomes else "")
            missed += "**" in cells[-1]
        print(f"| {row.name} | " + " | ".join(cells) + " |")
    print(f"{missed} of {len(cases)} cells miss what is asked")
    result = [{"job": list(job), **asdict(outcome)} for job, outcome in done.items()]
    write_json(options.json, {"runs": result}, 1)
    return 3 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
