"""What a robot does after a fault has begun, until it has done what is expected of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot._core import FaultId, Mode, RequestStatus
from surefoot.faults.approach import RISE_TIME
from surefoot.faults.judge import is_damping
from surefoot.faults.reaction import SLACK, Expectation, Reaction
from surefoot.faults.scene import PERIOD, Scene
from surefoot.sim.truth import has_fallen

QUIET = 0.6  # [s] that a latched damping, and a rest, are looked at
STAND_TIME = 3.0  # [s] that standing is looked at, and waited for a fall
LIE_TIME = 1.2  # [s] of lying
SIT_TIME = 9.0  # [s] that sitting down may take


@dataclass
class Observed:
    """What was seen; times since the fault was there to be seen [s], None for never.

    Attributes:
        damped: When the motors damped first.
        torques_again: When they had torques again after that.
        sat: When it began to sit down, or let go on its way up.
        passive: When it lay, motors damping, not latched.
        stood: When it stood first.
        fell: When, while standing, something but a foot touched the ground, or it tilted beyond 60
            degrees.
        refused: When arming and rising were refused first; asked in every period from the time
            stated on.
        accepted: When one of them was accepted; then it is asked no more.
        mode: At the end.
        speed: Greatest speed of the body downwards [m/s].
        lowest: Of the body's height [m].
        rose: Greatest height of the body above the lowest before it [m].
        time: Seen for so long.
        told: When the fault expected was told.
        why: Name of the fault that the damping latched for.
        answers: What a request to rise and one to arm were told last.
    """

    damped: float | None = None
    torques_again: float | None = None
    sat: float | None = None
    passive: float | None = None
    stood: float | None = None
    fell: float | None = None
    refused: float | None = None
    accepted: float | None = None
    mode: Mode = Mode.PASSIVE
    speed: float = 0.0
    lowest: float = math.inf
    rose: float = 0.0
    time: float = 0.0
    told: float | None = None
    why: str = ""
    answers: str = ""


def observe(scene: Scene, expect: Expectation, mode: str) -> Observed:
    """Go on with a scene whose fault begins now, for as long as the expectation needs."""
    seen, periods = Observed(), 0
    refuses = expect.reaction == Reaction.REFUSE and mode == "lying"
    scene.begin()
    count = _count(scene, expect)
    for k in range(round(_longest(expect, mode) / PERIOD)):
        due = k * PERIOD >= expect.within - SLACK or not scene.armed
        if refuses and due and seen.accepted is None:
            _ask(scene, seen, k * PERIOD)
        scene.step()
        if periods or scene.fault.judged(scene.plant):
            _look(scene, seen, periods * PERIOD)
            if seen.told is None and _count(scene, expect) > count:
                seen.told = periods * PERIOD
            periods += 1
        if _enough(seen, expect, mode):
            break
    if mode == "lying" and expect.reaction in (Reaction.WATCH, Reaction.DEGRADE):
        _ask(scene, seen, periods * PERIOD)
    return seen


def _longest(expect: Expectation, mode: str) -> float:
    if expect.reaction == Reaction.SIT:
        return expect.within + SIT_TIME
    if expect.reaction in (Reaction.DAMP, Reaction.STAY):
        return expect.within + STAND_TIME
    if mode == "rising":
        return RISE_TIME
    if expect.reaction == Reaction.REFUSE:
        return expect.within + LIE_TIME
    return LIE_TIME if mode == "lying" else STAND_TIME


def _enough(seen: Observed, expect: Expectation, mode: str) -> bool:
    """Return whether what is expected, or its contrary, has been seen for long enough."""
    since = seen.damped if expect.reaction != Reaction.SIT else seen.passive
    if expect.reaction in (Reaction.DAMP, Reaction.SIT, Reaction.STAY):
        return since is not None and seen.time > since + QUIET
    if mode != "rising":
        return False
    ends = [t for t in (seen.stood, seen.damped) if t is not None]
    return bool(ends) and seen.time > min(ends) + 2.0 * QUIET


def _look(scene: Scene, seen: Observed, time: float) -> None:
    now, damps = scene.supervisor.mode, is_damping(scene.command)
    if damps and seen.damped is None:
        seen.damped = time
    if not damps and seen.damped is not None and seen.torques_again is None:
        seen.torques_again = time
    if now in (Mode.SIT, Mode.PASSIVE) and seen.sat is None:
        seen.sat = time
    if now == Mode.PASSIVE and damps and seen.passive is None:
        seen.passive = time
    if now == Mode.STAND and seen.stood is None:
        seen.stood = time
    plant = scene.plant
    if now == Mode.STAND and seen.fell is None and has_fallen(plant.data, plant.handles):
        seen.fell = time
    seen.mode, seen.time, seen.why = now, time, scene.supervisor.reason.name.lower()
    height = float(plant.data.qpos[2])
    seen.lowest = min(seen.lowest, height)
    seen.rose = max(seen.rose, height - seen.lowest)
    seen.speed = max(seen.speed, -float(plant.data.qvel[2]))


def _count(scene: Scene, expect: Expectation) -> int:
    """Return how often the fault expected has begun."""
    if not expect.fault:
        return 0
    return int(scene.supervisor.faults.count(FaultId[expect.fault.upper()]))


def _ask(scene: Scene, seen: Observed, time: float) -> None:
    """Ask to rise, and where that is refused to arm; a robot that was disarmed may be again."""
    rise = scene.supervisor.request(Mode.RISE)
    done = rise == RequestStatus.ACCEPTED or (scene.armed and rise == RequestStatus.NOT_ARMED)
    arm = None if done else scene.supervisor.arm()
    seen.answers = f"rise: {rise.name}" + (f", arm: {arm.name}" if arm is not None else "")
    if RequestStatus.ACCEPTED in (rise, arm):
        seen.accepted = time if seen.accepted is None else seen.accepted
    elif seen.refused is None:
        seen.refused = time
