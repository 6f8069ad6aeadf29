"""What a supervised robot is to do about a fault, and how soon."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

from surefoot._core import Error, FaultReaction, fault_table

HOLD = 0.010  # [s] the last good command is repeated at most this long
SLACK = 1e-9  # [s] of rounding


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
        unless: Name of a fault whose damping will do as well, for what only shows when the robot
            moves.
    """

    reaction: Reaction
    within: float = 0.0
    fault: str = ""
    unless: str = ""


WATCH = Expectation(Reaction.WATCH)
REFUSE = Expectation(Reaction.REFUSE, 0.020)


def damp(within: float) -> Expectation:
    """Return that the motors damp within a time [s], for whichever fault is seen first."""
    return Expectation(Reaction.DAMP, within)


def refuse(within: float) -> Expectation:
    """Return that arming and rising are refused within a time [s]."""
    return Expectation(Reaction.REFUSE, within)


def stays(fault: str) -> Expectation:
    """Return that a rise is refused for a fault: latched before the body leaves the ground."""
    return replace(as_table(fault), reaction=Reaction.STAY)


def unless(fault: str) -> Expectation:
    """Return that it goes on, unless it is seen and damped as that fault."""
    return Expectation(Reaction.WATCH, unless=_row(fault).fault)


def as_table(fault: str, later: float = 0.0) -> Expectation:
    """Return what fault_table() says of a fault.

    Args:
        fault: Its name.
        later: By how much the table's time begins later than the injection [s].
    """
    row = _row(fault)
    return replace(row, within=row.within + later)


def sits(fault: str, later: float = 0.0) -> Expectation:
    """Return that it sits down for a fault that a robot which stands already goes on with."""
    return replace(as_table(fault, later), reaction=Reaction.SIT)


def _row(fault: str) -> Expectation:
    for info in fault_table():
        if info.name == fault:
            return Expectation(_REACTIONS[info.reaction], info.detect, fault)
    names = ", ".join(info.name for info in fault_table())
    raise Error(f"fault: got '{fault}', expected one of {names}")


_REACTIONS = {
    FaultReaction.WATCH: Reaction.WATCH,
    FaultReaction.DEGRADE: Reaction.DEGRADE,
    FaultReaction.SIT: Reaction.SIT,
    FaultReaction.DAMP: Reaction.DAMP,
}
