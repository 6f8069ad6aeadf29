"""Case: one way to inject a fault of the catalogue, with the expected reactions."""

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
    """One injection of a row of the catalogue.

    Attributes:
        injection: One of signal_faults.INJECTIONS.
        description: Description of the injection.
        make_fault: Constructs a new fault for each run.
        expectations: Expected reaction by mode; modes without an entry do not apply.
        refusal_text: Text that the failed arming checks must contain if arming is refused.
        level: Power protection level; None for the robot's default level.
        slow_descent: True if the body must descend slowly even when the motors damp.
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
        fault: Description of the fault.
        cases: Injections of the fault.
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
        up: Expectation while rising, standing and pushed.
        lying: Expectation while lying; None if the mode does not apply.
        rising: Expectation while rising, if it differs from `up`.
        modes: Modes that apply.
        refusal_text: See Case.
        level: See Case.
        slow_descent: See Case.
        pushed: Expectation while pushed, if it differs from `up`.
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
