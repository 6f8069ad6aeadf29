"""Common part of the low-level examples: a 500 Hz loop over UDP with the power protection."""

from __future__ import annotations

import argparse
import signal
import sys
import time
from collections.abc import Callable

import surefoot
from surefoot.protocol import GENERATIONS, default_generation

DT = 0.002  # [s] time between two ticks
STATE_TIMEOUT = 0.1  # [s] longest time without a LowState, as that of the robot without a command
FINAL_DAMPING_TICKS = 100  # number of damping commands before exit
HIP_TAU = {surefoot.FR_0: -0.65, surefoot.FL_0: 0.65, surefoot.RR_0: -0.65, surefoot.RL_0: 0.65}

Control = Callable[[int, surefoot.LowState, surefoot.LowCmd], str]


def run(control: Control, description: str, protect_from_tick: int = 1) -> int:
    """Run an example: parse the command line, and call control(n, state, cmd) in tick n = 1, 2 ...

    Args:
        control: Function that writes cmd and returns a line to print, or "" for no line.
        description: What the example does, for --help and the start message.
        protect_from_tick: First tick in which power_protect() at level 1 checks the samples.

    Returns:
        The exit status: 0; 1 if there is no robot or its LowStates stop; 255 after a trip of the
        power protection, as exit(-1) in the SDK's examples.
    """
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=8007)
    parser.add_argument("--duration", type=float, default=10.0, help="[s]")
    parser.add_argument("--robot", default="go1")
    parser.add_argument("--sdk", choices=GENERATIONS, help="default: that of --robot")
    args = parser.parse_args()
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda *_: sys.exit(1))  # sys.exit() runs the finally block
    try:
        link = surefoot.UdpLink(args.host, args.port, args.sdk or default_generation(args.robot))
        safety = surefoot.Safety(surefoot.load_robot(args.robot))
    except surefoot.Error as problem:
        print(problem, file=sys.stderr)
        return 1
    print(f"{description} Make sure the robot is hung up.", flush=True)
    try:
        if not _wait_for_robot(link):
            why = link.last_reject if link.counts.received else "no answer within 2 s"
            print(f"no robot at {args.host}:{args.port}: {why}", file=sys.stderr)
            return 1
        return _loop(link, safety, control, args.duration, protect_from_tick)
    except KeyboardInterrupt:
        return 0
    finally:
        # Damp before exit, because the motors would keep their last command.
        _damp(link)


def _loop(
    link: surefoot.UdpLink,
    safety: surefoot.Safety,
    control: Control,
    duration: float,
    protect_from_tick: int,
) -> int:
    cmd, next_tick_time = surefoot.LowCmd(), time.monotonic()
    for n in range(1, round(duration / DT) + 1):
        has_new_state = link.receive()
        if link.state_age > STATE_TIMEOUT:
            print(f"tick {n}: no LowState for {1000 * link.state_age:.0f} ms; damping", flush=True)
            return 1
        state = link.state
        for motor, tau in HIP_TAU.items():
            cmd.motorCmd[motor].tau = tau
        if line := control(n, state, cmd):
            print(line, flush=True)
        # Check each LowState only once.
        if has_new_state and n >= protect_from_tick and safety.power_protect(cmd, state, 1) < 0:
            print(f"tick {n}: power protection, {safety.power:.0f} W; damping", flush=True)
            return 255
        link.send(cmd)
        next_tick_time = _sleep_until(next_tick_time + DT)
    return 0


def _wait_for_robot(link: surefoot.UdpLink) -> bool:
    for _ in range(1000):
        link.send(surefoot.LowCmd())  # the link sends damping until the first valid LowState
        time.sleep(DT)
        if link.receive():
            return True
    return False


def _damp(link: surefoot.UdpLink) -> None:
    for _ in range(FINAL_DAMPING_TICKS):
        link.send(surefoot.damping_low_cmd(3.0))
        time.sleep(DT)


def _sleep_until(next_tick_time: float) -> float:
    late = time.monotonic() - next_tick_time
    if late < 0.0:
        time.sleep(-late)
        return next_tick_time
    return next_tick_time + late  # a late tick delays all later ticks by the same time
