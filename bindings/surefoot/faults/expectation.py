"""What a supervised robot is to do about a fault, and how soon."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

from surefoot._core import Error, FaultReaction, fault_table

MAX_HOLD_TIME = 0.010  # [s] the last good command is repeated at most this long
TIME_TOLERANCE = 1e-9  # [s] of rounding


class Reaction(Enum):
    """What is expected; the value is the word for it in tables."""

    WATCH = "goes on"
    DEGRADE = "goes on with less"
    SIT = "sits down"
    DAMP = "damps, latched"
    REFUSE = "refuses"
    STAY = "stays down, latched"


@dataclass(frozen=True)
class Expectation:
    """A reaction and when it must be there.

    Attributes:
        reaction: What.
        within: Since the fault began [s]; of sitting down, until it begins to.
        fault: Name in fault_table() under which the operator must be able to read it; "" for none.
        alternative: Name of a fault whose damping will do as well, for what only shows when the robot
            moves.
    """

    reaction: Reaction
    within: float = 0.0
    fault: str = ""
    alternative: str = ""


WATCH = Expectation(Reaction.WATCH)
REFUSE = Expectation(Reaction.REFUSE, 0.020)


def expect_damp(within: float) -> Expectation:
    """Return that the motors damp within a time [s], for whichever fault is seen first."""
    return Expectation(Reaction.DAMP, within)


def expect_refusal(within: float) -> Expectation:
    """Return that arming and rising are refused within a time [s]."""
    return Expectation(Reaction.REFUSE, within)


def expect_stay_down(fault: str) -> Expectation:
    """Return that a rise is refused for a fault: latched before the body leaves the ground."""
    return replace(table_expectation(fault), reaction=Reaction.STAY)


def watch_unless(fault: str) -> Expectation:
    """Return that it goes on, unless it is seen and damped as that fault."""
    return Expectation(Reaction.WATCH, alternative=_table_row(fault).fault)


def table_expectation(fault: str, delay: float = 0.0) -> Expectation:
    """Return what fault_table() says of a fault.

    Args:
        fault: Its name.
        delay: By how much the table's time begins later than the injection [s].
    """
    row = _table_row(fault)
    return replace(row, within=row.within + delay)


def expect_sit(fault: str, delay: float = 0.0) -> Expectation:
    """Return that it sits down for a fault that a robot which stands already goes on with."""
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
