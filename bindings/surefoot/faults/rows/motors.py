"""Rows: torque, failure and temperature of motors."""

from __future__ import annotations

from surefoot.faults.case import Case, Row, case
from surefoot.faults.expectation import WATCH, expect_stand, table_expectation, watch_unless
from surefoot.faults.kinds import motor_faults as motor
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.signals import SignalFault

THIGH, CALF = 4, 5  # FL_1, FL_2
WEAK_FAULT_ALLOWED = watch_unless("motor_weak")
TEMPERATURE_FAULT = table_expectation("temperature")
MOTOR_MODE_FAULT = table_expectation("motor_mode")
intermittent = inject.intermittent


def _wrong_torque(change: inject.Change) -> SignalFault:
    return SignalFault("tauEst", change, CALF)


def _dead_motor(injection: str, description: str, number: int, mode: int) -> Case:
    """Return a case of a dead motor: a standing robot must continue on the other three legs.

    After a push or in a step, three legs can be too weak. Then damping with the fault motor_mode
    is accepted.
    """
    return case(
        injection,
        description,
        lambda: motor.DeadMotor(number, mode),
        table_expectation("leg_lost"),
        rising=MOTOR_MODE_FAULT,
        pushed=watch_unless("motor_mode"),
        walking=expect_stand("", alternative="motor_mode"),
        slow_descent=True,
    )


def _wrong_temperature(change: inject.Change) -> SignalFault:
    return SignalFault("temperature", change, THIGH)


# Some injections are below, some above the tolerances of motor_faults.cpp. temperature_warning is
# 60 deg C. temperature_stop is 80 deg C; the ramp from 40 deg C reaches it in 8 s.
ROWS = (
    Row(
        "tau_mismatch",
        "measured torques differ from the commanded ones",
        (
            case(
                "off",
                "a calf motor reports 0",
                lambda: _wrong_torque(inject.off),
                WEAK_FAULT_ALLOWED,
                WATCH,
            ),
            case(
                "stuck",
                "a calf motor reports a constant value",
                lambda: _wrong_torque(inject.stuck()),
                WEAK_FAULT_ALLOWED,
                WATCH,
            ),
            case(
                "garbage",
                "a calf motor reports random values",
                lambda: _wrong_torque(inject.garbage(10)),
                WEAK_FAULT_ALLOWED,
                WATCH,
            ),
            case(
                "wrong",
                "a calf motor gives 60 % of its torque",
                lambda: motor.WeakMotor(CALF, share=0.6),
                WEAK_FAULT_ALLOWED,
                WATCH,
            ),
            case(
                "stuck",
                "the motors of a leg keep an old command",
                lambda: motor.UnresponsiveMotors([3, 4, 5]),
                WEAK_FAULT_ALLOWED,
                None,
            ),
            case(
                "delayed",
                "all late by 20 ms",
                lambda: SignalFault("tauEst", inject.delayed(10)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "all report 0 in 1 sample of 10",
                lambda: SignalFault("tauEst", intermittent(inject.off, every=10)),
                WATCH,
                WATCH,
            ),
        ),
    ),
    Row(
        "motor_dead",
        "a motor switches itself off",
        (
            _dead_motor("off", "a calf motor turns freely, mode 8", CALF, mode=8),
            _dead_motor("wrong", "a thigh motor brakes, mode 0", THIGH, mode=0),
            case(
                "intermittent",
                "a calf motor, for 2 ms",
                lambda: motor.DeadMotor(CALF, mode=8, periods=1),
                WATCH,
                None,
            ),
        ),
    ),
    Row(
        "over_temperature",
        "a thigh motor reports a wrong or high temperature",
        (
            case("wrong", "65 deg C", lambda: _wrong_temperature(inject.constant(65)), WATCH),
            case(
                "wrong",
                "90 deg C",
                lambda: _wrong_temperature(inject.constant(90)),
                TEMPERATURE_FAULT,
            ),
            case(
                "slow",
                "from 40 deg C, 5 deg C more every second",
                lambda: _wrong_temperature(inject.ramp(40, per_second=5.0)),
                table_expectation("temperature", delay=8.0),
                None,
            ),
            case(
                "garbage",
                "random values",
                lambda: _wrong_temperature(inject.garbage(127, whole=True)),
                WATCH,
                None,
            ),
            case(
                "intermittent",
                "120 deg C in 1 sample of 25",
                lambda: _wrong_temperature(intermittent(inject.constant(120), every=25)),
                WATCH,
                None,
            ),
        ),
    ),
)
