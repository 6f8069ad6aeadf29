"""Case: one way to inject a fault of the catalogue, with the expected reactions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from surefoot.faults.expectation import REFUSE, Expectation
from surefoot.faults.kinds.fault import Fault

MODES = ("lying", "rising", "standing", "pushed", "walking")
STANDING_MODES = ("standing", "pushed")
ON_FEET_MODES = (*STANDING_MODES, "walking")


@dataclass(frozen=True)
class Case:
    """One injection of a row of the catalogue.

    Attributes:
        injection: Kind of the injection, one of signal_faults.INJECTIONS.
        description: Description of the injection, for tables.
        make_fault: Function that constructs a new fault for each run.
        expectations: Expected reaction by mode; the case has no cell for a mode without an entry.
        refusal_text: Text that the failed arming checks must contain; "" for any text.
        level: Power protection level; None: the robot's default level.
        slow_descent: True: the body must descend slowly, also while the motors damp.
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
        id: Short name of the fault.
        fault: Description of the fault, for tables.
        cases: Ways to inject the fault.
    """

    id: str
    fault: str
    cases: tuple[Case, ...]


def case(
    injection: str,
    description: str,
    make_fault: Callable[[], Fault],
    not_lying: Expectation,
    lying: Expectation | None = REFUSE,
    rising: Expectation | None = None,
    modes: tuple[str, ...] = MODES,
    refusal_text: str = "",
    level: int | None = None,
    slow_descent: bool = False,
    pushed: Expectation | None = None,
    walking: Expectation | None = None,
) -> Case:
    """Return a case that has one expectation for most of its modes.

    Args:
        injection: See Case.
        description: See Case.
        make_fault: See Case.
        not_lying: Expectation for all modes except lying.
        lying: Expectation for the mode lying; None: no cell for this mode.
        rising: Expectation for the mode rising; None: `not_lying`.
        modes: Modes for which the case has cells.
        refusal_text: See Case.
        level: See Case.
        slow_descent: See Case.
        pushed: Expectation for the mode pushed; None: `not_lying`.
        walking: Expectation for the mode walking; None: `not_lying`.
    """
    expected = {mode: not_lying for mode in modes}
    if "rising" in expected and rising is not None:
        expected["rising"] = rising
    if "pushed" in expected and pushed is not None:
        expected["pushed"] = pushed
    if "walking" in expected and walking is not None:
        expected["walking"] = walking
    if "lying" in expected:
        del expected["lying"]
        if lying is not None:
            expected = {"lying": lying, **expected}
    return Case(injection, description, make_fault, expected, refusal_text, level, slow_descent)
