"""Rows: motor wiring and wrong robot model."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, expect_stay_down, watch_unless
from surefoot.faults.kinds import initial_faults as setup

KNEE, HIP = 5, 3  # FL_2, FL_0
LYING, RISING = ("lying",), ("rising",)
WRONG_ORDER, WRONG_ROBOT = expect_stay_down("wiring"), expect_stay_down("wrong_robot")
# [s] Longer than arming_time (1 s), after which a healthy robot could be armed.
ARMING_REFUSAL = expect_refusal(1.5)

ROWS = (
    Row(
        "motor_order",
        "motors are wired in another order, or turn the other way",
        (
            case(
                "wrong",
                "thigh and knee of FR are swapped",
                lambda: setup.WrongWiring({1: 2, 2: 1}),
                WATCH,
                ARMING_REFUSAL,
                None,
                LYING,
                "FR_1 and FR_2",
            ),
            case(
                "wrong",
                "front legs are swapped",
                lambda: setup.WrongWiring(setup.swapped_legs(0, 1)),
                WATCH,
                WRONG_ORDER,
                None,
                LYING,
            ),
            case(
                "wrong",
                "right legs are swapped",
                lambda: setup.WrongWiring(setup.swapped_legs(0, 2)),
                WATCH,
                WRONG_ORDER,
                None,
                LYING,
            ),
            case(
                "wrong",
                "front legs are swapped with rear ones",
                lambda: setup.WrongWiring({**setup.swapped_legs(0, 2), **setup.swapped_legs(1, 3)}),
                WATCH,
                WRONG_ORDER,
                None,
                LYING,
            ),
            case(
                "wrong",
                "FL's knee turns the other way",
                lambda: setup.WrongWiring({}, (KNEE,)),
                WATCH,
                ARMING_REFUSAL,
                None,
                LYING,
                "FL_2",
            ),
            case(
                "wrong",
                "FL's hip turns the other way",
                lambda: setup.WrongWiring({}, (HIP,)),
                WATCH,
                WRONG_ORDER,
                None,
                LYING,
            ),
        ),
    ),
    Row(
        "wrong_robot",
        "the model is that of another robot",
        (
            case(
                "wrong",
                "the most similar robot",
                lambda: setup.WrongRobot(setup.SIMILAR_ROBOT),
                watch_unless("wrong_robot"),
                None,
                modes=RISING,
            ),
            case(
                "wrong",
                "a robot of another size",
                lambda: setup.WrongRobot(setup.DIFFERENT_ROBOT),
                WATCH,
                WRONG_ROBOT,
                None,
                LYING,
            ),
        ),
    ),
)
