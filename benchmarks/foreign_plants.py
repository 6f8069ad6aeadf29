# SPDX-License-Identifier: BSD-3-Clause
"""Foreign plants: stand, rise, move, push and walk robots from MJCF files that are not ours.

    python benchmarks/foreign_plants.py --robot go1 --json FILE          # variants of our model
    python benchmarks/foreign_plants.py --robot go2 --mjcf scene.xml --json FILE

Each model is measured with one seed, real sensors and a physics step of 1 ms. Impulses are in
percent of the push limit of the file's masses and friction, and of its LIP push limit while the
robot trots. Results are appended to FILE, one JSON object a model.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import surefoot
from foreign_mjcf import VARIANTS, write_mjcf
from surefoot import Error, Mode, RequestStatus
from surefoot.assess.condition import Condition
from surefoot.assess.condition_plant import plant_of
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.foreign_stance import plant_stance
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_outcome import judge_push
from surefoot.assess.robot_source import MjcfSource, RobotSource
from surefoot.assess.stand_outcome import judge_stand
from surefoot.assess.walking.walk_rollout import walk_out, walking_plant_of
from surefoot.assess.walking.walk_units import (
    PUSH_DURATION,
    QUIET_TIME,
    RECOVERY_TIME,
    WalkUnit,
)
from surefoot.assess.work_units import PushUnit, StandUnit
from surefoot.robot.description import describe_robot
from surefoot.robot.power_level import power_level
from surefoot.sim import Lift, Plant, PlantSettings, Push
from surefoot.stand import StandSettings, parse_reference, run_stand, summarise
from surefoot.walk.push_recovery import recovered_ticks

LEVELS = (50.0, 60.0, 80.0, 100.0, 110.0)  # [% of the push limit]
DIRECTIONS = 22.5 * np.arange(16)  # [deg]
VELOCITIES = ((0.5, 0.0, 0.0), (0.0, 0.3, 0.0), (0.0, 0.0, 1.0))  # [m/s, m/s, rad/s]
TROT_DIRECTIONS = 90.0 * np.arange(4)  # [deg]
MOVES = ("height=-0.04@1", "roll=8,yaw=6@3", "x=0.02,y=0.02,pitch=-5@5", "height=0.01@7")
RISES = 2  # drops from which the robot rises
SUREFOOT = ControllerUnderTest()


def quiet(source: RobotSource, condition: Condition) -> dict[str, Any]:
    """Stand for 4.4 s; the tolerances are those of a scorecard."""
    unit = StandUnit(condition, 0.0, 0)
    stood = judge_stand(unit.simulate(source, SUREFOOT), condition)
    return {"passed": stood.passes(condition), "height_mm": stood.height_mm, "mm": stood.foot_mm}


def pushes(source: RobotSource, condition: Condition, limits: PushLimits) -> dict[str, Any]:
    """Push with LEVELS in 16 directions; return the largest levels passed in all directions."""
    survived, in_place = [], []
    for degrees in DIRECTIONS:
        limit = limits.push_limit(condition, float(degrees), 0.1, 0.0).limit
        unit = PushUnit(condition, float(degrees), 0.1, 0.0, 0, limit)
        outcomes = []
        for level in LEVELS:
            trajectory = unit.simulate(source, SUREFOOT, level)
            outcomes.append(judge_push(trajectory, condition.quiet_s, 0.1))
            if not outcomes[-1].survived:
                break
        survived.append(_passed([o.survived for o in outcomes]))
        in_place.append(_passed([o.in_place for o in outcomes]))
    return {"survived": survived, "in_place": in_place}


def _passed(passes: list[bool]) -> float:
    count = passes.index(False) if False in passes else len(passes)
    return LEVELS[count - 1] if count else 0.0


def rises(source: MjcfSource | str) -> dict[str, Any]:
    """Let the robot rise from RISES random lying poses, and stand for 1.5 s."""
    plant = _plant(source)
    why = [_rise(plant, seed) for seed in range(RISES)]
    return {"rose": why.count(""), "of": RISES, "why": [text for text in why if text]}


def _rise(plant: Plant, seed: int) -> str:
    """Return why the robot did not rise, or ""."""
    plant.reseed(seed)
    try:
        state = plant.reset_lying(np.random.default_rng([seed, 99]))
    except Error as problem:
        return str(problem)
    options = surefoot.SupervisorOptions(power_level=power_level(plant.robot.name))
    supervisor = surefoot.Supervisor(plant.robot, options=options)

    def run(seconds: float, until: Callable[[], bool] = lambda: False) -> None:
        nonlocal state
        for _ in range(round(500 * seconds)):
            if until():
                return
            state = plant.step(supervisor.update(state))

    run(20.0, lambda: supervisor.arming.ready)
    if supervisor.arm() != RequestStatus.ACCEPTED:
        return f"not armed: {supervisor.arming.failures(plant.robot)}"
    run(0.002)
    if supervisor.request(Mode.RISE) != RequestStatus.ACCEPTED:
        return "rise refused"
    run(0.002)
    run(60.0, lambda: supervisor.mode != Mode.RISE)
    run(1.5)
    truth = plant.truth
    if supervisor.mode != Mode.STAND or truth.fell or np.abs(truth.v[:6]).max() > 0.05:
        return f"{supervisor.mode.name}, {supervisor.damping_fault.name}"
    return ""


def moves(source: MjcfSource | str) -> dict[str, Any]:
    """Follow requested body poses for 9 s."""
    references = tuple(parse_reference(text) for text in MOVES)
    plant = PlantSettings(physics_dt=0.001, seed=1)
    log = run_stand(StandSettings(_description(source), 9.0, plant, references=references))
    s = summarise(log)
    keys = ("height_error_mm", "tilt_error_deg", "yaw_error_deg")
    return {"fell": s["fell"], "settled": s["settled"], **{key: s[key] for key in keys}}


def lifts(source: MjcfSource | str) -> dict[str, Any]:
    """Lift the trunk by 6 cm and put it down; lift a foot by 3 cm and let it go."""
    stands = {}
    for lift in (Lift("trunk", 1.0, 1.0, 0.06, 0.4, 0.1, 0.2), Lift("FR", 1.0)):
        plant = _plant(source)
        plant.add_lift(lift)
        level = power_level(plant.robot.name)
        options = surefoot.SupervisorOptions(power_level=level, start=surefoot.Start.STANDING)
        supervisor = surefoot.Supervisor(plant.robot, options=options)
        state = plant.reset()
        for _ in range(2500):
            state = plant.step(supervisor.update(state))
        truth = plant.truth
        still = np.abs(truth.v).max() < 0.05 and bool(np.all(truth.contact))
        stands[lift.part] = bool(supervisor.mode == Mode.STAND and not truth.fell and still)
    return stands


def walks(source: RobotSource, condition: Condition) -> dict[str, Any]:
    """Walk with each of VELOCITIES for 4 s."""
    figures = {}
    for velocity in VELOCITIES:
        try:
            unit = WalkUnit(condition, 0.0, velocity, 4.0, 0)
            walk = unit.run(source, ControllerUnderTest(walks=True), lambda: None)
            figures[str(velocity)] = {"fell": walk["fell"], "rmse": walk["velocity_rmse"]}
        except Error as problem:
            figures[str(velocity)] = {"fell": True, "rmse": None, "why": str(problem)}
    return figures


class TrotInPlace:
    """A walking controller that trots at velocity 0."""

    def __init__(self, robot: surefoot.Robot) -> None:
        self._controller = surefoot.WalkController(robot)
        self._controller.gait = surefoot.Gait.TROT

    def update(self, state: surefoot.LowState, velocity: surefoot.WalkVelocity) -> surefoot.LowCmd:
        """Return the command of a tick."""
        self._controller.set_velocity(velocity)
        return self._controller.update(state)


def trot_pushes(source: RobotSource, condition: Condition, limits: PushLimits) -> dict[str, Any]:
    """Push with 1.0 LIP push limit while the robot trots in place; count the recoveries."""
    plant, recovered = walking_plant_of(source, condition), []
    for k, degrees in enumerate(TROT_DIRECTIONS):
        limit = limits.push_limit(condition, float(degrees), PUSH_DURATION, 0.0).lip
        begin = QUIET_TIME + 1.5 + 0.1 * (k % 4)
        plant.reseed(k, [Push(float(degrees), limit, PUSH_DURATION, begin)])
        judged = begin + PUSH_DURATION + RECOVERY_TIME
        walk = walk_out(plant, condition, TrotInPlace(plant.robot), (), judged + 1.0)
        last = recovered_ticks(walk)[round(judged * walk.rate) :]
        recovered.append(not walk.fell and bool(np.all(last)))
    return {"recovered": sum(recovered), "of": len(recovered), "directions": recovered}


def _description(source: MjcfSource | str) -> Any:
    if isinstance(source, str):
        return describe_robot(source)
    return describe_robot(source.robot).with_mjcf(source.mjcf)


def _plant(source: MjcfSource | str) -> Plant:
    return Plant(_description(source), PlantSettings(physics_dt=0.001, seed=1))


def measure(name: str, source: MjcfSource | str) -> dict[str, Any]:
    """Return all figures of a model."""
    start, plant = time.monotonic(), _plant(source)
    condition = Condition("level ground", friction=plant.friction)
    limits = PushLimits(plant.robot, plant_stance(plant))
    row: dict[str, Any] = {
        "name": name,
        "robot": plant.robot.name,
        "friction": plant.friction,
        "mass_kg": limits.stance.mass,
        "limit_ns": [
            round(limits.push_limit(condition, a, 0.1, 0.0).limit, 2) for a in (0.0, 90.0)
        ],
        "quiet": quiet(source, condition),
        "moves": moves(source),
        "lifts": lifts(source),
        "rises": rises(source),
        "walks": walks(source, condition),
        "trot_pushes": trot_pushes(source, replace(condition), limits),
        "pushes": pushes(source, condition, limits),
    }
    row["seconds"] = round(time.monotonic() - start)
    plant_of.cache_clear()
    walking_plant_of.cache_clear()
    return row


def text(row: dict[str, Any]) -> str:
    """Return a row as a line of text."""
    m, r, t, p = row["moves"], row["rises"], row["trot_pushes"], row["pushes"]
    lifts_text = f"{sum(row['lifts'].values())}/{len(row['lifts'])}"
    walks_text = " ".join(
        "fell" if walk["fell"] else ",".join(f"{v:.3f}" for v in walk["rmse"])
        for walk in row["walks"].values()
    )
    return (
        f"{row['robot']} {row['name']}: friction {row['friction']:g}, {row['mass_kg']:.2f} kg; "
        f"quiet {row['quiet']['passed']}, moves {m['settled']}, lifts {lifts_text}, "
        f"rises {r['rose']}/{r['of']}; survived {min(p['survived']):.0f} %, in place "
        f"{min(p['in_place']):.0f} %; walks {walks_text}; trot pushes {t['recovered']}/{t['of']}"
    )


def main() -> int:
    """Measure the variants of our model, or one MJCF; append the results to a file."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--robot", default="go1")
    parser.add_argument("--mjcf", help="an MJCF instead of the variants")
    parser.add_argument("--variant", action="append", choices=VARIANTS, help="default: all")
    parser.add_argument("--plain", action="store_true", help="our own plant, for comparison")
    parser.add_argument("--json", help="file to which a line is appended for each model")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        sources: dict[str, MjcfSource | str] = {}
        if options.plain:
            sources["our plant"] = options.robot
        elif options.mjcf:
            sources[options.mjcf] = MjcfSource(options.robot, options.mjcf)
        else:
            for name in options.variant or VARIANTS:
                path = Path(folder) / f"{name}.xml"
                write_mjcf(path, *VARIANTS[name], robot=options.robot)
                sources[name] = MjcfSource(options.robot, str(path))
        for name, source in sources.items():
            row = measure(name, source)
            print(text(row), flush=True)
            if options.json:
                with Path(options.json).open("a", encoding="utf-8") as file:
                    file.write(json.dumps(row, default=float) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
