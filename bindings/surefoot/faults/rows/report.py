"""Rows about numbers in a report, the attitude, and old data."""

from __future__ import annotations

import math

from surefoot.faults import injections as inject
from surefoot.faults.case import Row, case
from surefoot.faults.fault import Together
from surefoot.faults.reaction import DAMP, DEGRADE, WATCH, damp, refuse, sit
from surefoot.faults.signals import Attitude, RandomAttitude, Sensors, Signal

KNEE, LEG = 5, [3, 4, 5]  # FL_2, FL
NAN, INF = math.nan, math.inf
some = inject.intermittent

ROWS = (
    Row(
        "nan_in_state",
        "NaN or infinity in a report",
        (
            case(
                *("garbage", "a joint angle is NaN"),
                *(lambda: Signal("q", inject.constant(NAN), KNEE), DAMP),
            ),
            case(
                *("wrong", "a gyroscope axis is infinite"),
                *(lambda: Signal("gyroscope", inject.constant(INF), 1), DAMP),
            ),
            case(
                *("stuck", "all measured torques are NaN"),
                *(lambda: Signal("tauEst", inject.constant(NAN)), DAMP),
            ),
            case(
                *("intermittent", "joint speeds are NaN in 1 report of 25"),
                *(lambda: Signal("dq", some(inject.constant(NAN), 25)), WATCH),
            ),
        ),
    ),
    Row(
        "quaternion",
        "the quaternion is zero or not of unit length",
        (
            case(
                *("off", "zero", lambda: Signal("quaternion", inject.off), DEGRADE),
                rising=sit(0.25),
            ),
            case(
                *("wrong", "length 0.9"),
                *(lambda: Signal("quaternion", inject.scaled(0.9)), DEGRADE),
                rising=sit(0.25),
            ),
            case(
                *("wrong", "length 1.01"),
                *(lambda: Signal("quaternion", inject.scaled(1.01)), WATCH),
            ),
            case(
                *("wrong", "the other sign in every second report"),
                *(lambda: Signal("quaternion", some(inject.scaled(-1.0), 2)), WATCH, WATCH),
            ),
            case(
                *("intermittent", "zero in 1 report of 10"),
                *(lambda: Signal("quaternion", some(inject.off, 10)), WATCH),
            ),
        ),
    ),
    Row(
        "attitude_jump",
        "the attitude jumps",
        (
            case("wrong", "10 degrees of roll", lambda: Attitude(lambda k: 10.0, 0), DEGRADE),
            case("wrong", "90 degrees of yaw", lambda: Attitude(lambda k: 90.0, 2), WATCH, WATCH),
            case("garbage", "any attitude", RandomAttitude, DEGRADE, rising=sit(0.25)),
            case(
                *("stuck", "it stands still"),
                *(lambda: Signal("quaternion", inject.stuck()), WATCH, WATCH),
            ),
            case(
                *("slow", "it leans over at 3 deg/s"),
                *(lambda: Attitude(lambda k: 0.006 * k, 1), DEGRADE, None),
            ),
            case(
                *("delayed", "by 20 ms"),
                *(lambda: Signal("quaternion", inject.delayed(10)), WATCH, WATCH),
            ),
            case(
                *("intermittent", "10 degrees of roll in 1 report of 10"),
                *(lambda: Attitude(lambda k: 10.0 if k % 10 == 0 else 0.0, 0), DEGRADE, None),
            ),
        ),
    ),
    Row(
        "duplicate_data",
        "old data under a tick that goes on",
        (
            case("slow", "IMU at 50 Hz", lambda: _imu(10), WATCH, WATCH),
            case(
                *("slow", "accelerometer anew in every second report"),
                *(lambda: Signal("accelerometer", inject.slow(2)), WATCH, WATCH),
            ),
            case("slow", "all at 50 Hz", lambda: Sensors(inject.slow(10)), WATCH, WATCH),
            case(
                *("stuck", "all sensors"),
                *(lambda: Sensors(inject.stuck()), damp(0.05), refuse(0.05)),
            ),
            case(
                *("stuck", "angles and speeds of a leg", lambda: _leg(), damp(0.1)),
                lying=None,
            ),
            case("delayed", "all by 6 ms", lambda: Sensors(inject.delayed(3)), WATCH, WATCH),
            case(
                *("intermittent", "1 report of 10 repeats the last one's data"),
                *(lambda: Sensors(inject.repeated(10)), WATCH, WATCH),
            ),
        ),
    ),
)


def _imu(ticks: int) -> Together:
    names = ("quaternion", "gyroscope", "accelerometer")
    return Together(*(Signal(name, inject.slow(ticks)) for name in names))


def _leg() -> Together:
    return Together(*(Signal(name, inject.stuck(), LEG) for name in ("q", "dq")))
