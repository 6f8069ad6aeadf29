"""Rows: power, joint limits, battery, and a second controller."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, table_expectation
from surefoot.faults.kinds import motor_faults as motor
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.joint_faults import JointOutsideLimits, PowerOverload
from surefoot.faults.kinds.signals import SignalFault

intermittent = inject.intermittent
LOW = table_expectation("battery")

# PowerProtect trips when the samples above its level outnumber the samples below it by six, so 2
# samples of 10 must not trip it. battery_low is 10 %; the ramp from 20 % reaches it in 1 s.
ROWS = (
    Row(
        "power_trip",
        "the motors' power is above the protection's level",
        (
            case(
                "wrong",
                "samples show 3 times the level",
                lambda: PowerOverload(3.0),
                table_expectation("power"),
                None,
            ),
            case(
                "intermittent",
                "2 samples of 10 show 3 times the level",
                lambda: PowerOverload(3.0, 10, 2),
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
                "a hip reports 0.2 rad outside",
                lambda: JointOutsideLimits(0.2, 3, False),
                table_expectation("joint_jump"),
            ),
        ),
    ),
    Row(
        "battery",
        "the battery is empty or missing",
        (
            case(
                "wrong",
                "charge 3 %",
                lambda: SignalFault("SOC", inject.constant(3)),
                LOW,
                expect_refusal(LOW.within),
            ),
            case(
                "slow",
                "charge falls from 20 % by 10 % a second",
                lambda: SignalFault("SOC", inject.ramp(20, -10.0)),
                table_expectation("battery", 1.0),
                None,
            ),
            case(
                "intermittent",
                "0 % in 1 sample of 10",
                lambda: SignalFault("SOC", intermittent(inject.off, 10)),
                WATCH,
                WATCH,
            ),
        ),
    ),
    Row(
        "two_controllers",
        "another controller commands the motors",
        (
            case(
                "stuck",
                "every command",
                lambda: motor.SecondController(),
                table_expectation("overridden"),
                None,
            ),
            case(
                "intermittent",
                "every second command",
                lambda: motor.SecondController(2),
                table_expectation("overridden"),
                None,
            ),
        ),
    ),
)
