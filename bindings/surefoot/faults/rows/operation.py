"""Rows: QP data, references, operator, requests and options."""

from __future__ import annotations

import math

from surefoot.faults.case import STANDING_MODES, Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, table_expectation
from surefoot.faults.kinds import operator_faults as operator
from surefoot.faults.kinds.clock_faults import OperatorAction
from surefoot.faults.kinds.invalid_config import InvalidConfig
from surefoot.faults.kinds.world_faults import CorruptQp

NAN = math.nan
STOP, BUTTON = table_expectation("stop"), table_expectation("button")
NO_SOLUTION, COMMAND_HELD = table_expectation("controller"), table_expectation("program")
HEARTBEAT_TIMEOUT = 0.5  # [s] SupervisorOptions.operator_timeout. Chosen: short, to save run time

# 1e8 m/s^2 with weight 1e4 was found by trial: with these finite values, rounding errors exceed the
# tolerance of the QP solution on every robot.
ROWS = (
    Row(
        "nan_in_command",
        "the QP data is not finite or too large",
        (
            case(
                "garbage",
                "NaN in every tick",
                lambda: CorruptQp(NAN),
                NO_SOLUTION,
                modes=STANDING_MODES,
            ),
            case(
                "wrong",
                "infinite in every tick",
                lambda: CorruptQp(math.inf),
                NO_SOLUTION,
                modes=STANDING_MODES,
            ),
            case(
                "intermittent",
                "NaN in 1 tick of 25",
                lambda: CorruptQp(NAN, 25),
                COMMAND_HELD,
                modes=STANDING_MODES,
            ),
            case(
                "intermittent",
                "NaN for 10 ms of every 100",
                lambda: CorruptQp(NAN, 50, 5),
                COMMAND_HELD,
                modes=STANDING_MODES,
            ),
            case(
                "slow",
                "too large for the tolerance in 1 tick of 25",
                lambda: CorruptQp(1e8, 25, weight=1e4),
                COMMAND_HELD,
                modes=STANDING_MODES,
            ),
        ),
    ),
    Row(
        "command_jump",
        "the body reference jumps",
        (
            case(
                "wrong",
                "20 cm down at once",
                lambda: OperatorAction(operator.lower_by_20_cm),
                WATCH,
                modes=STANDING_MODES,
            ),
            case(
                "garbage",
                "another pose in every tick",
                operator.random_poses,
                WATCH,
                modes=STANDING_MODES,
            ),
            case(
                "off",
                "a pose with NaN",
                lambda: OperatorAction(operator.nan_reference),
                WATCH,
                modes=STANDING_MODES,
            ),
            case(
                "intermittent",
                "two poses in turns of 100 ms",
                lambda: OperatorAction(operator.alternating_pose),
                WATCH,
                modes=STANDING_MODES,
            ),
        ),
    ),
    Row(
        "operator_link",
        "the operator is gone",
        (
            case(
                "off",
                "heartbeats end",
                lambda: operator.HeartbeatLost(HEARTBEAT_TIMEOUT),
                table_expectation("operator", HEARTBEAT_TIMEOUT),
                expect_refusal(HEARTBEAT_TIMEOUT + 0.1),
            ),
        ),
    ),
    Row(
        "emergency_stop",
        "the operator stops the robot",
        (
            case("wrong", "stop()", lambda: OperatorAction(operator.stop), STOP, STOP),
            case(
                "intermittent",
                "stop() in every tick",
                lambda: OperatorAction(lambda s, k: s.stop()),
                STOP,
                STOP,
            ),
            case(
                "stuck",
                "stop() from another thread",
                lambda: OperatorAction(operator.stop_from_a_thread),
                STOP,
                STOP,
            ),
            case("stuck", "the remote's button B", operator.RemoteStopPressed, BUTTON, BUTTON),
        ),
    ),
    Row(
        "api_misuse",
        "requests that are not allowed",
        (
            case(
                "wrong", "every mode that is not allowed", operator.OutOfOrderRequests, WATCH, WATCH
            ),
            case("garbage", "requests from four threads", operator.ConcurrentRequests, WATCH, None),
        ),
    ),
    Row(
        "config_error",
        "invalid options and gains",
        (
            case(
                "garbage",
                "NaN, negative, out of range",
                InvalidConfig,
                WATCH,
                WATCH,
                modes=("lying",),
            ),
        ),
    ),
)
