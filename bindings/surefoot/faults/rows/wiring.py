"""Rows: motor wiring and wrong robot model."""

from __future__ import annotations

from surefoot.faults.case import Case, Row, case
from surefoot.faults.expectation import expect_refusal, expect_stay_down, watch_unless
from surefoot.faults.kinds import initial_faults as setup

FL_CALF, FL_HIP = 5, 3  # motors FL_2, FL_0
STAYS_DOWN_FOR_WIRING = expect_stay_down("wiring")
STAYS_DOWN_FOR_ROBOT = expect_stay_down("wrong_robot")
# [s] Time limit of the refusal: requests to rise begin after this time. Longer than arming_time
# (1 s), before which even a healthy robot is refused.
REFUSAL_AFTER_ARMING_TIME = expect_refusal(1.5)

ROWS = (
    Row(
        "motor_order",
        "motors are wired in another order, or turn the other way",
        (
            Case(
                "wrong",
                "thigh and calf motors of FR are swapped",
                lambda: setup.WrongWiring({1: 2, 2: 1}),
                {"lying": REFUSAL_AFTER_ARMING_TIME},
                refusal_text="FR_1 and FR_2",
            ),
            Case(
                "wrong",
                "front legs are swapped",
                lambda: setup.WrongWiring(setup.swapped_legs(0, 1)),
                {"lying": STAYS_DOWN_FOR_WIRING},
            ),
            Case(
                "wrong",
                "right legs are swapped",
                lambda: setup.WrongWiring(setup.swapped_legs(0, 2)),
                {"lying": STAYS_DOWN_FOR_WIRING},
            ),
            Case(
                "wrong",
                "front legs are swapped with rear legs",
                lambda: setup.WrongWiring({**setup.swapped_legs(0, 2), **setup.swapped_legs(1, 3)}),
                {"lying": STAYS_DOWN_FOR_WIRING},
            ),
            Case(
                "wrong",
                "FL's calf motor turns the other way",
                lambda: setup.WrongWiring({}, reversed_motors=(FL_CALF,)),
                {"lying": REFUSAL_AFTER_ARMING_TIME},
                refusal_text="FL_2",
            ),
            Case(
                "wrong",
                "FL's hip motor turns the other way",
                lambda: setup.WrongWiring({}, reversed_motors=(FL_HIP,)),
                {"lying": STAYS_DOWN_FOR_WIRING},
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
                modes=("rising",),
            ),
            Case(
                "wrong",
                "a robot of another size",
                lambda: setup.WrongRobot(setup.DIFFERENT_ROBOT),
                {"lying": STAYS_DOWN_FOR_ROBOT},
            ),
        ),
    ),
)
