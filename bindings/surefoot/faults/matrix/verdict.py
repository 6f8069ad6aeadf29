"""Verdict on a cell: compares an observation with the expectation."""

from __future__ import annotations

import math

from surefoot._core import Mode
from surefoot.faults.expectation import STOP_TIME, TIME_TOLERANCE, Expectation, Reaction
from surefoot.faults.matrix.observation import Observation

GRAVITY = 9.81  # [m/s^2]
# Rise of the base, as a share of the standing height, above which the body has left the ground.
# Measured: folding legs raise the bodies of healthy robots by 0.04 to 0.07 in the median of 100
# lying poses, and by at most 0.36 (docs/reference/fault-injection.md).
MAX_LYING_RISE_SHARE = 0.4


def allowed_descent_speed(height: float) -> float:
    """Return the largest allowed descent speed [m/s]: half of the speed after a free fall.

    Args:
        height: Height of the fall [m].
    """
    # The factor 0.5 is chosen: small robots descend at 0.5 m/s with damping motors, and b1 descends
    # at 1 m/s (docs/reference/fault-injection.md).
    return 0.5 * math.sqrt(2.0 * GRAVITY * height)


def reaction_time(observed: Observation, expectation: Expectation) -> float | None:
    """Return the time of the expected reaction [s]; None if the reaction was not observed.

    A refusal has no time (None), because requests begin only after Expectation.within.
    """
    return {
        Reaction.DAMP: observed.damped_at,
        Reaction.SIT: observed.sat_at,
        Reaction.REFUSE: None,
        Reaction.STAY: observed.damped_at,
        Reaction.WATCH: observed.reported_at,
        Reaction.DEGRADE: observed.reported_at,
        Reaction.STAND: observed.reported_at,
    }[expectation.reaction]


def deviations(
    observed: Observation, expectation: Expectation, mode: str, height: float
) -> list[str]:
    """Return the deviations of an observation from the expectation as text; empty if none.

    Args:
        observed: Observation of the reaction.
        expectation: Expected reaction.
        mode: Mode in which the fault began.
        height: Height of the standing base [m].
    """
    if expectation.reaction == Reaction.DAMP:
        return _damps(observed, expectation)
    if expectation.reaction == Reaction.STAY:
        return _stays(observed, expectation, height)
    if expectation.reaction == Reaction.SIT:
        return _sits(observed, expectation, mode) + descends_too_fast(observed, height)
    if expectation.reaction == Reaction.REFUSE:
        return _refuses(observed)
    return _goes_on(observed, expectation, mode)


def descends_too_fast(observed: Observation, height: float) -> list[str]:
    """Return a list with one text if the descent was too fast; otherwise an empty list.

    Args:
        observed: Observation of the reaction.
        height: Height of the standing base [m].
    """
    if observed.max_descent_speed <= allowed_descent_speed(height):
        return []
    return [
        f"went down at {observed.max_descent_speed:.2f} m/s, "
        f"expected at most {allowed_descent_speed(height):.2f} m/s"
    ]


def unreported_fault(observed: Observation, expectation: Expectation) -> list[str]:
    """Return a list with one text if the expected fault was reported too late or not at all.

    Otherwise return an empty list.
    """
    if not expectation.fault:
        return []
    if observed.reported_at is None:
        return [f"fault {expectation.fault} was not reported"]
    if observed.reported_at > expectation.within + TIME_TOLERANCE:
        return [f"fault {expectation.fault} reported after {_ms(observed.reported_at)}"]
    return []


def _damps(observed: Observation, expectation: Expectation) -> list[str]:
    if observed.damped_at is None:
        return [f"motors never damped, {observed.mode.name} at the end"]
    problems = []
    if observed.damped_at > expectation.within + TIME_TOLERANCE:
        problems.append(
            f"damped after {_ms(observed.damped_at)}, expected {_ms(expectation.within)}"
        )
    if observed.mode != Mode.DAMPING:
        problems.append(f"not latched: {observed.mode.name} at the end")
    if observed.torque_resumed_at is not None:
        problems.append(f"torques again after {_ms(observed.torque_resumed_at)}")
    return problems


def _stays(observed: Observation, expectation: Expectation, height: float) -> list[str]:
    problems = _damps(observed, expectation)
    if observed.damped_at is not None and observed.latch_reason != expectation.fault:
        problems.append(f"latched for {observed.latch_reason}, expected {expectation.fault}")
    if observed.max_rise > MAX_LYING_RISE_SHARE * height:
        problems.append(f"rose by {100 * observed.max_rise:.0f} cm")
    return problems


def _sits(observed: Observation, expectation: Expectation, mode: str) -> list[str]:
    if observed.sat_at is None:
        return [f"never sat down, {observed.mode.name} at the end"]
    problems = []
    within = expectation.within + (STOP_TIME if mode == "walking" else 0.0)
    if observed.sat_at > within + TIME_TOLERANCE:
        problems.append(f"sat down after {_ms(observed.sat_at)}, expected {_ms(within)}")
    if observed.passive_at is None:
        problems.append(f"did not lie down, {observed.mode.name} at the end")
    return problems


def _refuses(observed: Observation) -> list[str]:
    problems = []
    if observed.accepted_at is not None:
        problems.append(f"not refused after {_ms(observed.accepted_at)} ({observed.answers})")
    elif observed.refused_at is None:
        problems.append("arming and rising were never requested")
    if observed.damped_at is None or observed.torque_resumed_at is not None:
        problems.append("the motors had torques")
    return problems


def _goes_on(observed: Observation, expectation: Expectation, mode: str) -> list[str]:
    if (
        expectation.alternative
        and observed.latch_reason == expectation.alternative
        and observed.mode == Mode.DAMPING
    ):
        return []
    if mode == "lying":
        problems = (
            [] if observed.accepted_at is not None else [f"rise refused ({observed.answers})"]
        )
        return problems + _rests(observed)
    problems = []
    if observed.damped_at is not None:
        problems.append(f"damped after {_ms(observed.damped_at)}")
    walks = mode == "walking" and expectation.reaction != Reaction.STAND
    expected = Mode.WALK if walks else Mode.STAND
    if observed.mode != expected:
        problems.append(f"{observed.mode.name} at the end, expected {expected.name}")
    if observed.fell_at is not None:
        problems.append(f"fell after {_ms(observed.fell_at)}")
    return problems


def _rests(observed: Observation) -> list[str]:
    """Return a list with one text if the robot does not lie with damping motors at the end."""
    lies = observed.mode in (Mode.PASSIVE, Mode.DAMPING) and observed.damped_at is not None
    return [] if lies else [f"{observed.mode.name} at the end, expected to lie"]


def _ms(seconds: float) -> str:
    return f"{1e3 * seconds:.0f} ms"
