"""Rows about power, limits, the battery, and who else commands the motors."""

from __future__ import annotations

from surefoot.faults import injections as inject
from surefoot.faults import motor_faults as motor
from surefoot.faults.case import Row, case
from surefoot.faults.joint_faults import Outside, Power
from surefoot.faults.reaction import WATCH, as_table, refuse
from surefoot.faults.signals import Signal

some = inject.intermittent
LOW = as_table("battery")

ROWS = (
    Row(
        "power_trip",
        "the motors' power is above the protection's level",
        (
            case(
                "wrong",
                "reports say 3 times the level",
                lambda: Power(3.0),
                as_table("power"),
                None,
            ),
            case(
                "intermittent",
                "2 reports of 10 say 3 times the level",
                lambda: Power(3.0, 10, 2),
                WATCH,
                None,
            ),
        ),
    ),
    Row(
        "position_trip",
        "a joint is outside its limits",
        (
            case(
                "wrong",
                "a hip says 0.2 rad outside",
                lambda: Outside(0.2, 3, False),
                as_table("joint_jump"),
            ),
        ),
    ),
    Row(
        "battery",
        "the battery is empty or gone",
        (
            case(
                "wrong",
                "3 % of charge",
                lambda: Signal("SOC", inject.constant(3)),
                LOW,
                refuse(LOW.within),
            ),
            case(
                "slow",
                "from 20 % by 10 % a second",
                lambda: Signal("SOC", inject.ramp(20, -10.0)),
                as_table("battery", 1.0),
                None,
            ),
            case(
                "intermittent",
                "0 % in 1 report of 10",
                lambda: Signal("SOC", some(inject.off, 10)),
                WATCH,
                WATCH,
            ),
        ),
    ),
    Row(
        "two_controllers",
        "another controller commands the motors",
        (
            case("stuck", "always", lambda: motor.Usurped(), as_table("overridden"), None),
            case(
                "intermittent",
                "every second command",
                lambda: motor.Usurped(2),
                as_table("overridden"),
                None,
            ),
        ),
    ),
)
