"""Whether what was seen is what is expected."""

from __future__ import annotations

import math

from surefoot._core import Mode
from surefoot.faults.observe import Observed
from surefoot.faults.reaction import SLACK, Expectation, Reaction

GRAVITY = 9.81  # [m/s^2]
LYING_SHARE = 0.4  # of its standing height: legs that fold prop healthy bodies up by 0.36 at most


def fall_speed(height: float) -> float:
    """Return the speed that counts as a fast fall: half of a free fall's from a height [m/s]."""
    return 0.5 * math.sqrt(2.0 * GRAVITY * height)


def reaction_time(seen: Observed, expect: Expectation) -> float | None:
    """Return when the reaction expected came [s]; None too of one that has no moment.

    A refusal is asked for from the time stated on, not looked for before.
    """
    return {
        Reaction.DAMP: seen.damped,
        Reaction.SIT: seen.sat,
        Reaction.REFUSE: None,
        Reaction.STAY: seen.damped,
        Reaction.WATCH: seen.told,
        Reaction.DEGRADE: seen.told,
    }[expect.reaction]


def shortcomings(seen: Observed, expect: Expectation, mode: str, height: float) -> list[str]:
    """Return in words what is not as expected; empty if all is.

    Args:
        seen: What was seen.
        expect: What is expected.
        mode: In which the fault began.
        height: Of the standing base [m].
    """
    if expect.reaction == Reaction.DAMP:
        return _damps(seen, expect)
    if expect.reaction == Reaction.STAY:
        return _stays(seen, expect, height)
    if expect.reaction == Reaction.SIT:
        return _sits(seen, expect) + falls_fast(seen, height)
    if expect.reaction == Reaction.REFUSE:
        return _refuses(seen)
    return _goes_on(seen, expect, mode)


def falls_fast(seen: Observed, height: float) -> list[str]:
    """Return that it went down too fast, if it did."""
    if seen.speed <= fall_speed(height):
        return []
    return [f"went down at {seen.speed:.2f} m/s, expected {fall_speed(height):.2f}"]


def untold(seen: Observed, expect: Expectation) -> list[str]:
    """Return that the operator could not read the fault, or too late, if so."""
    if not expect.fault:
        return []
    if seen.told is None:
        return [f"fault {expect.fault} is not told"]
    if seen.told > expect.within + SLACK:
        return [f"fault {expect.fault} told after {_ms(seen.told)}"]
    return []


def _damps(seen: Observed, expect: Expectation) -> list[str]:
    if seen.damped is None:
        return [f"motors never damped, {seen.mode.name} at the end"]
    found = []
    if seen.damped > expect.within + SLACK:
        found.append(f"damped after {_ms(seen.damped)}, expected {_ms(expect.within)}")
    if seen.mode != Mode.DAMPING:
        found.append(f"not latched: {seen.mode.name} at the end")
    if seen.torques_again is not None:
        found.append(f"torques again after {_ms(seen.torques_again)}")
    return found


def _stays(seen: Observed, expect: Expectation, height: float) -> list[str]:
    found = _damps(seen, expect)
    if seen.damped is not None and seen.why != expect.fault:
        found.append(f"latched for {seen.why}, expected {expect.fault}")
    if seen.rose > LYING_SHARE * height:
        found.append(f"rose by {100 * seen.rose:.0f} cm")
    return found


def _sits(seen: Observed, expect: Expectation) -> list[str]:
    if seen.sat is None:
        return [f"never sat down, {seen.mode.name} at the end"]
    found = []
    if seen.sat > expect.within + SLACK:
        found.append(f"sat down after {_ms(seen.sat)}, expected {_ms(expect.within)}")
    if seen.passive is None:
        found.append(f"did not come to lie, {seen.mode.name} at the end")
    return found


def _refuses(seen: Observed) -> list[str]:
    found = []
    if seen.accepted is not None:
        found.append(f"not refused after {_ms(seen.accepted)} ({seen.answers})")
    elif seen.refused is None:
        found.append("never asked")
    if seen.damped is None or seen.torques_again is not None:
        found.append("the motors got torques")
    return found


def _goes_on(seen: Observed, expect: Expectation, mode: str) -> list[str]:
    if expect.unless and seen.why == expect.unless and seen.mode == Mode.DAMPING:
        return []
    if mode == "lying":
        found = [] if seen.accepted is not None else [f"may not rise ({seen.answers})"]
        return found + _rests(seen)
    found = []
    if seen.damped is not None:
        found.append(f"damped after {_ms(seen.damped)}")
    if seen.mode != Mode.STAND:
        found.append(f"{seen.mode.name} at the end, expected STAND")
    if seen.fell is not None:
        found.append(f"fell after {_ms(seen.fell)}")
    return found


def _rests(seen: Observed) -> list[str]:
    lies = seen.mode in (Mode.PASSIVE, Mode.DAMPING) and seen.damped is not None
    return [] if lies else [f"{seen.mode.name} at the end, expected to lie"]


def _ms(seconds: float) -> str:
    return f"{1e3 * seconds:.0f} ms"
