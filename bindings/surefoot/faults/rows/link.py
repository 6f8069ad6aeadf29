"""Rows about the link and the clocks."""

from __future__ import annotations

from surefoot.faults import clock_faults as clock
from surefoot.faults import link_faults as link
from surefoot.faults.case import Row, case
from surefoot.faults.fault import Fault
from surefoot.faults.reaction import WATCH, as_table, refuse, unless

STALE = as_table("stale_tick")
SLOW = refuse(0.5)  # until 1 % of the reports is missing


def _suspended() -> Fault:
    return clock.Suspended(250)


LINK = (
    Row(
        "stale_tick",
        "reports stand still",
        (
            case("stuck", "the same frame for ever", lambda: link.Link(link.repeated()), STALE),
            case("wrong", "new data, the same tick", lambda: clock.Frozen(), STALE),
            case(
                "intermittent",
                "3 frames of 50 are the one before",
                lambda: link.Link(link.now_and_then(link.silence, 50, 3)),
                WATCH,
            ),
        ),
    ),
    Row(
        "reordered_tick",
        "frames arrive twice, late or in another order",
        (
            case("garbage", "each arrives twice", lambda: link.Link(link.twice), WATCH, WATCH),
            case(
                "intermittent", "1 of 25 is overtaken", lambda: link.Link(link.swapped(25)), WATCH
            ),
            case("delayed", "1 of 25 is 6 ms late", lambda: link.Link(link.late(3, 25)), WATCH),
            case(
                "wrong", "the robot begins anew at 0", lambda: clock.Tick(clock.restarted()), STALE
            ),
        ),
    ),
    Row(
        "tick_wrap",
        "the robot's clock overflows",
        (
            case("wrong", "32 bits", lambda: clock.Wrap(32), WATCH, WATCH),
            case("wrong", "31 bits", lambda: clock.Wrap(31), WATCH, WATCH),
        ),
    ),
    Row(
        "tick_jump",
        "the robot's clock jumps, or goes at another speed",
        (
            case("wrong", "50 ms ahead", lambda: clock.Tick(lambda t, k: t + 50), WATCH, None),
            case("slow", "half as fast", lambda: clock.Tick(clock.at_speed(1)), WATCH, WATCH),
            case(
                "wrong",
                "twice as fast",
                lambda: clock.Tick(clock.at_speed(4)),
                unless("clock"),
                None,
                rising=as_table("clock"),
            ),
            case(
                "intermittent",
                "8 ms ahead in 1 frame of 50",
                lambda: clock.Tick(lambda t, k: t + 8 * (k % 50 == 0)),
                WATCH,
                None,
            ),
        ),
    ),
    Row(
        "packet_loss",
        "frames are lost or damaged",
        (
            case("off", "silence", lambda: link.Link(link.silence), STALE),
            case(
                "garbage", "a bit of each is turned round", lambda: link.Link(link.flipped), STALE
            ),
            case("garbage", "random bytes", lambda: link.Link(link.noise), STALE),
            case("wrong", "half of each is missing", lambda: link.Link(link.shortened), STALE),
            case("wrong", "as long as another SDK's", lambda: link.Link(link.foreign(795)), STALE),
            case(
                "slow",
                "every second one",
                lambda: link.Link(link.now_and_then(link.silence, 2)),
                WATCH,
            ),
            case("delayed", "all by 6 ms", lambda: link.Link(link.late(3)), WATCH, WATCH),
            case("intermittent", "4 %", lambda: link.Link(link.lost(0.04)), WATCH, SLOW),
            case("intermittent", "8 %", lambda: link.Link(link.lost(0.08)), as_table("loss"), SLOW),
            case(
                "intermittent",
                "8 ms of every 100",
                lambda: link.Link(link.now_and_then(link.silence, 50, 4)),
                WATCH,
            ),
            case(
                "intermittent",
                "a bit of 1 in 10 is turned round",
                lambda: link.Link(link.now_and_then(link.flipped, 10)),
                WATCH,
            ),
        ),
    ),
)
CLOCK = (
    Row(
        "control_overrun",
        "the control loop misses its turn",
        (
            case("slow", "every second", lambda: clock.Missed(lambda k: k % 2 == 0), WATCH, None),
            case("intermittent", "10 %", lambda: clock.Missed(clock.dice(0.1)), WATCH, None),
            case(
                "stuck",
                "6 ms of every 100",
                lambda: clock.Missed(lambda k: k % 50 < 3),
                WATCH,
                None,
            ),
        ),
    ),
    Row(
        "clock_gap",
        "the program, or the robot's clock, stands still and goes on",
        (
            case(
                "stuck", "the program for 0.5 s", lambda: clock.Suspended(250), STALE, refuse(0.55)
            ),
            case(
                "wrong", "the clock steps by 0.5 s", lambda: clock.Tick(lambda t, k: t + 500), STALE
            ),
            case(
                "wrong",
                "the clock steps back by 0.5 s",
                lambda: clock.Tick(lambda t, k: t - 500),
                STALE,
            ),
        ),
    ),
)

ROWS = LINK + CLOCK
