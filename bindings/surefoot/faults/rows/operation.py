"""Rows: QP data, references, operator, requests and options."""

from __future__ import annotations

import math

from surefoot._core import WalkVelocity
from surefoot.faults.case import ON_FEET_MODES, Case, Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, expect_stand, table_expectation
from surefoot.faults.kinds import operator_faults as operator
from surefoot.faults.kinds.clock_faults import OperatorAction
from surefoot.faults.kinds.invalid_config import InvalidConfig
from surefoot.faults.kinds.world_faults import CorruptQp

WALKING = ("walking",)

NAN = math.nan
STOP_FAULT, BUTTON_FAULT = table_expectation("stop"), table_expectation("button")
CONTROLLER_FAULT = table_expectation("controller")
# The fault "program": the QP was not solved at the first attempt, and a fallback gives the command.
QP_NOT_SOLVED = table_expectation("program")
HEARTBEAT_TIMEOUT = 0.5  # [s] SupervisorOptions.operator_timeout. Chosen: short, to save run time

# CorruptQp adds a task to the QP; its first argument is the desired acceleration [m/s^2]. The value
# 1e8 with weight 1e4 was found by trial: it is finite, but on every robot the rounding errors of
# the QP solution exceed the tolerance.
ROWS = (
    Row(
        "nan_in_command",
        "the QP data is infinite, NaN or too large",
        (
            case(
                "garbage",
                "NaN in every tick",
                lambda: CorruptQp(NAN),
                CONTROLLER_FAULT,
                modes=ON_FEET_MODES,
            ),
            case(
                "wrong",
                "infinite in every tick",
                lambda: CorruptQp(math.inf),
                CONTROLLER_FAULT,
                modes=ON_FEET_MODES,
            ),
            case(
                "intermittent",
                "NaN in 1 tick of 25",
                lambda: CorruptQp(NAN, every=25),
                QP_NOT_SOLVED,
                modes=ON_FEET_MODES,
            ),
            case(
                "intermittent",
                "NaN for 10 ms of every 100 ms",
                lambda: CorruptQp(NAN, every=50, burst=5),
                QP_NOT_SOLVED,
                modes=ON_FEET_MODES,
            ),
            case(
                "slow",
                "in 1 tick of 25 the data is so large that the solution misses the tolerance",
                lambda: CorruptQp(1e8, every=25, weight=1e4),
                QP_NOT_SOLVED,
                modes=ON_FEET_MODES,
            ),
        ),
    ),
    Row(
        "command_jump",
        "the body reference jumps or contains NaN",
        (
            case(
                "wrong",
                "20 cm down in one tick",
                lambda: OperatorAction(operator.lower_by_20_cm),
                WATCH,
                modes=ON_FEET_MODES,
            ),
            case(
                "garbage",
                "another pose in every tick",
                operator.random_poses,
                WATCH,
                modes=ON_FEET_MODES,
            ),
            case(
                "off",
                "a pose with NaN",
                lambda: OperatorAction(operator.nan_reference),
                WATCH,
                modes=ON_FEET_MODES,
            ),
            case(
                "intermittent",
                "two poses alternate every 100 ms",
                lambda: OperatorAction(operator.alternating_pose),
                WATCH,
                modes=ON_FEET_MODES,
            ),
        ),
    ),
    Row(
        "velocity_jump",
        "the commanded velocity jumps, contains NaN or ends",
        (
            case(
                "wrong",
                "backwards in one tick",
                lambda: operator.VelocityFault(lambda v, k: WalkVelocity(-v.vx, 0.0, -v.yaw_rate)),
                WATCH,
                modes=WALKING,
            ),
            case(
                "garbage",
                "another velocity in every tick",
                operator.random_velocities,
                WATCH,
                modes=WALKING,
            ),
            case(
                "intermittent",
                "a velocity with NaN in every second tick",
                lambda: operator.VelocityFault(
                    lambda v, k: WalkVelocity(NAN, 0.0, 0.0) if k % 2 else v
                ),
                WATCH,
                modes=WALKING,
            ),
            case(
                "off",
                "no more velocities",
                lambda: operator.VelocityFault(lambda v, k: None),
                expect_stand(""),
                modes=WALKING,
            ),
        ),
    ),
    Row(
        "operator_link",
        "the operator's heartbeats end",
        (
            case(
                "off",
                "no more heartbeats",
                lambda: operator.HeartbeatLost(HEARTBEAT_TIMEOUT),
                table_expectation("operator", delay=HEARTBEAT_TIMEOUT),
                expect_refusal(HEARTBEAT_TIMEOUT + 0.1),
            ),
        ),
    ),
    Row(
        "emergency_stop",
        "the operator stops the robot",
        (
            case("wrong", "stop()", lambda: OperatorAction(operator.stop), STOP_FAULT, STOP_FAULT),
            case(
                "intermittent",
                "stop() in every tick",
                lambda: OperatorAction(lambda s, k: s.stop()),
                STOP_FAULT,
                STOP_FAULT,
            ),
            case(
                "stuck",
                "stop() from another thread",
                lambda: OperatorAction(operator.stop_from_a_thread),
                STOP_FAULT,
                STOP_FAULT,
            ),
            case(
                "stuck",
                "button B of the remote",
                operator.RemoteStopPressed,
                BUTTON_FAULT,
                BUTTON_FAULT,
            ),
        ),
    ),
    Row(
        "api_misuse",
        "requests that are not allowed",
        (
            case(
                "wrong",
                "in every tick, request all modes that may not follow the present one",
                operator.OutOfOrderRequests,
                WATCH,
                WATCH,
            ),
            case(
                "garbage",
                "the same requests from four threads, in 1 tick of 50",
                operator.ConcurrentRequests,
                WATCH,
                None,
            ),
        ),
    ),
    Row(
        "config_error",
        "invalid options and gains",
        (Case("garbage", "NaN, negative, out of range", InvalidConfig, {"lying": WATCH}),),
    ),
)
