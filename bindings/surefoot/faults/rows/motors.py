"""Rows: torque, failure and temperature of motors."""

from __future__ import annotations

from surefoot.faults.case import Case, Row, case
from surefoot.faults.expectation import WATCH, table_expectation, watch_unless
from surefoot.faults.kinds import motor_faults as motor
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.signals import SignalFault

THIGH, KNEE = 4, 5  # FL_1, FL_2
WEAK, HOT = watch_unless("motor_weak"), table_expectation("temperature")
OFF = table_expectation("motor_mode")
intermittent = inject.intermittent


def _torque(change: inject.Change) -> SignalFault:
    return SignalFault("tauEst", change, KNEE)


def _dead(injection: str, what: str, number: int, mode: int) -> Case:
    """Return a case of a dead motor: a standing robot must continue on the other three legs.

    After a push, three legs can be too weak. Then damping with the fault motor_mode is accepted.
    """
    return case(
        injection,
        what,
        lambda: motor.DeadMotor(number, mode),
        table_expectation("leg_lost"),
        rising=OFF,
        pushed=watch_unless("motor_mode"),
        slow_descent=True,
    )


def _heat(change: inject.Change) -> SignalFault:
    return SignalFault("temperature", change, THIGH)


# Some injections are below, some above the tolerances of motor_faults.cpp. temperature_warning is
# 60 deg C. temperature_stop is 80 deg C; the ramp from 40 deg C reaches it in 8 s.
ROWS = (
    Row(
        "tau_mismatch",
        "measured torques differ from the commanded ones",
        (
            case("off", "a knee reports 0", lambda: _torque(inject.off), WEAK, WATCH),
            case("stuck", "a knee constant", lambda: _torque(inject.stuck()), WEAK, WATCH),
            case(
                "garbage",
                "a knee reports random values",
                lambda: _torque(inject.garbage(10)),
                WEAK,
                WATCH,
            ),
            case(
                "wrong",
                "a knee makes 60 % of its torque",
                lambda: motor.WeakMotor(KNEE, 0.6),
                WEAK,
                WATCH,
            ),
            case(
                "stuck",
                "a leg keeps an old command",
                lambda: motor.UnresponsiveMotors([3, 4, 5]),
                WEAK,
                None,
            ),
            case(
                "delayed",
                "all by 20 ms",
                lambda: SignalFault("tauEst", inject.delayed(10)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "all 0 in 1 sample of 10",
                lambda: SignalFault("tauEst", intermittent(inject.off, 10)),
                WATCH,
                WATCH,
            ),
        ),
    ),
    Row(
        "motor_dead",
        "a motor is off",
        (
            _dead("off", "a knee is free, mode 8", KNEE, 8),
            _dead("wrong", "a thigh brakes, mode 0", THIGH, 0),
            case(
                "intermittent", "a knee, for 2 ms", lambda: motor.DeadMotor(KNEE, 8, 1), WATCH, None
            ),
        ),
    ),
    Row(
        "over_temperature",
        "a motor is hot",
        (
            case("wrong", "65 C", lambda: _heat(inject.constant(65)), WATCH),
            case("wrong", "90 C", lambda: _heat(inject.constant(90)), HOT),
            case(
                "slow",
                "5 C more every second",
                lambda: _heat(inject.ramp(40, 5.0)),
                table_expectation("temperature", 8.0),
                None,
            ),
            case("garbage", "random values", lambda: _heat(inject.garbage(127, True)), WATCH, None),
            case(
                "intermittent",
                "120 C in 1 sample of 25",
                lambda: _heat(intermittent(inject.constant(120), 25)),
                WATCH,
                None,
            ),
        ),
    ),
)
