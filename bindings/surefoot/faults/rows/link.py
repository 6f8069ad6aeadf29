"""Rows: link and clocks."""

from __future__ import annotations

from surefoot.faults.case import Row, case
from surefoot.faults.expectation import WATCH, expect_refusal, table_expectation, watch_unless
from surefoot.faults.kinds import clock_faults as clock
from surefoot.faults.kinds import link_faults as link

# [s] By a clock at half of the speed, the detection time of a walking robot counts twice.
SLOW_CLOCK_DELAY = 0.4
STALE_TICK_FAULT = table_expectation("stale_tick")
# [s] Time limit of a refusal for lost frames. With 4 % of the frames lost, the arming check "link"
# fails after 0.3 s: then its mean share of missing samples (time constant 1 s) reaches 1 %.
LATE_REFUSAL = expect_refusal(0.5)


# Some injections are below, some above kHoldTime (10 ms), kRobotWatchdogTime (100 ms), and the
# limits of missing samples: 1 % for arming, 5 % for the fault "loss". A LowState of go1-v3.4 has
# 795 bytes.
LINK_ROWS = (
    Row(
        "stale_tick",
        "samples do not advance",
        (
            case(
                "stuck",
                "the same frame repeats",
                lambda: link.LinkFault(link.frozen_frame()),
                STALE_TICK_FAULT,
            ),
            case("wrong", "new data, the same tick", clock.FrozenTick, STALE_TICK_FAULT),
            case(
                "intermittent",
                "3 frames of 50 are lost",
                lambda: link.LinkFault(link.intermittent(link.no_frame, every=50, length=3)),
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
                "each frame arrives twice",
                lambda: link.LinkFault(link.duplicated),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "1 frame of 25 arrives after the next one",
                lambda: link.LinkFault(link.swapped(25)),
                WATCH,
            ),
            case(
                "delayed",
                "1 frame of 25 is 6 ms late",
                lambda: link.LinkFault(link.delayed(3, every=25)),
                WATCH,
            ),
            case(
                "wrong",
                "the robot's clock restarts at 0",
                lambda: clock.TickFault(clock.restarted_clock()),
                STALE_TICK_FAULT,
            ),
        ),
    ),
    Row(
        "tick_wrap",
        "the robot's clock overflows",
        (
            case(
                "wrong",
                "32 bits: the tick returns to 0",
                lambda: clock.TickOverflow(32),
                WATCH,
                WATCH,
            ),
            case(
                "wrong",
                "31 bits: a signed tick becomes negative",
                lambda: clock.TickOverflow(31),
                WATCH,
                WATCH,
            ),
        ),
    ),
    Row(
        "tick_jump",
        "the robot's clock jumps, or runs at another speed",
        (
            case(
                "wrong",
                "the clock jumps ahead by 50 ms",
                lambda: clock.TickFault(lambda t, k: t + 50),
                WATCH,
                None,
            ),
            case(
                "slow",
                "the clock runs half as fast",
                lambda: clock.TickFault(clock.clock_with_step(ms_per_period=1)),
                WATCH,
                WATCH,
                walking=table_expectation("clock", delay=SLOW_CLOCK_DELAY),
            ),
            case(
                "wrong",
                "the clock runs twice as fast",
                lambda: clock.TickFault(clock.clock_with_step(ms_per_period=4)),
                watch_unless("clock"),
                None,
                rising=table_expectation("clock"),
            ),
            case(
                "intermittent",
                "the clock is 8 ms ahead in 1 frame of 50",
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
            case("off", "no frames", lambda: link.LinkFault(link.no_frame), STALE_TICK_FAULT),
            case(
                "garbage",
                "each frame has a flipped bit",
                lambda: link.LinkFault(link.flipped_bit),
                STALE_TICK_FAULT,
            ),
            case(
                "garbage",
                "frames of random bytes",
                lambda: link.LinkFault(link.random_bytes),
                STALE_TICK_FAULT,
            ),
            case(
                "wrong",
                "half of each frame is missing",
                lambda: link.LinkFault(link.truncated),
                STALE_TICK_FAULT,
            ),
            case(
                "wrong",
                "frames have the length of another generation",
                lambda: link.LinkFault(link.wrong_length(795)),
                STALE_TICK_FAULT,
            ),
            case(
                "slow",
                "1 frame of 2 is lost",
                lambda: link.LinkFault(link.intermittent(link.no_frame, every=2)),
                WATCH,
            ),
            case(
                "delayed",
                "all frames are 6 ms late",
                lambda: link.LinkFault(link.delayed(3)),
                WATCH,
                WATCH,
            ),
            case(
                "intermittent",
                "4 % of the frames are lost",
                lambda: link.LinkFault(link.random_loss(0.04)),
                WATCH,
                LATE_REFUSAL,
            ),
            case(
                "intermittent",
                "8 % of the frames are lost",
                lambda: link.LinkFault(link.random_loss(0.08)),
                table_expectation("loss"),
                LATE_REFUSAL,
            ),
            case(
                "intermittent",
                "the frames of 8 ms in every 100 ms are lost",
                lambda: link.LinkFault(link.intermittent(link.no_frame, every=50, length=4)),
                WATCH,
            ),
            case(
                "intermittent",
                "1 frame of 10 has a flipped bit",
                lambda: link.LinkFault(link.intermittent(link.flipped_bit, every=10)),
                WATCH,
            ),
        ),
    ),
)
# The stop of the process and the clock steps (0.5 s) exceed kRobotWatchdogTime. Gaps of 6 ms, in
# every 100 ms, are shorter than kHoldTime.
CLOCK_ROWS = (
    Row(
        "control_overrun",
        "the control loop misses periods",
        (
            case(
                "slow",
                "1 period of 2 is missed",
                lambda: clock.MissedPeriods(lambda k: k % 2 == 0),
                WATCH,
                None,
            ),
            case(
                "intermittent",
                "10 % of the periods are missed",
                lambda: clock.MissedPeriods(clock.random_periods(0.1)),
                WATCH,
                None,
            ),
            case(
                "stuck",
                "the periods of 6 ms in every 100 ms are missed",
                lambda: clock.MissedPeriods(lambda k: k % 50 < 3),
                WATCH,
                None,
            ),
        ),
    ),
    Row(
        "clock_gap",
        "the control process stops for 0.5 s, or the robot's clock steps by 0.5 s",
        (
            case(
                "stuck",
                "the process stops",
                lambda: clock.ProcessSuspended(periods=250),
                STALE_TICK_FAULT,
                expect_refusal(0.55),
            ),
            case(
                "wrong",
                "the clock steps forward",
                lambda: clock.TickFault(lambda t, k: t + 500),
                STALE_TICK_FAULT,
            ),
            case(
                "wrong",
                "the clock steps back",
                lambda: clock.TickFault(lambda t, k: t - 500),
                STALE_TICK_FAULT,
            ),
        ),
    ),
)

ROWS = LINK_ROWS + CLOCK_ROWS
