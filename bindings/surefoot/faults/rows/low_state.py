"""Rows: invalid numbers and old data in a LowState."""

from __future__ import annotations

import math

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, table_expectation, watch_unless
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.fault import CombinedFault
from surefoot.faults.kinds.signals import AllSensorsFault, SignalFault

KNEE, LEG = 5, [3, 4, 5]  # FL_2, FL
NOT_FINITE = table_expectation("state_not_finite")
NAN, INF = math.nan, math.inf
intermittent = inject.intermittent


def _imu(ticks: int) -> CombinedFault:
    names = ("quaternion", "gyroscope", "accelerometer")
    return CombinedFault(*(SignalFault(name, inject.slow(ticks)) for name in names))


def _leg() -> CombinedFault:
    return CombinedFault(*(SignalFault(name, inject.stuck(), LEG) for name in ("q", "dq")))


# The slowest known rate at which a robot sends new values is 50 Hz (RepeatedSample).
ROWS = (
    Row(
        "nan_in_state",
        "NaN or infinity in a LowState",
        (
            case(
                "garbage",
                "a joint angle is NaN",
                lambda: SignalFault("q", inject.constant(NAN), KNEE),
                NOT_FINITE,
            ),
            case(
                "wrong",
                "a gyroscope axis is infinite",
                lambda: SignalFault("gyroscope", inject.constant(INF), 1),
                NOT_FINITE,
            ),
            case(
                "stuck",
                "all measured torques are NaN",
                lambda: SignalFault("tauEst", inject.constant(NAN)),
                NOT_FINITE,
            ),
            case(
                "intermittent",
                "joint speeds are NaN in 1 sample of 25",
                lambda: SignalFault("dq", intermittent(inject.constant(NAN), 25)),
                WATCH,
            ),
        ),
    ),
    Row(
        "duplicate_data",
        "old data with a tick that advances",
        (
            case("slow", "IMU at 50 Hz", lambda: _imu(10), WATCH, WATCH),
            case(
                "slow",
                "accelerometer new in every second sample",
                lambda: SignalFault("accelerometer", inject.slow(2)),
                WATCH,
                WATCH,
            ),
            case("slow", "all at 50 Hz", lambda: AllSensorsFault(inject.slow(10)), WATCH, WATCH),
            case(
                "stuck",
                "all sensors constant",
                lambda: AllSensorsFault(inject.stuck()),
                table_expectation("frozen"),
                expect_refusal(0.05),
            ),
            case(
                "stuck",
                "angles and speeds of a leg constant",
                _leg,
                watch_unless("encoder"),
                lying=None,
                rising=table_expectation("encoder"),
            ),
            case(
                "delayed", "all by 6 ms", lambda: AllSensorsFault(inject.delayed(3)), WATCH, WATCH
            ),
            case(
                "intermittent",
                "1 sample of 10 repeats the last data",
                lambda: AllSensorsFault(inject.repeated(10)),
                WATCH,
                WATCH,
            ),
        ),
    ),
)
