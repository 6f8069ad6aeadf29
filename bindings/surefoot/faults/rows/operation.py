"""Rows about the program, its numbers, and who operates it."""

from __future__ import annotations

import math

from surefoot.faults import operator_faults as operator
from surefoot.faults.case import STANDING, Row, case
from surefoot.faults.clock_faults import Operator
from surefoot.faults.reaction import DAMP, REFUSE, WATCH, damp, refuse, sit
from surefoot.faults.world_faults import Program

NAN = math.nan
AT_ONCE = damp(0.002)

ROWS = (
    Row(
        "nan_in_command",
        "the program's numbers are no numbers",
        (
            case("garbage", "NaN in every tick", lambda: Program(NAN), DAMP, modes=STANDING),
            case(
                "wrong", "infinite in every tick", lambda: Program(math.inf), DAMP, modes=STANDING
            ),
            case(
                "intermittent",
                "NaN in 1 tick of 25",
                lambda: Program(NAN, 25),
                WATCH,
                modes=STANDING,
            ),
        ),
    ),
    Row(
        "command_jump",
        "what is asked for jumps",
        (
            case(
                "wrong", "20 cm down at once", lambda: Operator(operator.low), WATCH, modes=STANDING
            ),
            case("garbage", "another pose in every tick", operator.restless, WATCH, modes=STANDING),
            case(
                "off",
                "a pose that is no number",
                lambda: Operator(operator.nowhere),
                WATCH,
                modes=STANDING,
            ),
            case(
                "intermittent",
                "between two poses every 100 ms",
                lambda: Operator(operator.to_and_fro),
                WATCH,
                modes=STANDING,
            ),
        ),
    ),
    Row(
        "operator_link",
        "the operator's remote falls silent",
        (case("off", "after it was there", operator.LostRemote, sit(1.0), refuse(1.0)),),
    ),
    Row(
        "emergency_stop",
        "the operator stops it",
        (
            case("wrong", "stop()", lambda: Operator(operator.stop), AT_ONCE, AT_ONCE),
            case(
                "intermittent",
                "stop(), again and again",
                lambda: Operator(lambda s, k: s.stop()),
                AT_ONCE,
                AT_ONCE,
            ),
            case(
                "stuck",
                "from another thread",
                lambda: Operator(operator.stop_from_a_thread),
                AT_ONCE,
                AT_ONCE,
            ),
            case("stuck", "the remote's button B", operator.Pressed, AT_ONCE, AT_ONCE),
        ),
    ),
    Row(
        "api_misuse",
        "requests out of order",
        (
            case("wrong", "every mode that is not next", operator.Misuse, WATCH, WATCH),
            case("garbage", "requests from four threads", operator.Crowd, WATCH, None),
        ),
    ),
    Row(
        "config_error",
        "options and gains that make no sense",
        (
            case(
                "garbage",
                "NaN, negative, out of range",
                operator.BadConfig,
                WATCH,
                REFUSE,
                modes=("lying",),
            ),
        ),
    ),
)
