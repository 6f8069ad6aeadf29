"""Rows: model errors, ground, payload, falls and external lifts."""

from __future__ import annotations

from surefoot.faults.case import STANDING_MODES, Case, Row, case
from surefoot.faults.expectation import (
    WATCH,
    expect_damp,
    expect_refusal,
    expect_stand,
    table_expectation,
)
from surefoot.faults.kinds import initial_faults as setup
from surefoot.faults.kinds.world_faults import LiftFault, PushFault, SlipperyPatch

RISING = ("rising",)
SLIP_DELAY = 0.3  # [s] until a foot of a walking robot slips: the slippery patch lasts as long
# Expected after a fall: damping for any fault, because a push can trip the power protection before
# the supervisor detects the tilt.
DAMP_AFTER_FALL = expect_damp(table_expectation("tilt").within)
# Highest power protection level of the SDK (1000 W). Needed for landings: the motors take up to
# 552 W, measured with benchmarks/external_lifts.py.
LANDING_LEVEL = 10

# The numbers are chosen. The robot must tolerate the changes in `model_mismatch` and `ground`. In
# `payload` the payload exceeds payload_limit. The argument delay of table_expectation() is the time
# [s] until the robot stands or until the injection has an effect.
MODEL_ROWS = (
    Row(
        "model_mismatch",
        "mass or centre of mass differ from the model",
        (
            case(
                "wrong",
                "10 % more mass",
                lambda: setup.UnknownPayload(0.1),
                WATCH,
                lying=None,
            ),
            case(
                "wrong",
                "10 % more mass, 10 cm behind the origin of the base",
                lambda: setup.UnknownPayload(0.1, x=-0.1),
                WATCH,
                lying=None,
            ),
        ),
    ),
    Row(
        "ground",
        "the ground is softer or more slippery than modelled",
        (
            case(
                "wrong",
                "friction 0.4",
                lambda: setup.ChangedSurroundings(friction=0.4),
                WATCH,
                lying=None,
            ),
            case(
                "wrong",
                "feet sink by 1 cm",
                lambda: setup.ChangedSurroundings(sink=0.01),
                WATCH,
                lying=None,
            ),
            case(
                "intermittent",
                "friction 0.2 for 0.3 s, in which it turns back",
                lambda: SlipperyPatch(0.3, periods=150),
                table_expectation("slip", delay=SLIP_DELAY),
                modes=("walking",),
            ),
        ),
    ),
    Row(
        "payload",
        "the payload is above its limit",
        (
            case(
                "wrong",
                "payload 15 % of the mass, limit 10 %",
                lambda: setup.UnknownPayload(0.15, limit=0.1),
                table_expectation("payload", delay=7.0),
                modes=RISING,
            ),
        ),
    ),
    Row(
        "hanging",
        "the robot hangs while it is requested to rise",
        (
            case(
                "wrong",
                "feet in the air",
                lambda: setup.ChangedSurroundings(hung=True),
                table_expectation("hanging", delay=6.0),
                modes=RISING,
            ),
        ),
    ),
    Row(
        "unknown_pose",
        "the robot does not lie level at the start, or reports that it does not",
        (
            case(
                "wrong",
                "the robot stands in position mode",
                setup.StartsStanding,
                WATCH,
                modes=RISING,
            ),
            Case(
                "wrong",
                "the robot lies level, its IMU reports 35 degrees of pitch",
                setup.reported_slope,
                {"lying": expect_refusal(0.5)},
            ),
        ),
    ),
)
FALL_ROWS = (
    Row(
        "body_tilt",
        "the body tilts too far",
        (
            case(
                "wrong",
                "a push rolls the robot over",
                lambda: PushFault(4.0, height=1.0, until_down=True),
                DAMP_AFTER_FALL,
                lying=None,
            ),
        ),
    ),
    Row(
        "falling",
        "a fall cannot be prevented",
        (
            case(
                "wrong",
                "a push of twice the LIP push limit",
                lambda: PushFault(2.0, height=0.0, until_down=True),
                DAMP_AFTER_FALL,
                modes=STANDING_MODES,
            ),
        ),
    ),
    Row(
        "lifted",
        "the robot is lifted and put down",
        (
            case(
                "wrong",
                "by 10 cm for 1 s",
                lambda: LiftFault("trunk", height=0.1, duration=1.0, ramp=0.3),
                table_expectation("lifted", delay=0.3),
                modes=STANDING_MODES,
                level=LANDING_LEVEL,
            ),
            case(
                "wrong",
                "by 20 cm for 1 s",
                lambda: LiftFault("trunk", height=0.2, duration=1.0, ramp=0.3),
                expect_stand("lifted", delay=0.5),
                modes=("walking",),
                level=LANDING_LEVEL,
            ),
            case(
                "wrong",
                "by 10 cm while the robot rises",
                lambda: LiftFault("trunk", height=0.1, duration=1.0, ramp=0.3),
                WATCH,
                modes=RISING,
                level=LANDING_LEVEL,
            ),
        ),
    ),
    Row(
        "dropped",
        "the robot is dropped",
        (
            case(
                "wrong",
                "from 10 cm",
                lambda: LiftFault("trunk", height=0.1, duration=0.6),
                table_expectation("lifted", delay=0.3),
                modes=("standing",),
                level=LANDING_LEVEL,
            ),
        ),
    ),
)

ROWS = MODEL_ROWS + FALL_ROWS
