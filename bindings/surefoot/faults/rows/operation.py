"""Rows about the program, its numbers, and who operates it."""

from __future__ import annotations

import math

from surefoot.faults import operator_faults as operator
from surefoot.faults.case import STANDING, Row, case
from surefoot.faults.clock_faults import Operator
from surefoot.faults.config_faults import BadConfig
from surefoot.faults.reaction import WATCH, as_table, refuse
from surefoot.faults.world_faults import Program

NAN = math.nan
STOP, BUTTON = as_table("stop"), as_table("button")
NO_SOLUTION, BRIDGED = as_table("controller"), as_table("program")
TIMEOUT = 0.5  # [s] without a heartbeat

ROWS = (
    Row(
        "nan_in_command",
        "the program's numbers are no numbers",
        (
            case("garbage", "NaN in every tick", lambda: Program(NAN), NO_SOLUTION, modes=STANDING),
            case(
                "wrong",
                "infinite in every tick",
                lambda: Program(math.inf),
                NO_SOLUTION,
                modes=STANDING,
            ),
            case(
                "intermittent",
                "NaN in 1 tick of 25",
                lambda: Program(NAN, 25),
                BRIDGED,
                modes=STANDING,
            ),
            case(
                "intermittent",
                "NaN for 10 ms of every 100",
                lambda: Program(NAN, 50, 5),
                BRIDGED,
                modes=STANDING,
            ),
            case(
                "slow",
                "too large for the tolerance in 1 tick of 25",
                lambda: Program(1e8, 25, weight=1e4),
                BRIDGED,
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
        "the operator is not there any more",
        (
            case(
                "off",
                "heartbeats end",
                lambda: operator.Gone(TIMEOUT),
                as_table("operator", TIMEOUT),
                refuse(TIMEOUT + 0.1),
            ),
        ),
    ),
    Row(
        "emergency_stop",
        "the operator stops it",
        (
            case("wrong", "stop()", lambda: Operator(operator.stop), STOP, STOP),
            case(
                "intermittent",
                "stop(), again and again",
                lambda: Operator(lambda s, k: s.stop()),
                STOP,
                STOP,
            ),
            case(
                "stuck",
                "from another thread",
                lambda: Operator(operator.stop_from_a_thread),
                STOP,
                STOP,
            ),
            case("stuck", "the remote's button B", operator.Pressed, BUTTON, BUTTON),
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
                BadConfig,
                WATCH,
                WATCH,
                modes=("lying",),
            ),
        ),
    ),
)
