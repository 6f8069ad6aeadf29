"""Row without a fault, for comparison: the supervisor must not detect any fault."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH
from surefoot.faults.kinds.fault import Fault
from surefoot.faults.kinds.link_faults import LinkFault

ROWS = (
    Row(
        "healthy",
        "no fault, for comparison",
        (
            case("off", "no fault", Fault, WATCH, WATCH),
            case(
                "off",
                "no fault; samples sent as frames",
                lambda: LinkFault(_unchanged),
                WATCH,
                WATCH,
            ),
        ),
    ),
)


def _unchanged(frame: bytes, k: int) -> list[bytes]:
    return [frame]
