"""Rows: joint angles and velocities."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, table_expectation
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.joint_faults import JointOutsideLimits
from surefoot.faults.kinds.signals import SignalFault

KNEE = 5  # FL_2
intermittent = inject.intermittent

# JointMonitor allows jumps of 0.08 rad beyond the measured velocity. No motor exceeds 31 rad/s
# (models/*.toml), and check_low_state() rejects more than twice this speed. Noise of 1 rad/s is 20
# times the noise of the measured velocities.
ROWS = (
    Row(
        "joint_limit",
        "a joint reports an angle beyond its limit",
        (
            case(
                "wrong",
                "a knee reports 0.3 rad beyond its stop",
                lambda: JointOutsideLimits(0.3, KNEE, True),
                table_expectation("joint_jump"),
            ),
            case(
                "intermittent",
                "a knee: 0.3 rad beyond its stop, 1 sample of 25",
                lambda: JointOutsideLimits(0.3, KNEE, True, 25),
                WATCH,
            ),
        ),
    ),
    Row(
        "joint_speed",
        "joint speeds at or beyond the motors' limits",
        (
            case(
                "wrong",
                "a knee reports 100 rad/s",
                lambda: SignalFault("dq", inject.constant(100.0), KNEE),
                table_expectation("state_implausible"),
            ),
            case(
                "off", "a knee reports 0", lambda: SignalFault("dq", inject.off, KNEE), WATCH, WATCH
            ),
            case(
                "garbage",
                "noise of 1 rad/s on all",
                lambda: SignalFault("dq", inject.noise(1.0)),
                WATCH,
                WATCH,
            ),
            case(
                "delayed",
                "all by 10 ms",
                lambda: SignalFault("dq", inject.delayed(5)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "a knee reports 25 rad/s in 1 sample of 25",
                lambda: SignalFault("dq", intermittent(inject.constant(25.0), 25), KNEE),
                WATCH,
                None,
            ),
        ),
    ),
)
