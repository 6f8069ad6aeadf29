"""Rows about the IMU."""

from __future__ import annotations

from surefoot.faults import injections as inject
from surefoot.faults.case import Row, case
from surefoot.faults.fault import Fault, Together
from surefoot.faults.reaction import WATCH, as_table, refuse, sits
from surefoot.faults.signals import Signal

RISE = 6.0  # [s] what is seen while standing may wait so long
NO_RATE, NO_RATE_LATER = as_table("gyroscope"), as_table("gyroscope", RISE)
NO_ACCELERATION = as_table("accelerometer")
NOTHING_TO_BEGIN_WITH = sits("accelerometer", RISE)
SLOW_REFUSAL = refuse(0.5)  # of what is averaged
some = inject.intermittent


def _gyroscope(x: float) -> Signal:
    return Signal("gyroscope", inject.offset([x, 0.0, 0.0]))


def _accelerometer(x: float, z: float) -> Signal:
    return Signal("accelerometer", inject.offset([x, 0.0, z]))


def _dead_imu(change: inject.Change) -> Fault:
    return Together(Signal("gyroscope", change), Signal("accelerometer", change))


def _frozen_imu() -> list[Fault]:
    names = ("gyroscope", "accelerometer", "quaternion")
    return [Signal(name, inject.stuck()) for name in names]


def _late_imu() -> list[Fault]:
    return [Signal(name, inject.delayed(5)) for name in ("gyroscope", "accelerometer")]


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
                lambda: Signal("gyroscope", inject.drifting(4e-5)),
                as_table("gyroscope", 3.0),
                WATCH,
                rising=as_table("gyroscope", 3.0 + RISE),
            ),
        ),
    ),
    Row(
        "imu_dropout",
        "the IMU is lost, frozen or saturated",
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
                "rates and accelerations frozen",
                lambda: Together(*_frozen_imu()),
                NO_RATE,
                rising=NO_RATE_LATER,
                lying=refuse(0.1),
            ),
            case(
                "wrong",
                "a rate saturated at 34.9 rad/s",
                lambda: Signal("gyroscope", inject.constant(34.9), 0),
                NO_RATE,
                rising=NO_RATE_LATER,
                lying=refuse(0.1),
            ),
            case(
                "garbage",
                "rates anything up to 10 rad/s",
                lambda: Signal("gyroscope", inject.garbage(10.0)),
                as_table("attitude"),
                SLOW_REFUSAL,
            ),
            case(
                "off",
                "accelerations zero",
                lambda: Signal("accelerometer", inject.off),
                NO_ACCELERATION,
                rising=NOTHING_TO_BEGIN_WITH,
            ),
            case(
                "stuck",
                "accelerations frozen",
                lambda: Signal("accelerometer", inject.stuck()),
                NO_ACCELERATION,
                WATCH,
                NOTHING_TO_BEGIN_WITH,
            ),
            case(
                "delayed",
                "rates and accelerations by 10 ms",
                lambda: Together(*_late_imu()),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "rates zero for 20 ms of every 200",
                lambda: Signal("gyroscope", some(inject.off, 100, 10)),
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
                lambda: Signal("gyroscope", some(inject.offset([20.0, 0.0, 0.0]), 500, 5)),
                WATCH,
                None,
            ),
        ),
    ),
)
