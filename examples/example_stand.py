"""Stand: the whole-body controller over UDP, in a loop of one's own."""

from __future__ import annotations

import argparse
import sys
import time

import surefoot
from surefoot.protocol import GENERATIONS, default_generation


def main() -> int:
    """Run; returns 0 if the robot was under control to the end."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=8007)
    parser.add_argument("--duration", type=float, default=10.0, help="[s]")
    parser.add_argument("--robot", default="go1")
    parser.add_argument("--sdk", choices=GENERATIONS, help="the robot's own, if not given")
    args = parser.parse_args()
    robot = surefoot.load_robot(args.robot)
    controller, safety = surefoot.StandController(robot), surefoot.Safety(robot)
    link = surefoot.UdpLink(args.host, args.port, args.sdk or default_generation(args.robot))
    begin = due = time.monotonic()
    while (now := time.monotonic()) < begin + args.duration:
        if link.receive():
            command = controller.update(link.state)
            if safety.power_protect(command, link.state, 1) < 0:
                print(f"power protection, {safety.power:.0f} W", flush=True)
                break
            link.send(command)
        elif not link.known:
            link.send(surefoot.damping_low_cmd(3.0))  # so that the robot knows whom to answer
        elif link.age > 0.02:
            print(f"no LowState for {1000 * link.age:.0f} ms", flush=True)
            break
        if controller.status == surefoot.Status.DAMPING:
            print(f"the controller damps: {controller.fault.name}", flush=True)
            break
        due = max(due + 0.002, now)
        time.sleep(max(0.0, due - time.monotonic()))
    print(f"{controller.status.name} after {time.monotonic() - begin:.1f} s, ", end="")
    print(f"height {controller.state.q[2]:.3f} m, {link.counts.lost} states lost", flush=True)
    for _ in range(100):
        link.send(surefoot.damping_low_cmd(3.0))
        time.sleep(0.002)
    return 0 if surefoot.is_usable(controller.status) and link.age < 0.5 else 1


sys.exit(main())
