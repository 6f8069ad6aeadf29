"""Rows about the body, the ground, falls and hands."""

from __future__ import annotations

from surefoot.faults import setup_faults as setup
from surefoot.faults.case import STANDING, UP, Row, case
from surefoot.faults.reaction import WATCH, as_table, damp, refuse
from surefoot.faults.world_faults import Hand, Shove

RISING, LYING = ("rising",), ("lying",)
DOWN = damp(as_table("tilt").within)  # a shove may trip the power protection before it tilts it
LANDING_LEVEL = 10  # of the power protection: a landing takes power

MODEL = (
    Row(
        "model_mismatch",
        "mass or centre of mass are not the model's",
        (
            case("wrong", "10 % more mass", lambda: setup.Loaded(0.1), WATCH, modes=UP),
            case(
                "wrong",
                "10 % more mass, 10 cm to the rear",
                lambda: setup.Loaded(0.1, -0.1),
                WATCH,
                modes=UP,
            ),
        ),
    ),
    Row(
        "ground",
        "the ground is softer or more slippery than modelled",
        (
            case("wrong", "friction 0.4", lambda: setup.Around(friction=0.4), WATCH, modes=UP),
            case("wrong", "feet sink by 1 cm", lambda: setup.Around(sink=0.01), WATCH, modes=UP),
        ),
    ),
    Row(
        "payload",
        "it bears more than it is allowed to",
        (
            case(
                "wrong",
                "15 % of its mass, 10 % allowed",
                lambda: setup.Loaded(0.15, limit=0.1),
                as_table("payload", 7.0),
                modes=RISING,
            ),
        ),
    ),
    Row(
        "hanging",
        "it hangs, and is asked to rise",
        (
            case(
                "wrong",
                "feet in the air",
                lambda: setup.Around(hung=True),
                as_table("hanging", 6.0),
                modes=RISING,
            ),
        ),
    ),
    Row(
        "unknown_pose",
        "it starts from a pose that it should not",
        (
            case("wrong", "it stands, held by its motors", setup.Standing, WATCH, modes=RISING),
            case(
                "wrong",
                "it says that it lies at 35 degrees",
                setup.steep,
                WATCH,
                refuse(0.5),
                None,
                LYING,
            ),
        ),
    ),
)
FALLS = (
    Row(
        "body_tilt",
        "the body tilts too far",
        (
            case(
                "wrong",
                "it is rolled over",
                lambda: Shove(4.0, 1.0, until_down=True),
                DOWN,
                modes=UP,
            ),
        ),
    ),
    Row(
        "falling",
        "a fall cannot be prevented",
        (
            case(
                "wrong",
                "a push of twice what it survives",
                lambda: Shove(2.0, 0.0, until_down=True),
                DOWN,
                modes=STANDING,
            ),
        ),
    ),
    Row(
        "lifted",
        "it is lifted, and put down",
        (
            case(
                "wrong",
                "by 10 cm for a second",
                lambda: Hand("trunk", 0.1, 1.0, 0.3),
                as_table("lifted", 0.3),
                modes=STANDING,
                level=LANDING_LEVEL,
            ),
            case(
                "wrong",
                "by 10 cm while it rises",
                lambda: Hand("trunk", 0.1, 1.0, 0.3),
                WATCH,
                modes=RISING,
                level=LANDING_LEVEL,
            ),
        ),
    ),
    Row(
        "dropped",
        "it is dropped",
        (
            case(
                "wrong",
                "from 10 cm",
                lambda: Hand("trunk", 0.1, 0.6),
                as_table("lifted", 0.3),
                modes=("standing",),
                level=LANDING_LEVEL,
            ),
        ),
    ),
)

ROWS = MODEL + FALLS
