"""Rows about what is connected: the order of the motors, the robot."""

from __future__ import annotations

from surefoot.faults import setup_faults as setup
from surefoot.faults.case import Row, case
from surefoot.faults.reaction import WATCH, refuse, stays, unless

KNEE, HIP = 5, 3  # FL_2, FL_0
LYING, RISING = ("lying",), ("rising",)
MISWIRED, ANOTHER = stays("wiring"), stays("wrong_robot")
TYPICAL = refuse(1.5)  # arming begins anew with every robot: a second and a little

ROWS = (
    Row(
        "motor_order",
        "motors are wired in another order, or turn the other way",
        (
            case(
                "wrong",
                "thigh and knee of FR are swapped",
                lambda: setup.Wiring({1: 2, 2: 1}),
                WATCH,
                TYPICAL,
                None,
                LYING,
                "FR_1 and FR_2",
            ),
            case(
                "wrong",
                "front legs are swapped",
                lambda: setup.Wiring(setup.legs(0, 1)),
                WATCH,
                MISWIRED,
                None,
                LYING,
            ),
            case(
                "wrong",
                "right legs are swapped",
                lambda: setup.Wiring(setup.legs(0, 2)),
                WATCH,
                MISWIRED,
                None,
                LYING,
            ),
            case(
                "wrong",
                "front legs are swapped with rear ones",
                lambda: setup.Wiring({**setup.legs(0, 2), **setup.legs(1, 3)}),
                WATCH,
                MISWIRED,
                None,
                LYING,
            ),
            case(
                "wrong",
                "FL's knee turns the other way",
                lambda: setup.Wiring({}, (KNEE,)),
                WATCH,
                TYPICAL,
                None,
                LYING,
                "FL_2",
            ),
            case(
                "wrong",
                "FL's hip turns the other way",
                lambda: setup.Wiring({}, (HIP,)),
                WATCH,
                MISWIRED,
                None,
                LYING,
            ),
        ),
    ),
    Row(
        "wrong_robot",
        "it is another robot than it is taken for",
        (
            case(
                "wrong",
                "the one most like it",
                lambda: setup.Mistaken(setup.NEAR),
                unless("wrong_robot"),
                None,
                modes=RISING,
            ),
            case(
                "wrong",
                "one of another size",
                lambda: setup.Mistaken(setup.FAR),
                WATCH,
                ANOTHER,
                None,
                LYING,
            ),
        ),
    ),
)
