"""Rows: gyroscope and accelerometer of the IMU."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, expect_sit, table_expectation
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.fault import CombinedFault, Fault
from surefoot.faults.kinds.signals import SignalFault

# [s] Time allowed until the robot stands; some faults can only be detected then. Chosen: longer
# than the rest of a rise after RISE_FRACTION (2 s) and the fade (0.25 s).
RISE_TIME = 6.0
NO_RATE, NO_RATE_LATER = table_expectation("gyroscope"), table_expectation("gyroscope", RISE_TIME)
NO_ACCELERATION = table_expectation("accelerometer")
NO_INITIAL_ACCELERATION = expect_sit("accelerometer", RISE_TIME)
SLOW_REFUSAL = expect_refusal(0.5)  # [s] time limit of checks that average a signal over 0.1 s
intermittent = inject.intermittent


def _gyroscope(x: float) -> SignalFault:
    return SignalFault("gyroscope", inject.offset([x, 0.0, 0.0]))


def _accelerometer(x: float, z: float) -> SignalFault:
    return SignalFault("accelerometer", inject.offset([x, 0.0, z]))


def _dead_imu(change: inject.Change) -> Fault:
    return CombinedFault(SignalFault("gyroscope", change), SignalFault("accelerometer", change))


def _frozen_imu() -> list[Fault]:
    names = ("gyroscope", "accelerometer", "quaternion")
    return [SignalFault(name, inject.stuck()) for name in names]


def _late_imu() -> list[Fault]:
    return [SignalFault(name, inject.delayed(5)) for name in ("gyroscope", "accelerometer")]


# Some injections are below, some above the limits of imu_monitor.cpp (0.08 and 3 rad/s, 50 ms) and
# arming_checks.cpp (0.05 rad/s, 5 % of g). 34.9 rad/s is a gyroscope's full scale of 2000 deg/s.
ROWS = (
    Row(
        "imu_bias",
        "gyroscope or accelerometer are biased",
        (
            case("wrong", "gyroscope 0.02 rad/s", lambda: _gyroscope(0.02), WATCH, WATCH),
            case(
                "wrong",
                "gyroscope 0.1 rad/s",
                lambda: _gyroscope(0.1),
                NO_RATE,
                SLOW_REFUSAL,
                rising=NO_RATE_LATER,
            ),
            case("wrong", "acceleration 0.2 m/s2", lambda: _accelerometer(0.2, 0.0), WATCH, WATCH),
            case(
                "wrong",
                "acceleration 0.7 m/s2 upwards",
                lambda: _accelerometer(0.0, 0.7),
                WATCH,
                SLOW_REFUSAL,
            ),
            case(
                "slow",
                "the gyroscope drifts by 0.02 rad/s every second",
                lambda: SignalFault("gyroscope", inject.drifting(4e-5)),
                table_expectation("gyroscope", 3.0),
                WATCH,
                rising=table_expectation("gyroscope", 3.0 + RISE_TIME),
            ),
        ),
    ),
    Row(
        "imu_dropout",
        "the IMU is lost, constant or saturated",
        (
            case(
                "off",
                "rates and accelerations zero",
                lambda: _dead_imu(inject.off),
                NO_RATE,
                rising=NO_RATE_LATER,
            ),
            case(
                "stuck",
                "rates and accelerations constant",
                lambda: CombinedFault(*_frozen_imu()),
                NO_RATE,
                rising=NO_RATE_LATER,
                lying=expect_refusal(0.1),
            ),
            case(
                "wrong",
                "a rate saturated at 34.9 rad/s",
                lambda: SignalFault("gyroscope", inject.constant(34.9), 0),
                NO_RATE,
                rising=NO_RATE_LATER,
                lying=expect_refusal(0.1),
            ),
            case(
                "garbage",
                "rates random up to 10 rad/s",
                lambda: SignalFault("gyroscope", inject.garbage(10.0)),
                table_expectation("attitude"),
                SLOW_REFUSAL,
            ),
            case(
                "off",
                "accelerations zero",
                lambda: SignalFault("accelerometer", inject.off),
                NO_ACCELERATION,
                rising=NO_INITIAL_ACCELERATION,
            ),
            case(
                "stuck",
                "accelerations constant",
                lambda: SignalFault("accelerometer", inject.stuck()),
                NO_ACCELERATION,
                WATCH,
                NO_INITIAL_ACCELERATION,
            ),
            case(
                "delayed",
                "rates and accelerations by 10 ms",
                lambda: CombinedFault(*_late_imu()),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "rates zero for 20 ms of every 200",
                lambda: SignalFault("gyroscope", intermittent(inject.off, 100, 10)),
                WATCH,
                None,
            ),
            case(
                "wrong",
                "a rate 2.5 rad/s too high",
                lambda: _gyroscope(2.5),
                NO_RATE,
                SLOW_REFUSAL,
                rising=NO_RATE_LATER,
            ),
            case(
                "intermittent",
                "a rate 20 rad/s too high for 10 ms of every second",
                lambda: SignalFault(
                    "gyroscope", intermittent(inject.offset([20.0, 0.0, 0.0]), 500, 5)
                ),
                WATCH,
                None,
            ),
        ),
    ),
)
