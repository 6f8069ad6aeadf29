"""Rows about numbers in a report, and old data."""

from __future__ import annotations

import math

from surefoot.faults import injections as inject
from surefoot.faults.case import Row, case
from surefoot.faults.fault import Together
from surefoot.faults.reaction import WATCH, as_table, refuse, unless
from surefoot.faults.signals import Sensors, Signal

KNEE, LEG = 5, [3, 4, 5]  # FL_2, FL
NO_NUMBER = as_table("state_not_finite")
NAN, INF = math.nan, math.inf
some = inject.intermittent


def _imu(ticks: int) -> Together:
    names = ("quaternion", "gyroscope", "accelerometer")
    return Together(*(Signal(name, inject.slow(ticks)) for name in names))


def _leg() -> Together:
    return Together(*(Signal(name, inject.stuck(), LEG) for name in ("q", "dq")))


ROWS = (
    Row(
        "nan_in_state",
        "NaN or infinity in a report",
        (
            case(
                "garbage",
                "a joint angle is NaN",
                lambda: Signal("q", inject.constant(NAN), KNEE),
                NO_NUMBER,
            ),
            case(
                "wrong",
                "a gyroscope axis is infinite",
                lambda: Signal("gyroscope", inject.constant(INF), 1),
                NO_NUMBER,
            ),
            case(
                "stuck",
                "all measured torques are NaN",
                lambda: Signal("tauEst", inject.constant(NAN)),
                NO_NUMBER,
            ),
            case(
                "intermittent",
                "joint speeds are NaN in 1 report of 25",
                lambda: Signal("dq", some(inject.constant(NAN), 25)),
                WATCH,
            ),
        ),
    ),
    Row(
        "duplicate_data",
        "old data under a tick that goes on",
        (
            case("slow", "IMU at 50 Hz", lambda: _imu(10), WATCH, WATCH),
            case(
                "slow",
                "accelerometer anew in every second report",
                lambda: Signal("accelerometer", inject.slow(2)),
                WATCH,
                WATCH,
            ),
            case("slow", "all at 50 Hz", lambda: Sensors(inject.slow(10)), WATCH, WATCH),
            case(
                "stuck",
                "all sensors",
                lambda: Sensors(inject.stuck()),
                as_table("frozen"),
                refuse(0.05),
            ),
            case(
                "stuck",
                "angles and speeds of a leg",
                _leg,
                unless("encoder"),
                lying=None,
                rising=as_table("encoder"),
            ),
            case("delayed", "all by 6 ms", lambda: Sensors(inject.delayed(3)), WATCH, WATCH),
            case(
                "intermittent",
                "1 report of 10 repeats the last one's data",
                lambda: Sensors(inject.repeated(10)),
                WATCH,
                WATCH,
            ),
        ),
    ),
)
