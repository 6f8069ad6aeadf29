"""Rows: foot force sensors and contacts."""

from __future__ import annotations

from surefoot.faults.case import STANDING_MODES, Row, case
from surefoot.faults.expectation import WATCH, table_expectation
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.fault import CombinedFault, Fault
from surefoot.faults.kinds.signals import SignalFault
from surefoot.faults.kinds.world_faults import LiftFault, WorkingFootSensors

FOOT_FORCE_FAULT = table_expectation("foot_force")
intermittent = inject.intermittent


def _wrong_sensors(
    change: inject.Change, change_raw: inject.Change, foot: int | None = None
) -> Fault:
    """Return a fault that changes footForceEst and footForce of one foot, or of all feet.

    A change that stores values, such as stuck(), needs a separate object for each signal.
    """
    return CombinedFault(
        WorkingFootSensors(),
        SignalFault("footForceEst", change, foot),
        SignalFault("footForce", change_raw, foot),
    )


def _foot_reports_60() -> Fault:
    return _wrong_sensors(inject.constant(60), inject.constant(60), foot=0)


def _foot_alternates_with_zero() -> Fault:
    change = intermittent(inject.off, every=20, length=10)
    return _wrong_sensors(change, change, foot=0)


# Chosen values, in N (footForceEst) and in counts (footForce): 300 exceeds the weight of a small
# robot, and 60 exceeds the load of one of its feet. 32767 is the largest int16.
ROWS = (
    Row(
        "foot_sensor",
        "foot sensors are constant, zero, drifting or saturated",
        (
            case("off", "all zero", lambda: _wrong_sensors(inject.off, inject.off), WATCH, WATCH),
            case(
                "stuck",
                "all constant",
                lambda: _wrong_sensors(inject.stuck(), inject.stuck()),
                WATCH,
                WATCH,
            ),
            case(
                "garbage",
                "all random up to 300",
                lambda: _wrong_sensors(inject.garbage(300), inject.garbage(300)),
                WATCH,
                WATCH,
            ),
            case(
                "wrong",
                "one saturated",
                lambda: _wrong_sensors(inject.constant(32767), inject.constant(32767), foot=0),
                FOOT_FORCE_FAULT,
                lying=WATCH,
                rising=WATCH,
            ),
            case(
                "slow",
                "one drifts by 50 N/s",
                lambda: _wrong_sensors(inject.drifting(0.1), inject.drifting(0.1), foot=2),
                WATCH,
                WATCH,
            ),
            case(
                "delayed",
                "all late by 50 ms",
                lambda: _wrong_sensors(inject.delayed(25), inject.delayed(25)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "all zero in 1 sample of 3",
                lambda: _wrong_sensors(
                    intermittent(inject.off, every=3), intermittent(inject.off, every=3)
                ),
                WATCH,
                WATCH,
            ),
        ),
    ),
    Row(
        "phantom_contact",
        "a contact is missed, or reported without load",
        (
            case(
                "off",
                "one foot reports zero",
                lambda: _wrong_sensors(inject.off, inject.off, foot=1),
                WATCH,
                WATCH,
            ),
            case(
                "wrong",
                "a foot lifted by 2 cm reports 60 N",
                lambda: CombinedFault(
                    _foot_reports_60(), LiftFault("FR", height=0.02, duration=0.4)
                ),
                WATCH,
                modes=STANDING_MODES,
            ),
            case(
                "garbage",
                "a foot alternates between zero and 60 N",
                lambda: CombinedFault(_foot_reports_60(), _foot_alternates_with_zero()),
                WATCH,
                lying=WATCH,
            ),
        ),
    ),
)
