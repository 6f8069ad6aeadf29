"""Rows: invalid numbers and old data in a LowState."""

from __future__ import annotations

import math

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import (
    WATCH,
    expect_damp,
    expect_refusal,
    table_expectation,
    watch_unless,
)
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.fault import CombinedFault
from surefoot.faults.kinds.signals import AllSensorsFault, SignalFault

CALF, FL_LEG = 5, [3, 4, 5]  # motors FL_2; FL_0 .. FL_2
NOT_FINITE_FAULT = table_expectation("state_not_finite")
# A robot cannot walk with an IMU, or all sensors, that measure at 50 Hz: the data is older than a
# tenth of a step. It must damp for any fault. The time [s] is chosen: it walks on for a while.
TOO_SLOW_TO_WALK = expect_damp(3.0)
NAN, INF = math.nan, math.inf
intermittent = inject.intermittent


def _slow_imu(periods: int) -> CombinedFault:
    names = ("quaternion", "gyroscope", "accelerometer")
    return CombinedFault(*(SignalFault(name, inject.slow(periods)) for name in names))


def _stuck_leg() -> CombinedFault:
    return CombinedFault(*(SignalFault(name, inject.stuck(), FL_LEG) for name in ("q", "dq")))


# The slowest known rate at which a robot sends new values is 50 Hz (class RepeatedSample of the
# supervisor).
ROWS = (
    Row(
        "nan_in_state",
        "NaN or infinity in a LowState",
        (
            case(
                "garbage",
                "a joint angle is NaN",
                lambda: SignalFault("q", inject.constant(NAN), CALF),
                NOT_FINITE_FAULT,
            ),
            case(
                "wrong",
                "a gyroscope axis is infinite",
                lambda: SignalFault("gyroscope", inject.constant(INF), parts=1),
                NOT_FINITE_FAULT,
            ),
            case(
                "stuck",
                "all measured torques are NaN",
                lambda: SignalFault("tauEst", inject.constant(NAN)),
                NOT_FINITE_FAULT,
            ),
            case(
                "intermittent",
                "joint velocities are NaN in 1 sample of 25",
                lambda: SignalFault("dq", intermittent(inject.constant(NAN), every=25)),
                WATCH,
            ),
        ),
    ),
    Row(
        "duplicate_data",
        "samples with a new tick repeat old data",
        (
            case(
                "slow",
                "the IMU sends new values at 50 Hz",
                lambda: _slow_imu(periods=10),
                WATCH,
                WATCH,
                walking=TOO_SLOW_TO_WALK,
            ),
            case(
                "slow",
                "accelerometer sends a new value in every second sample",
                lambda: SignalFault("accelerometer", inject.slow(2)),
                WATCH,
                WATCH,
            ),
            case(
                "slow",
                "all sensors send new values at 50 Hz",
                lambda: AllSensorsFault(inject.slow(10)),
                WATCH,
                WATCH,
                walking=TOO_SLOW_TO_WALK,
            ),
            case(
                "stuck",
                "all sensors constant",
                lambda: AllSensorsFault(inject.stuck()),
                table_expectation("frozen"),
                expect_refusal(0.05),
            ),
            case(
                "stuck",
                "angles and velocities of a leg constant",
                _stuck_leg,
                watch_unless("encoder"),
                lying=None,
                rising=table_expectation("encoder"),
            ),
            case(
                "delayed",
                "all sensors late by 6 ms",
                lambda: AllSensorsFault(inject.delayed(3)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "1 sample of 10 repeats the data of the sample before",
                lambda: AllSensorsFault(inject.repeated(10)),
                WATCH,
                WATCH,
            ),
        ),
    ),
)
