"""One fault of the catalogue, injected in one way: what is done, and what is expected."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from surefoot.faults.fault import Fault
from surefoot.faults.reaction import REFUSE, Expectation

MODES = ("lying", "rising", "standing", "pushed")
UP = ("rising", "standing", "pushed")
STANDING = ("standing", "pushed")


@dataclass(frozen=True)
class Case:
    """A row's injection.

    Attributes:
        injection: One of injections.INJECTIONS.
        what: In words.
        make: Makes the fault, anew for every run.
        expect: By mode; modes that are not in it make no sense.
        says: Must be in the text of the arming checks that failed, where arming is refused.
        level: Of the power protection, where not the robot's usual one.
        gentle: Must it go down slowly, even where the motors damp?
    """

    injection: str
    what: str
    make: Callable[[], Fault]
    expect: Mapping[str, Expectation]
    says: str = ""
    level: int | None = None
    gentle: bool = False


@dataclass(frozen=True)
class Row:
    """A row of the fault catalogue.

    Attributes:
        id: Short name.
        fault: In words.
        cases: Its injections.
    """

    id: str
    fault: str
    cases: tuple[Case, ...]


def case(
    injection: str,
    what: str,
    make: Callable[[], Fault],
    up: Expectation,
    lying: Expectation | None = REFUSE,
    rising: Expectation | None = None,
    modes: tuple[str, ...] = MODES,
    says: str = "",
    level: int | None = None,
    gentle: bool = False,
    pushed: Expectation | None = None,
) -> Case:
    """Return a case.

    Args:
        injection: See Case.
        what: See Case.
        make: See Case.
        up: Expected while rising, standing and pushed.
        lying: Expected while lying; None where that makes no sense.
        rising: Expected while rising, where it is something else.
        modes: In which it makes sense.
        says: See Case.
        level: See Case.
        gentle: See Case.
        pushed: Expected while pushed, where it is something else.
    """
    expected = {mode: up for mode in modes}
    if "rising" in expected and rising is not None:
        expected["rising"] = rising
    if "pushed" in expected and pushed is not None:
        expected["pushed"] = pushed
    if "lying" in expected:
        del expected["lying"]
        if lying is not None:
            expected = {"lying": lying, **expected}
    return Case(injection, what, make, expected, says, level, gentle)
