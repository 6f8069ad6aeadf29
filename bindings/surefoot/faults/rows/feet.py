"""Rows: foot force sensors and contacts."""

from __future__ import annotations

from surefoot.faults.case import STANDING_MODES, Row, case
from surefoot.faults.expectation import WATCH, table_expectation
from surefoot.faults.kinds import signal_faults as inject
from surefoot.faults.kinds.fault import CombinedFault, Fault
from surefoot.faults.kinds.signals import SignalFault
from surefoot.faults.kinds.world_faults import LiftFault, WorkingFootSensors

NO_FORCE = table_expectation("foot_force")
intermittent = inject.intermittent


def _feet(change: inject.Change, change_raw: inject.Change, foot: int | None = None) -> Fault:
    return CombinedFault(
        WorkingFootSensors(),
        SignalFault("footForceEst", change, foot),
        SignalFault("footForce", change_raw, foot),
    )


def _foot_at_60() -> Fault:
    return _feet(inject.constant(60), inject.constant(60), 0)


# Chosen values, in N (footForceEst) and in counts (footForce): 300 exceeds the weight of a small
# robot, and 60 exceeds the load of one of its feet. 32767 is the largest int16.
ROWS = (
    Row(
        "foot_sensor",
        "foot sensors are constant, zero, drifting or saturated",
        (
            case("off", "all zero", lambda: _feet(inject.off, inject.off), WATCH, WATCH),
            case(
                "stuck", "all constant", lambda: _feet(inject.stuck(), inject.stuck()), WATCH, WATCH
            ),
            case(
                "garbage",
                "all random up to 300",
                lambda: _feet(inject.garbage(300), inject.garbage(300)),
                WATCH,
                WATCH,
            ),
            case(
                "wrong",
                "one saturated",
                lambda: _feet(inject.constant(32767), inject.constant(32767), 0),
                NO_FORCE,
                lying=WATCH,
                rising=WATCH,
            ),
            case(
                "slow",
                "one drifts by 50 N a second",
                lambda: _feet(inject.drifting(0.1), inject.drifting(0.1), 2),
                WATCH,
                WATCH,
            ),
            case(
                "delayed",
                "all by 50 ms",
                lambda: _feet(inject.delayed(25), inject.delayed(25)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "all zero in 1 sample of 3",
                lambda: _feet(intermittent(inject.off, 3), intermittent(inject.off, 3)),
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
                lambda: _feet(inject.off, inject.off, 1),
                WATCH,
                WATCH,
            ),
            case(
                "wrong",
                "a foot lifted by 2 cm reports 60 N",
                lambda: CombinedFault(_foot_at_60(), LiftFault("FR", 0.02, 0.4)),
                WATCH,
                modes=STANDING_MODES,
            ),
            case(
                "garbage",
                "a foot alternates between zero and 60 N",
                lambda: CombinedFault(
                    _foot_at_60(), _feet(*2 * (intermittent(inject.off, 20, 10),), 0)
                ),
                WATCH,
                lying=WATCH,
            ),
        ),
    ),
)
