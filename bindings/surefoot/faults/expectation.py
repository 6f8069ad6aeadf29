"""Expected reaction of a supervised robot to a fault, and its time limit."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

from surefoot._core import Error, FaultReaction, fault_table

# [s] Time in which a walking robot stops before it sits down: kStopTime (supervisor_walk.cpp).
STOP_TIME = 1.5
MAX_HOLD_TIME = 0.010  # [s] longest command hold: kHoldTime (common/command_times.hpp)
TIME_TOLERANCE = 1e-9  # [s] tolerance of times. Numerical: rounding of sums of control periods


class Reaction(Enum):
    """Expected reaction; the value of each member is its name in tables."""

    WATCH = "goes on"
    DEGRADE = "goes on with less"
    STAND = "stops and stands"
    SIT = "sits down"
    DAMP = "damps, latched"
    REFUSE = "refuses"
    STAY = "stays down, latched"


@dataclass(frozen=True)
class Expectation:
    """A reaction and its time limit.

    Attributes:
        reaction: Expected reaction.
        within: Longest allowed time until the reaction [s]. The time counts from the first
            period in which Fault.is_observable() returns True. The reaction SIT begins with the
            descent; a walking robot may stop for STOP_TIME before it. For REFUSE: time from the
            onset of the fault; after this time, all requests must be refused.
        fault: Name of the fault in fault_table() that the supervisor must report; "" for none.
        alternative: Name of a fault in fault_table(). If the supervisor detects this fault, damping
            is a correct reaction too. Needed for faults that the supervisor may or may not detect,
            because it can detect them only while the robot moves. "" for none.
    """

    reaction: Reaction
    within: float = 0.0
    fault: str = ""
    alternative: str = ""


WATCH = Expectation(Reaction.WATCH)
REFUSE = Expectation(Reaction.REFUSE, 0.020)  # limit [s]: kStaleTime (common/command_times.hpp)


def expect_damp(within: float) -> Expectation:
    """Return the expectation that the robot damps within a time [s], for any fault."""
    return Expectation(Reaction.DAMP, within)


def expect_refusal(within: float) -> Expectation:
    """Return the expectation that arming and rising are refused within a time [s]."""
    return Expectation(Reaction.REFUSE, within)


def expect_stay_down(fault: str) -> Expectation:
    """Return the expectation that the body stays on the ground when a rise is requested.

    The supervisor must detect a fault and latch damping for it.
    """
    return replace(table_expectation(fault), reaction=Reaction.STAY)


def watch_unless(fault: str) -> Expectation:
    """Return the expectation that the robot goes on, or detects a fault and damps for it."""
    return Expectation(Reaction.WATCH, alternative=_table_row(fault).fault)


def table_expectation(fault: str, delay: float = 0.0) -> Expectation:
    """Return the expectation that fault_table() states for a fault.

    Args:
        fault: Name of the fault.
        delay: Time from the injection until the detection time of the table begins [s].
    """
    row = _table_row(fault)
    return replace(row, within=row.within + delay)


def expect_stand(fault: str, delay: float = 0.0, alternative: str = "") -> Expectation:
    """Return the expectation that a walking robot reports a fault, stops and stands.

    Args:
        fault: Name of the fault; "" for none.
        delay: Time from the injection until the detection time of the table begins [s].
        alternative: See Expectation.
    """
    within = next((i.stepping_detection_time for i in fault_table() if i.name == fault), 0.0)
    return Expectation(Reaction.STAND, within + delay, fault, alternative)


def expect_sit(fault: str, delay: float = 0.0) -> Expectation:
    """Return the expectation that the robot sits down for a fault.

    For these faults, fault_table() states a weaker reaction: that of a robot that already stands.

    Args:
        fault: Name of the fault.
        delay: Time from the injection until the detection time of the table begins [s].
    """
    return replace(table_expectation(fault, delay), reaction=Reaction.SIT)


def _table_row(fault: str) -> Expectation:
    for info in fault_table():
        if info.name == fault:
            return Expectation(_REACTIONS[info.reaction], info.detection_time, fault)
    names = ", ".join(info.name for info in fault_table())
    raise Error(f"fault: got '{fault}', expected one of {names}")


_REACTIONS = {
    FaultReaction.WATCH: Reaction.WATCH,
    FaultReaction.DEGRADE: Reaction.DEGRADE,
    FaultReaction.SIT: Reaction.SIT,
    FaultReaction.DAMP: Reaction.DAMP,
}
