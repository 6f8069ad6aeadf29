"""Rows about the IMU, the feet's sensors and what joints say."""

from __future__ import annotations

from surefoot.faults import injections as inject
from surefoot.faults.case import STANDING, Row, case
from surefoot.faults.fault import Fault, Together
from surefoot.faults.joint_faults import Outside
from surefoot.faults.reaction import DAMP, DEGRADE, WATCH, refuse, sit
from surefoot.faults.signals import Signal
from surefoot.faults.world_faults import Hand, Living

KNEE = 5  # FL_2
SLOW_REFUSAL = refuse(0.5)  # of what is averaged
some = inject.intermittent


def _feet(change: inject.Change, change_raw: inject.Change, foot: int | None = None) -> Fault:
    return Together(
        Living(), Signal("footForceEst", change, foot), Signal("footForce", change_raw, foot)
    )


def _gyroscope(x: float) -> Signal:
    return Signal("gyroscope", inject.offset([x, 0.0, 0.0]))


def _accelerometer(x: float, z: float) -> Signal:
    return Signal("accelerometer", inject.offset([x, 0.0, z]))


def _dead_imu(change: inject.Change) -> Fault:
    return Together(Signal("gyroscope", change), Signal("accelerometer", change))


IMU = (
    Row(
        "imu_bias",
        "gyroscope or accelerometer are biased",
        (
            case("wrong", "gyroscope 0.02 rad/s", lambda: _gyroscope(0.02), WATCH, WATCH),
            case("wrong", "gyroscope 0.1 rad/s", lambda: _gyroscope(0.1), WATCH, SLOW_REFUSAL),
            case("wrong", "acceleration 0.2 m/s2", lambda: _accelerometer(0.2, 0.0), WATCH, WATCH),
            case(
                *("wrong", "acceleration 0.7 m/s2 upwards"),
                *(lambda: _accelerometer(0.0, 0.7), WATCH, SLOW_REFUSAL),
            ),
            case(
                *("slow", "the gyroscope drifts by 0.02 rad/s every second"),
                *(lambda: Signal("gyroscope", inject.drifting(4e-5)), WATCH, WATCH),
            ),
        ),
    ),
    Row(
        "imu_dropout",
        "the IMU is lost, frozen or saturated",
        (
            case("off", "rates and accelerations zero", lambda: _dead_imu(inject.off), sit(0.1)),
            case(
                *("stuck", "rates and accelerations frozen"),
                *(lambda: Together(*_frozen_imu()), sit(0.1)),
                lying=refuse(0.1),
            ),
            case(
                *("wrong", "a rate saturated at 34.9 rad/s"),
                *(lambda: Signal("gyroscope", inject.constant(34.9), 0), sit(0.1)),
                lying=refuse(0.1),
            ),
            case(
                *("garbage", "rates anything up to 10 rad/s"),
                *(lambda: Signal("gyroscope", inject.garbage(10.0)), sit(0.1), SLOW_REFUSAL),
            ),
            case(
                *("delayed", "rates and accelerations by 10 ms"),
                *(lambda: Together(*_late_imu()), WATCH, WATCH),
            ),
            case(
                *("intermittent", "rates zero for 20 ms of every 200"),
                *(lambda: Signal("gyroscope", some(inject.off, 100, 10)), WATCH, None),
            ),
        ),
    ),
)


def _frozen_imu() -> list[Fault]:
    names = ("gyroscope", "accelerometer", "quaternion")
    return [Signal(name, inject.stuck()) for name in names]


def _late_imu() -> list[Fault]:
    return [Signal(name, inject.delayed(5)) for name in ("gyroscope", "accelerometer")]


FEET = (
    Row(
        "foot_sensor",
        "foot sensors are stuck, zero, drifting or saturated",
        (
            case("off", "all zero", lambda: _feet(inject.off, inject.off), DEGRADE, WATCH),
            case("stuck", "all", lambda: _feet(inject.stuck(), inject.stuck()), DEGRADE, WATCH),
            case(
                *("garbage", "all say anything up to 300"),
                *(lambda: _feet(inject.garbage(300), inject.garbage(300)), DEGRADE, WATCH),
            ),
            case(
                *("wrong", "one saturated"),
                *(lambda: _feet(inject.constant(32767), inject.constant(32767), 0), DEGRADE),
                lying=WATCH,
            ),
            case(
                *("slow", "one drifts by 50 N a second"),
                *(lambda: _feet(inject.drifting(0.1), inject.drifting(0.1), 2), DEGRADE, WATCH),
            ),
            case(
                *("delayed", "all by 50 ms"),
                *(lambda: _feet(inject.delayed(25), inject.delayed(25)), WATCH, WATCH),
            ),
            case(
                *("intermittent", "all zero in 1 report of 3"),
                *(lambda: _feet(some(inject.off, 3), some(inject.off, 3)), DEGRADE, WATCH),
            ),
        ),
    ),
    Row(
        "phantom_contact",
        "a contact is missed, or there is none",
        (
            case(
                "off", "one foot says zero", lambda: _feet(inject.off, inject.off, 1), WATCH, WATCH
            ),
            case(
                *("wrong", "a foot that a hand lifts by 2 cm says 60 N"),
                *(lambda: Together(_foot_at_60(), Hand("FR", 0.02, 0.4)), WATCH),
                modes=STANDING,
            ),
            case(
                *("garbage", "a foot says zero or 60 N by turns"),
                *(
                    lambda: Together(_foot_at_60(), _feet(*2 * (some(inject.off, 20, 10),), 0)),
                    WATCH,
                ),
                lying=WATCH,
            ),
        ),
    ),
)


def _foot_at_60() -> Fault:
    return _feet(inject.constant(60), inject.constant(60), 0)


JOINTS = (
    Row(
        "joint_limit",
        "a joint is at its limit, or says so",
        (
            case(
                *("wrong", "a knee says 0.3 rad beyond its stop"),
                *(lambda: Outside(0.3, KNEE, True), DAMP),
            ),
            case(
                *("intermittent", "a knee says 0.3 rad beyond its stop in 1 report of 25"),
                *(lambda: Outside(0.3, KNEE, True, 25), WATCH),
            ),
        ),
    ),
    Row(
        "joint_speed",
        "joint speeds at or beyond what motors can",
        (
            case(
                *("wrong", "a knee says 100 rad/s"),
                *(lambda: Signal("dq", inject.constant(100.0), KNEE), DAMP),
            ),
            case("off", "a knee says 0", lambda: Signal("dq", inject.off, KNEE), WATCH, WATCH),
            case(
                *("garbage", "noise of 1 rad/s on all"),
                *(lambda: Signal("dq", inject.noise(1.0)), WATCH, WATCH),
            ),
            case(
                *("delayed", "all by 10 ms"),
                *(lambda: Signal("dq", inject.delayed(5)), WATCH, WATCH),
            ),
            case(
                *("intermittent", "a knee says 25 rad/s in 1 report of 25"),
                *(lambda: Signal("dq", some(inject.constant(25.0), 25), KNEE), WATCH, None),
            ),
        ),
    ),
)


ROWS = IMU + FEET + JOINTS
