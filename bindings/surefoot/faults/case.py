"""One fault of the catalogue, injected in one way: what is done, and what is expected."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from surefoot.faults.expectation import REFUSE, Expectation
from surefoot.faults.kinds.fault import Fault

MODES = ("lying", "rising", "standing", "pushed")
OFF_GROUND_MODES = ("rising", "standing", "pushed")
STANDING_MODES = ("standing", "pushed")


@dataclass(frozen=True)
class Case:
    """A row's injection.

    Attributes:
        injection: One of injections.INJECTIONS.
        description: In words.
        make_fault: Makes the fault, anew for every run.
        expectations: By mode; modes that are not in it make no sense.
        refusal_text: Must be in the text of the arming checks that failed, where arming is refused.
        level: Of the power protection, where not the robot's usual one.
        slow_descent: Must it go down slowly, even where the motors damp?
    """

    injection: str
    description: str
    make_fault: Callable[[], Fault]
    expectations: Mapping[str, Expectation]
    refusal_text: str = ""
    level: int | None = None
    slow_descent: bool = False


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
    description: str,
    make_fault: Callable[[], Fault],
    up: Expectation,
    lying: Expectation | None = REFUSE,
    rising: Expectation | None = None,
    modes: tuple[str, ...] = MODES,
    refusal_text: str = "",
    level: int | None = None,
    slow_descent: bool = False,
    pushed: Expectation | None = None,
) -> Case:
    """Return a case.

    Args:
        injection: See Case.
        description: See Case.
        make_fault: See Case.
        up: Expected while rising, standing and pushed.
        lying: Expected while lying; None where that makes no sense.
        rising: Expected while rising, where it is something else.
        modes: In which it makes sense.
        refusal_text: See Case.
        level: See Case.
        slow_descent: See Case.
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
    return Case(injection, description, make_fault, expected, refusal_text, level, slow_descent)
