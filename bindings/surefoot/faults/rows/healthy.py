"""The control: nothing goes wrong, and nothing may trip."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.fault import Fault
from surefoot.faults.link_faults import Link
from surefoot.faults.reaction import WATCH

ROWS = (
    Row(
        "healthy",
        "nothing: the control",
        (
            case("off", "nothing", Fault, WATCH, WATCH),
            case("off", "nothing, through frames", lambda: Link(_as_it_is), WATCH, WATCH),
        ),
    ),
)


def _as_it_is(frame: bytes, k: int) -> list[bytes]:
    return [frame]
