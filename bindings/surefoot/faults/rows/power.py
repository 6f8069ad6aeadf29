"""Rows: power, joint limits, battery, and a second controller."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, table_expectation
from surefoot.faults.kinds import motor_faults as motor
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.joint_faults import JointOutsideLimits, PowerOverload
from surefoot.faults.kinds.signals import SignalFault

intermittent = inject.intermittent
FL_HIP = 3  # motor FL_0
BATTERY_FAULT = table_expectation("battery")

# PowerProtect trips when the samples above its level outnumber the samples below the level by six.
# So 2 samples of 10 must not trip the protection. The option battery_low is 10 %; the ramp from
# 20 % reaches this charge in 1 s. An angle that is suddenly outside its limits is also a jump. So
# `position_trip` (a hip) and `joint_limit` in joints.py (a calf) expect the fault "joint_jump".
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
                lambda: PowerOverload(3.0, every=10, length=2),
                WATCH,
                None,
            ),
        ),
    ),
    Row(
        "position_trip",
        "a hip joint reports an angle beyond its limit",
        (
            case(
                "wrong",
                "0.2 rad above the upper limit",
                lambda: JointOutsideLimits(0.2, FL_HIP, below=False),
                table_expectation("joint_jump"),
            ),
        ),
    ),
    Row(
        "battery",
        "the battery's charge is low or reported as 0",
        (
            case(
                "wrong",
                "charge 3 %",
                lambda: SignalFault("SOC", inject.constant(3)),
                BATTERY_FAULT,
                expect_refusal(BATTERY_FAULT.within),
            ),
            case(
                "slow",
                "charge falls from 20 % by 10 % a second",
                lambda: SignalFault("SOC", inject.ramp(20, per_second=-10.0)),
                table_expectation("battery", delay=1.0),
                None,
            ),
            case(
                "intermittent",
                "charge 0 % in 1 sample of 10",
                lambda: SignalFault("SOC", intermittent(inject.off, every=10)),
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
                "in every period",
                motor.SecondController,
                table_expectation("overridden"),
                None,
            ),
            case(
                "intermittent",
                "in 1 period of 2",
                lambda: motor.SecondController(every=2),
                table_expectation("overridden"),
                None,
            ),
        ),
    ),
)
