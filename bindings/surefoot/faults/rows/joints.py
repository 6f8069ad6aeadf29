"""Rows about what joints say."""

from __future__ import annotations

from surefoot.faults import injections as inject
from surefoot.faults.case import Row, case
from surefoot.faults.joint_faults import Outside
from surefoot.faults.reaction import WATCH, as_table
from surefoot.faults.signals import Signal

KNEE = 5  # FL_2
some = inject.intermittent

ROWS = (
    Row(
        "joint_limit",
        "a joint is at its limit, or says so",
        (
            case(
                "wrong",
                "a knee says 0.3 rad beyond its stop",
                lambda: Outside(0.3, KNEE, True),
                as_table("joint_jump"),
            ),
            case(
                "intermittent",
                "a knee says 0.3 rad beyond its stop in 1 report of 25",
                lambda: Outside(0.3, KNEE, True, 25),
                WATCH,
            ),
        ),
    ),
    Row(
        "joint_speed",
        "joint speeds at or beyond what motors can",
        (
            case(
                "wrong",
                "a knee says 100 rad/s",
                lambda: Signal("dq", inject.constant(100.0), KNEE),
                as_table("state_implausible"),
            ),
            case("off", "a knee says 0", lambda: Signal("dq", inject.off, KNEE), WATCH, WATCH),
            case(
                "garbage",
                "noise of 1 rad/s on all",
                lambda: Signal("dq", inject.noise(1.0)),
                WATCH,
                WATCH,
            ),
            case(
                "delayed",
                "all by 10 ms",
                lambda: Signal("dq", inject.delayed(5)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "a knee says 25 rad/s in 1 report of 25",
                lambda: Signal("dq", some(inject.constant(25.0), 25), KNEE),
                WATCH,
                None,
            ),
        ),
    ),
)
