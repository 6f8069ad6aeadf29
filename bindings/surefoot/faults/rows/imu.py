"""Rows: gyroscope and accelerometer of the IMU."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, expect_sit, table_expectation
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.fault import CombinedFault, Fault
from surefoot.faults.kinds.signals import SignalFault

# [s] Longest time from an injection into a rising robot until the robot stands. It is added to the
# detection time of faults that the supervisor detects only when the robot stands. Chosen: longer
# than the rest of the rise (less than 2 s, because the injection begins at RISE_FRACTION of
# matrix/reach_mode.py) plus the fade of the torques (0.25 s).
DELAY_UNTIL_STANDING = 6.0
GYROSCOPE_FAULT = table_expectation("gyroscope")
GYROSCOPE_FAULT_WHEN_STANDING = table_expectation("gyroscope", delay=DELAY_UNTIL_STANDING)
ACCELEROMETER_FAULT = table_expectation("accelerometer")
SIT_FOR_ACCELEROMETER = expect_sit("accelerometer", delay=DELAY_UNTIL_STANDING)
# [s] Time limit of refusals by arming checks that filter a signal with a time constant of 0.1 s.
LATE_REFUSAL = expect_refusal(0.5)
intermittent = inject.intermittent


def _gyroscope_offset(x: float) -> SignalFault:
    return SignalFault("gyroscope", inject.offset([x, 0.0, 0.0]))


def _accelerometer_offset(x: float = 0.0, z: float = 0.0) -> SignalFault:
    return SignalFault("accelerometer", inject.offset([x, 0.0, z]))


def _zero_imu() -> Fault:
    names = ("gyroscope", "accelerometer")
    return CombinedFault(*(SignalFault(name, inject.off) for name in names))


def _stuck_imu() -> Fault:
    names = ("gyroscope", "accelerometer", "quaternion")
    return CombinedFault(*(SignalFault(name, inject.stuck()) for name in names))


def _late_imu() -> Fault:
    names = ("gyroscope", "accelerometer")
    return CombinedFault(*(SignalFault(name, inject.delayed(5)) for name in names))


# Some injections are below, some above the limits of imu_monitor.cpp (0.08 and 3 rad/s, 50 ms) and
# arming_checks.cpp (0.05 rad/s, 5 % of g). 34.9 rad/s is a gyroscope's full scale of 2000 deg/s.
ROWS = (
    Row(
        "imu_bias",
        "gyroscope or accelerometer is biased",
        (
            case(
                "wrong", "gyroscope bias 0.02 rad/s", lambda: _gyroscope_offset(0.02), WATCH, WATCH
            ),
            case(
                "wrong",
                "gyroscope bias 0.1 rad/s",
                lambda: _gyroscope_offset(0.1),
                GYROSCOPE_FAULT,
                LATE_REFUSAL,
                rising=GYROSCOPE_FAULT_WHEN_STANDING,
            ),
            case(
                "wrong",
                "accelerometer bias 0.2 m/s^2 forwards",
                lambda: _accelerometer_offset(x=0.2),
                WATCH,
                WATCH,
            ),
            case(
                "wrong",
                "accelerometer bias 0.7 m/s^2 upwards",
                lambda: _accelerometer_offset(z=0.7),
                WATCH,
                LATE_REFUSAL,
            ),
            case(
                "slow",
                "the gyroscope bias grows by 0.02 rad/s every second",
                lambda: SignalFault("gyroscope", inject.drifting(4e-5)),
                table_expectation("gyroscope", delay=3.0),
                WATCH,
                rising=table_expectation("gyroscope", delay=3.0 + DELAY_UNTIL_STANDING),
            ),
        ),
    ),
    Row(
        "imu_dropout",
        "the IMU fails: zero, constant, saturated, random, late or with a large offset",
        (
            case(
                "off",
                "rates and accelerations zero",
                _zero_imu,
                GYROSCOPE_FAULT,
                rising=GYROSCOPE_FAULT_WHEN_STANDING,
            ),
            case(
                "stuck",
                "rates, accelerations and attitude constant",
                _stuck_imu,
                GYROSCOPE_FAULT,
                rising=GYROSCOPE_FAULT_WHEN_STANDING,
                lying=expect_refusal(0.1),
            ),
            case(
                "wrong",
                "a rate saturated at 34.9 rad/s",
                lambda: SignalFault("gyroscope", inject.constant(34.9), parts=0),
                GYROSCOPE_FAULT,
                rising=GYROSCOPE_FAULT_WHEN_STANDING,
                lying=expect_refusal(0.1),
            ),
            case(
                "garbage",
                "rates random up to 10 rad/s",
                lambda: SignalFault("gyroscope", inject.garbage(10.0)),
                table_expectation("attitude"),
                LATE_REFUSAL,
            ),
            case(
                "off",
                "accelerations zero",
                lambda: SignalFault("accelerometer", inject.off),
                ACCELEROMETER_FAULT,
                rising=SIT_FOR_ACCELEROMETER,
            ),
            case(
                "stuck",
                "accelerations constant",
                lambda: SignalFault("accelerometer", inject.stuck()),
                ACCELEROMETER_FAULT,
                WATCH,
                rising=SIT_FOR_ACCELEROMETER,
            ),
            case(
                "delayed",
                "rates and accelerations late by 10 ms",
                _late_imu,
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "rates zero for 20 ms of every 200 ms",
                lambda: SignalFault("gyroscope", intermittent(inject.off, every=100, length=10)),
                WATCH,
                None,
            ),
            case(
                "wrong",
                "a rate 2.5 rad/s too high",
                lambda: _gyroscope_offset(2.5),
                GYROSCOPE_FAULT,
                LATE_REFUSAL,
                rising=GYROSCOPE_FAULT_WHEN_STANDING,
            ),
            case(
                "intermittent",
                "a rate 20 rad/s too high for 10 ms of every second",
                lambda: SignalFault(
                    "gyroscope", intermittent(inject.offset([20.0, 0.0, 0.0]), every=500, length=5)
                ),
                WATCH,
                None,
            ),
        ),
    ),
)
