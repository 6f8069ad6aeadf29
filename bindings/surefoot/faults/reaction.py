"""What a supervised robot is to do about a fault, and how soon."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

HOLD = 0.010  # [s] the last good command is repeated at most this long
DAMP_BY = 0.020  # [s] after which motors damp where nothing good can be sent


class Reaction(Enum):
    """What is expected; the value is the word for it in tables."""

    WATCH = "goes on"
    DEGRADE = "goes on with less"
    SIT = "sits down"
    DAMP = "damps, latched"
    REFUSE = "refuses"


@dataclass(frozen=True)
class Expectation:
    """A reaction and when it must be there.

    Attributes:
        reaction: What.
        within: Since the fault began [s]; of sitting down, until it begins to.
    """

    reaction: Reaction
    within: float


WATCH = Expectation(Reaction.WATCH, 0.0)
DEGRADE = Expectation(Reaction.DEGRADE, 0.0)
REFUSE = Expectation(Reaction.REFUSE, DAMP_BY)
DAMP = Expectation(Reaction.DAMP, DAMP_BY)


def sit(within: float) -> Expectation:
    """Return that it begins to sit down within a time [s]."""
    return Expectation(Reaction.SIT, within)


def damp(within: float) -> Expectation:
    """Return that the motors damp within a time [s]."""
    return Expectation(Reaction.DAMP, within)


def refuse(within: float) -> Expectation:
    """Return that arming and rising are refused within a time [s]."""
    return Expectation(Reaction.REFUSE, within)
