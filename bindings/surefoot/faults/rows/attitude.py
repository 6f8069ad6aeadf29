"""Rows about the IMU's attitude."""

from __future__ import annotations

from surefoot.faults import injections as inject
from surefoot.faults.case import Row, case
from surefoot.faults.reaction import WATCH, as_table
from surefoot.faults.signals import Attitude, RandomAttitude, Signal

NO_ATTITUDE, BAD_QUATERNION = as_table("attitude"), as_table("quaternion")
some = inject.intermittent

ROWS = (
    Row(
        "quaternion",
        "the quaternion is zero or not of unit length",
        (
            case(
                "off",
                "zero",
                lambda: Signal("quaternion", inject.off),
                BAD_QUATERNION,
                rising=NO_ATTITUDE,
            ),
            case(
                "wrong",
                "length 0.9",
                lambda: Signal("quaternion", inject.scaled(0.9)),
                BAD_QUATERNION,
                rising=NO_ATTITUDE,
            ),
            case(
                "wrong",
                "length 1.01",
                lambda: Signal("quaternion", inject.scaled(1.01)),
                WATCH,
            ),
            case(
                "wrong",
                "the other sign in every second report",
                lambda: Signal("quaternion", some(inject.scaled(-1.0), 2)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "zero in 1 report of 10",
                lambda: Signal("quaternion", some(inject.off, 10)),
                WATCH,
            ),
        ),
    ),
    Row(
        "attitude_jump",
        "the attitude jumps",
        (
            case(
                "wrong",
                "10 degrees of roll",
                lambda: Attitude(lambda k: 10.0, 0),
                BAD_QUATERNION,
                rising=NO_ATTITUDE,
            ),
            case(
                "wrong",
                "90 degrees of yaw",
                lambda: Attitude(lambda k: 90.0, 2),
                BAD_QUATERNION,
                rising=NO_ATTITUDE,
            ),
            case("garbage", "any attitude", RandomAttitude, BAD_QUATERNION, rising=NO_ATTITUDE),
            case(
                "stuck",
                "it stands still",
                lambda: Signal("quaternion", inject.stuck()),
                WATCH,
                WATCH,
            ),
            case(
                "slow",
                "it leans over at 3 deg/s",
                lambda: Attitude(lambda k: 0.006 * k, 1),
                WATCH,
                None,
            ),
            case(
                "delayed",
                "by 20 ms",
                lambda: Signal("quaternion", inject.delayed(10)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "10 degrees of roll in 1 report of 10",
                lambda: Attitude(lambda k: 10.0 if k % 10 == 0 else 0.0, 0),
                WATCH,
                None,
            ),
        ),
    ),
)
