"""Stand with the whole-body controller over UDP, in a control loop of your own."""

from __future__ import annotations

import argparse
import signal
import sys
import time

import surefoot
from surefoot.protocol import GENERATIONS, default_generation


def main() -> int:
    """Run the example; return 0 if the robot was under control until the end, else 1."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=8007)
    parser.add_argument("--duration", type=float, default=10.0, help="[s]")
    parser.add_argument("--robot", default="go1")
    parser.add_argument("--sdk", choices=GENERATIONS, help="default: that of --robot")
    args = parser.parse_args()
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda *_: sys.exit(1))  # sys.exit() runs the finally block
    try:
        robot = surefoot.load_robot(args.robot)
        link = surefoot.UdpLink(args.host, args.port, args.sdk or default_generation(args.robot))
    except surefoot.Error as problem:
        print(problem, file=sys.stderr)
        return 1
    controller = surefoot.StandController(robot)
    stood = True
    try:
        stood = loop(link, controller, surefoot.Safety(robot), args.duration)
    except KeyboardInterrupt:
        pass
    finally:
        # Damp before exit, because the motors would keep their last command.
        for _ in range(100):
            link.send(surefoot.damping_low_cmd(3.0))
            time.sleep(0.002)
    print(f"{controller.status.name}, height {controller.state.q[2]:.3f} m, ", end="")
    print(f"{link.counts.valid} states, {link.counts.lost} lost", flush=True)
    return 0 if stood and surefoot.is_usable(controller.status) else 1


def loop(
    link: surefoot.UdpLink,
    controller: surefoot.StandController,
    safety: surefoot.Safety,
    duration: float,
) -> bool:
    """Run the control loop; return True after `duration` [s], False if the loop stops earlier."""
    end = next_tick_time = time.monotonic()
    end += duration
    while (now := time.monotonic()) < end:
        has_new_state = link.receive()
        if not link.has_state:
            link.send(surefoot.damping_low_cmd(3.0))  # the robot only replies to senders of frames
        elif link.state_age > 0.1:
            print(f"no LowState for {1000 * link.state_age:.0f} ms", flush=True)
            return False
        elif has_new_state:
            command = controller.update(link.state)
            if safety.power_protect(command, link.state, 1) < 0:
                print(f"power protection, {safety.power:.0f} W", flush=True)
                return False
            link.send(command)
        if controller.status == surefoot.Status.DAMPING:
            print(f"the controller damps: {controller.fault.name}", flush=True)
            return False
        next_tick_time = max(next_tick_time + 0.002, now)
        time.sleep(max(0.0, next_tick_time - time.monotonic()))
    return True


sys.exit(main())
