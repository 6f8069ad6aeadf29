"""Rows: link and clocks."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, table_expectation, watch_unless
from surefoot.faults.kinds import clock_faults as clock
from surefoot.faults.kinds import link_faults as link
from surefoot.faults.kinds.fault import Fault

STALE = table_expectation("stale_tick")
# [s] Time limit of a refusal. If 4 % of the frames are lost, the arming check needs 0.3 s to count
# 1 % missing samples.
SLOW = expect_refusal(0.5)


def _suspended() -> Fault:
    return clock.ProgramSuspended(250)


# Some injections are below, some above kHoldTime (10 ms), kRobotWatchdogTime (100 ms), and the
# limits of missing samples: 1 % for arming, 5 % for the fault "loss". A LowState of go1-v3.4 has
# 795 bytes.
LINK = (
    Row(
        "stale_tick",
        "samples do not advance",
        (
            case(
                "stuck",
                "the same frame repeats",
                lambda: link.LinkFault(link.frozen_frame()),
                STALE,
            ),
            case("wrong", "new data, the same tick", lambda: clock.FrozenTick(), STALE),
            case(
                "intermittent",
                "3 frames of 50 are lost",
                lambda: link.LinkFault(link.intermittent(link.no_frame, 50, 3)),
                WATCH,
            ),
        ),
    ),
    Row(
        "reordered_tick",
        "frames arrive twice, late or in another order",
        (
            case(
                "garbage",
                "each arrives twice",
                lambda: link.LinkFault(link.duplicated),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "1 of 25 is overtaken",
                lambda: link.LinkFault(link.swapped(25)),
                WATCH,
            ),
            case(
                "delayed",
                "1 of 25 is 6 ms late",
                lambda: link.LinkFault(link.delayed(3, 25)),
                WATCH,
            ),
            case(
                "wrong",
                "the robot's clock restarts at 0",
                lambda: clock.TickFault(clock.restarted_clock()),
                STALE,
            ),
        ),
    ),
    Row(
        "tick_wrap",
        "the robot's clock overflows",
        (
            case("wrong", "32 bits", lambda: clock.TickOverflow(32), WATCH, WATCH),
            case("wrong", "31 bits", lambda: clock.TickOverflow(31), WATCH, WATCH),
        ),
    ),
    Row(
        "tick_jump",
        "the robot's clock jumps, or runs at another speed",
        (
            case("wrong", "50 ms ahead", lambda: clock.TickFault(lambda t, k: t + 50), WATCH, None),
            case(
                "slow",
                "half as fast",
                lambda: clock.TickFault(clock.clock_at_speed(1)),
                WATCH,
                WATCH,
            ),
            case(
                "wrong",
                "twice as fast",
                lambda: clock.TickFault(clock.clock_at_speed(4)),
                watch_unless("clock"),
                None,
                rising=table_expectation("clock"),
            ),
            case(
                "intermittent",
                "8 ms ahead in 1 frame of 50",
                lambda: clock.TickFault(lambda t, k: t + 8 * (k % 50 == 0)),
                WATCH,
                None,
            ),
        ),
    ),
    Row(
        "packet_loss",
        "frames are lost or damaged",
        (
            case("off", "no frames", lambda: link.LinkFault(link.no_frame), STALE),
            case(
                "garbage",
                "one bit of each is flipped",
                lambda: link.LinkFault(link.flipped_bit),
                STALE,
            ),
            case("garbage", "random bytes", lambda: link.LinkFault(link.random_bytes), STALE),
            case("wrong", "half of each is missing", lambda: link.LinkFault(link.truncated), STALE),
            case(
                "wrong",
                "length of another SDK's frames",
                lambda: link.LinkFault(link.wrong_length(795)),
                STALE,
            ),
            case(
                "slow",
                "every second one",
                lambda: link.LinkFault(link.intermittent(link.no_frame, 2)),
                WATCH,
            ),
            case("delayed", "all by 6 ms", lambda: link.LinkFault(link.delayed(3)), WATCH, WATCH),
            case(
                "intermittent", "4 %", lambda: link.LinkFault(link.random_loss(0.04)), WATCH, SLOW
            ),
            case(
                "intermittent",
                "8 %",
                lambda: link.LinkFault(link.random_loss(0.08)),
                table_expectation("loss"),
                SLOW,
            ),
            case(
                "intermittent",
                "8 ms of every 100",
                lambda: link.LinkFault(link.intermittent(link.no_frame, 50, 4)),
                WATCH,
            ),
            case(
                "intermittent",
                "one bit of 1 in 10 is flipped",
                lambda: link.LinkFault(link.intermittent(link.flipped_bit, 10)),
                WATCH,
            ),
        ),
    ),
)
# Gaps of 0.5 s exceed kRobotWatchdogTime. Gaps of 6 ms in every 100 ms are shorter than kHoldTime.
CLOCK = (
    Row(
        "control_overrun",
        "the control loop misses periods",
        (
            case(
                "slow",
                "every second period",
                lambda: clock.MissedPeriods(lambda k: k % 2 == 0),
                WATCH,
                None,
            ),
            case(
                "intermittent",
                "10 % of the periods",
                lambda: clock.MissedPeriods(clock.random_periods(0.1)),
                WATCH,
                None,
            ),
            case(
                "stuck",
                "6 ms of every 100",
                lambda: clock.MissedPeriods(lambda k: k % 50 < 3),
                WATCH,
                None,
            ),
        ),
    ),
    Row(
        "clock_gap",
        "the control process or the robot's clock stops for a time",
        (
            case(
                "stuck",
                "the process stops for 0.5 s",
                lambda: clock.ProgramSuspended(250),
                STALE,
                expect_refusal(0.55),
            ),
            case(
                "wrong",
                "the clock steps by 0.5 s",
                lambda: clock.TickFault(lambda t, k: t + 500),
                STALE,
            ),
            case(
                "wrong",
                "the clock steps back by 0.5 s",
                lambda: clock.TickFault(lambda t, k: t - 500),
                STALE,
            ),
        ),
    ),
)

ROWS = LINK + CLOCK
