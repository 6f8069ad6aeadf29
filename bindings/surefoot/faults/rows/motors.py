"""Rows about motors, their order and heat."""

from __future__ import annotations

from surefoot.faults import injections as inject
from surefoot.faults import motor_faults as motor
from surefoot.faults import setup_faults as setup
from surefoot.faults.case import Row, case
from surefoot.faults.reaction import DEGRADE, WATCH, refuse, sit
from surefoot.faults.signals import Signal

THIGH, KNEE = 4, 5  # FL_1, FL_2
LYING = ("lying",)
TYPICAL = refuse(1.5)  # arming begins anew with every robot: a second and a little
some = inject.intermittent

WIRING = (
    Row(
        "motor_order",
        "motors are wired in another order, or turn the other way",
        (
            case(
                *("wrong", "thigh and knee of FR are swapped"),
                *(lambda: setup.Wiring({1: 2, 2: 1}), WATCH, TYPICAL),
                *(None, LYING, "FR_1 and FR_2"),
            ),
            case(
                *("wrong", "front legs are swapped"),
                *(lambda: setup.Wiring(setup.legs(0, 1)), WATCH, TYPICAL),
                *(None, LYING, "FR"),
            ),
            case(
                *("wrong", "right legs are swapped"),
                *(lambda: setup.Wiring(setup.legs(0, 2)), WATCH, TYPICAL),
                *(None, LYING, "FR"),
            ),
            case(
                *("wrong", "FL's knee turns the other way"),
                *(lambda: setup.Wiring({}, (KNEE,)), WATCH, TYPICAL),
                *(None, LYING, "FL_2"),
            ),
            case(
                *("wrong", "FL's hip turns the other way"),
                *(lambda: setup.Wiring({}, (3,)), WATCH, TYPICAL),
                *(None, LYING, "FL_0"),
            ),
        ),
    ),
    Row(
        "wrong_robot",
        "it is another robot than it is taken for",
        (
            case(
                *("wrong", "the one most like it"),
                *(lambda: setup.Mistaken(setup.NEAR), WATCH, TYPICAL),
                *(None, LYING),
            ),
            case(
                *("wrong", "one of another size"),
                *(lambda: setup.Mistaken(setup.FAR), WATCH, TYPICAL),
                *(None, LYING),
            ),
        ),
    ),
)
MOTORS = (
    Row(
        "tau_mismatch",
        "measured torques are not those asked for",
        (
            case("off", "a knee says 0", lambda: _torque(inject.off), DEGRADE, WATCH),
            case("stuck", "a knee's", lambda: _torque(inject.stuck()), DEGRADE, WATCH),
            case("garbage", "a knee says anything", lambda: _torque(inject.garbage(10)), DEGRADE),
            case("wrong", "a knee makes 60 % of it", lambda: motor.Weak(KNEE, 0.6), DEGRADE, WATCH),
            case(
                "stuck", "a leg goes on with old commands", lambda: motor.Deaf([3, 4, 5]), sit(0.2)
            ),
            case(
                *("delayed", "all by 20 ms"),
                *(lambda: Signal("tauEst", inject.delayed(10)), WATCH, WATCH),
            ),
            case(
                *("intermittent", "all 0 in 1 report of 10"),
                *(lambda: Signal("tauEst", some(inject.off, 10)), WATCH, WATCH),
            ),
        ),
    ),
    Row(
        "motor_dead",
        "a motor is off",
        (
            case("off", "a knee lets go, mode 8", lambda: motor.Dead(KNEE, 8), sit(0.1)),
            case("wrong", "a thigh brakes, mode 0", lambda: motor.Dead(THIGH, 0), sit(0.1)),
            case("intermittent", "a knee, for 2 ms", lambda: motor.Dead(KNEE, 8, 1), WATCH, None),
        ),
    ),
    Row(
        "over_temperature",
        "a motor is hot",
        (
            case("wrong", "65 C", lambda: _heat(inject.constant(65)), DEGRADE),
            case("wrong", "90 C", lambda: _heat(inject.constant(90)), sit(0.5)),
            case(
                "slow",
                "5 C more every second",
                lambda: _heat(inject.ramp(40, 5.0)),
                sit(10.0),
                None,
            ),
            case("garbage", "any number", lambda: _heat(inject.garbage(127, True)), WATCH, None),
            case(
                *("intermittent", "120 C in 1 report of 25"),
                *(lambda: _heat(some(inject.constant(120), 25)), WATCH, None),
            ),
        ),
    ),
)


def _torque(change: inject.Change) -> Signal:
    return Signal("tauEst", change, KNEE)


def _heat(change: inject.Change) -> Signal:
    return Signal("temperature", change, THIGH)


ROWS = WIRING + MOTORS
