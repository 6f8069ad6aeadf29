"""Rows: joint angles and velocities."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, table_expectation
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.joint_faults import JointOutsideLimits
from surefoot.faults.kinds.signals import SignalFault

CALF = 5  # FL_2
intermittent = inject.intermittent

# JointMonitor allows an angle to change, between two samples, by 0.08 rad more than the measured
# velocity explains. No motor exceeds 31 rad/s (models/*.toml), and check_low_state() rejects more
# than twice the speed limit of a motor. Noise of 1 rad/s is 20 times the noise of real encoders
# (VELOCITY_NOISE, 0.05 rad/s).
ROWS = (
    Row(
        "joint_limit",
        "a calf joint reports an angle beyond its limit",
        (
            case(
                "wrong",
                "0.3 rad below the lower limit",
                lambda: JointOutsideLimits(0.3, CALF, below=True),
                table_expectation("joint_jump"),
            ),
            case(
                "intermittent",
                "0.3 rad below the lower limit, in 1 sample of 25",
                lambda: JointOutsideLimits(0.3, CALF, below=True, every=25),
                WATCH,
            ),
        ),
    ),
    Row(
        "joint_speed",
        "measured joint velocities are wrong",
        (
            case(
                "wrong",
                "a calf joint reports 100 rad/s",
                lambda: SignalFault("dq", inject.constant(100.0), CALF),
                table_expectation("state_implausible"),
            ),
            case(
                "off",
                "a calf joint reports 0",
                lambda: SignalFault("dq", inject.off, CALF),
                WATCH,
                WATCH,
            ),
            case(
                "garbage",
                "all have noise of 1 rad/s",
                lambda: SignalFault("dq", inject.noise(1.0)),
                WATCH,
                WATCH,
            ),
            case(
                "delayed",
                "all late by 10 ms",
                lambda: SignalFault("dq", inject.delayed(5)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "a calf joint reports 25 rad/s in 1 sample of 25",
                lambda: SignalFault("dq", intermittent(inject.constant(25.0), every=25), CALF),
                WATCH,
                None,
            ),
        ),
    ),
)
