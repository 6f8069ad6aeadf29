"""Round trip of a LowState and its LowCmd over DDS on loopback, between two processes.

    python benchmarks/dds_round_trip.py [--seconds 10] [--rate 500] [--library FILE]

One process is the robot: it sends LowStates at the rate, and waits for the command that answers
each of them. The other one answers every LowState at once through a DdsLink. Both poll every 20 us.
Printed: the time from send() of the LowState to receive() of its command [ms], and how many were
not answered within a period. On a machine with other load use real-time priority: chrt -f 50
python benchmarks/dds_round_trip.py
"""

from __future__ import annotations

import argparse
import multiprocessing
import time
from multiprocessing.synchronize import Event

import numpy as np
import surefoot

DOMAIN = 7
POLL_PERIOD = 20e-6  # [s] leaves time for the threads of Cyclone DDS on a small machine


def answer(library: str, stop: Event) -> None:
    """Answer each LowState with a command whose reserve is its tick."""
    link = surefoot.DdsLink(surefoot.DdsNetwork("lo", DOMAIN, library=library), "go2")
    cmd = surefoot.LowCmd()
    while not stop.is_set():
        if link.receive():
            cmd.reserve = link.state.tick
            link.send(cmd)
        time.sleep(POLL_PERIOD)


def measure(
    port: surefoot.DdsRobotPort, state: surefoot.LowState, seconds: float, rate: float
) -> list[float]:
    """Send LowStates with increasing ticks; return the times of the round trips [ms].

    Infinity: not answered within a period.
    """
    period, times = 1.0 / rate, []
    next_time = time.perf_counter()
    for _ in range(round(seconds * rate)):
        state.tick += 2
        sent = time.perf_counter()
        port.send(state)
        next_time += period
        elapsed = np.inf
        while time.perf_counter() < next_time:
            cmd = port.receive()
            if cmd is not None and cmd.reserve == state.tick:
                elapsed = time.perf_counter() - sent
                break
            time.sleep(POLL_PERIOD)
        times.append(1000.0 * elapsed)
        time.sleep(max(0.0, next_time - time.perf_counter()))
    return times


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--rate", type=float, default=500.0)
    parser.add_argument("--library", default="")
    arguments = parser.parse_args()
    stop = multiprocessing.get_context("spawn").Event()
    process = multiprocessing.get_context("spawn").Process(
        target=answer, args=(arguments.library, stop)
    )
    process.start()
    network = surefoot.DdsNetwork("lo", DOMAIN, library=arguments.library)
    port = surefoot.DdsRobotPort(network, "go2", discovery_time=0.5)
    state = surefoot.LowState()
    state.imu.quaternion[:] = [1.0, 0.0, 0.0, 0.0]
    while np.isinf(min(measure(port, state, 0.1, arguments.rate))):  # the link is not open yet
        pass
    measure(port, state, 1.0, arguments.rate)
    times = np.array(measure(port, state, arguments.seconds, arguments.rate))
    stop.set()
    process.join()
    p50, p99 = np.percentile(times, [50, 99], method="higher")
    print(f"{network.notices[0]}; {arguments.rate:g} Hz, {len(times)} round trips")
    missing = int(np.sum(np.isinf(times)))
    print(f"p50 {p50:.3f} ms, p99 {p99:.3f} ms, max {times.max():.3f} ms, {missing} not answered")


if __name__ == "__main__":
    main()
