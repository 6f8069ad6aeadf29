"""Rows: attitude of the IMU."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, table_expectation
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.signals import AttitudeFault, RandomAttitudeFault, SignalFault

# Faults that the supervisor reports for a wrong quaternion. A standing robot continues without the
# quaternion, and the fault is "quaternion". A rising robot cannot continue without the quaternion,
# and the fault is "attitude".
QUATERNION_FAULT, ATTITUDE_FAULT = table_expectation("quaternion"), table_expectation("attitude")
intermittent = inject.intermittent

# A constant attitude contradicts the gyroscope only if the robot turns, as it does in the mode
# walking. Nothing shows which of them is wrong, so the robot sits down for the fault "gyroscope".
# Some injections are below, some above the limits of imu_monitor.cpp (0.1 rad, 20 ms) and of
# has_unit_quaternion() (5 % of the length).
ROWS = (
    Row(
        "quaternion",
        "the quaternion is zero or not of unit length",
        (
            case(
                "off",
                "zero",
                lambda: SignalFault("quaternion", inject.off),
                QUATERNION_FAULT,
                rising=ATTITUDE_FAULT,
            ),
            case(
                "wrong",
                "length 0.9",
                lambda: SignalFault("quaternion", inject.scaled(0.9)),
                QUATERNION_FAULT,
                rising=ATTITUDE_FAULT,
            ),
            case(
                "wrong",
                "length 1.01",
                lambda: SignalFault("quaternion", inject.scaled(1.01)),
                WATCH,
            ),
            case(
                "wrong",
                "opposite sign in every second sample",
                lambda: SignalFault("quaternion", intermittent(inject.scaled(-1.0), every=2)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "zero in 1 sample of 10",
                lambda: SignalFault("quaternion", intermittent(inject.off, every=10)),
                WATCH,
            ),
        ),
    ),
    Row(
        "attitude_jump",
        "the attitude jumps, is constant, drifts or is late",
        (
            case(
                "wrong",
                "10 degrees of roll",
                lambda: AttitudeFault(lambda k: 10.0, axis=0),
                QUATERNION_FAULT,
                rising=ATTITUDE_FAULT,
            ),
            case(
                "wrong",
                "90 degrees of yaw",
                lambda: AttitudeFault(lambda k: 90.0, axis=2),
                QUATERNION_FAULT,
                rising=ATTITUDE_FAULT,
            ),
            case(
                "garbage",
                "a random attitude in each sample",
                RandomAttitudeFault,
                QUATERNION_FAULT,
                rising=ATTITUDE_FAULT,
            ),
            case(
                "stuck",
                "the attitude is constant",
                lambda: SignalFault("quaternion", inject.stuck()),
                WATCH,
                WATCH,
                walking=table_expectation("gyroscope"),
            ),
            case(
                "slow",
                "the pitch drifts by 3 deg/s",
                lambda: AttitudeFault(lambda k: 0.006 * k, axis=1),
                WATCH,
                None,
            ),
            case(
                "delayed",
                "the attitude is 20 ms late",
                lambda: SignalFault("quaternion", inject.delayed(10)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "10 degrees of roll in 1 sample of 10",
                lambda: AttitudeFault(lambda k: 10.0 if k % 10 == 0 else 0.0, axis=0),
                WATCH,
                None,
            ),
        ),
    ),
)
