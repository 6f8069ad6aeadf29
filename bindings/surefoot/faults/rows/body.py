"""Rows: model errors, ground, payload, falls and external lifts."""

from __future__ import annotations

from surefoot.faults.case import OFF_GROUND_MODES, STANDING_MODES, Row, case
from surefoot.faults.expectation import WATCH, expect_damp, expect_refusal, table_expectation
from surefoot.faults.kinds import initial_faults as setup
from surefoot.faults.kinds.world_faults import LiftFault, PushFault

RISING, LYING = ("rising",), ("lying",)
# FALL expects damping for any fault, because a push can trip the power protection before the
# supervisor detects the tilt.
FALL = expect_damp(table_expectation("tilt").within)
# Highest power protection level of the SDK (1000 W). Measured: landings take up to 552 W in
# benchmarks/external_lifts.py.
LANDING_LEVEL = 10

# The numbers are chosen. The robot must go on with the changes of `model_mismatch` and `ground`. In
# `payload` the payload exceeds payload_limit. The second argument of table_expectation() is the
# time [s] until the robot stands or until the injection has an effect.
MODEL = (
    Row(
        "model_mismatch",
        "mass or centre of mass differ from the model",
        (
            case(
                "wrong",
                "10 % more mass",
                lambda: setup.UnknownPayload(0.1),
                WATCH,
                modes=OFF_GROUND_MODES,
            ),
            case(
                "wrong",
                "10 % more mass, 10 cm to the rear",
                lambda: setup.UnknownPayload(0.1, -0.1),
                WATCH,
                modes=OFF_GROUND_MODES,
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
                modes=OFF_GROUND_MODES,
            ),
            case(
                "wrong",
                "feet sink by 1 cm",
                lambda: setup.ChangedSurroundings(sink=0.01),
                WATCH,
                modes=OFF_GROUND_MODES,
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
                table_expectation("payload", 7.0),
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
                table_expectation("hanging", 6.0),
                modes=RISING,
            ),
        ),
    ),
    Row(
        "unknown_pose",
        "the initial pose is not a lying pose",
        (
            case("wrong", "it stands in position mode", setup.StartsStanding, WATCH, modes=RISING),
            case(
                "wrong",
                "its IMU reports 35 degrees of pitch",
                setup.reported_slope,
                WATCH,
                expect_refusal(0.5),
                None,
                LYING,
            ),
        ),
    ),
)
FALLS = (
    Row(
        "body_tilt",
        "the body tilts too far",
        (
            case(
                "wrong",
                "a push rolls it over",
                lambda: PushFault(4.0, 1.0, until_down=True),
                FALL,
                modes=OFF_GROUND_MODES,
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
                lambda: PushFault(2.0, 0.0, until_down=True),
                FALL,
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
                "by 10 cm for a second",
                lambda: LiftFault("trunk", 0.1, 1.0, 0.3),
                table_expectation("lifted", 0.3),
                modes=STANDING_MODES,
                level=LANDING_LEVEL,
            ),
            case(
                "wrong",
                "by 10 cm while it rises",
                lambda: LiftFault("trunk", 0.1, 1.0, 0.3),
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
                lambda: LiftFault("trunk", 0.1, 0.6),
                table_expectation("lifted", 0.3),
                modes=("standing",),
                level=LANDING_LEVEL,
            ),
        ),
    ),
)

ROWS = MODEL + FALLS
