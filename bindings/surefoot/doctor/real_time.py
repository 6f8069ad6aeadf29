"""Checks of the processor, the scheduler and the timer."""

from __future__ import annotations

import os
import platform
import resource
import time
from pathlib import Path
from typing import Any

import numpy as np

from surefoot.doctor.finding import Finding, Verdict
from surefoot.system.machine import describe_machine

AREA = "real time"
PERIOD = 0.002  # [s] of the timer check, as at 500 Hz
_PRIORITY = 80  # SCHED_FIFO priority that a Runner requests, kPriority in real_time_scope.cpp
# [s] 99th percentile of the delay after a deadline above which a loop at 500 Hz is late too often.
# Chosen: a quarter of the period.
_MAX_DELAY = 0.0005
_GIB = 2.0**30
_RIGHTS = "add to /etc/security/limits.d/surefoot.conf, then log in again: "


def check_real_time(timer_seconds: float) -> list[Finding]:
    """Check processor, kernel, rights and timer.

    Args:
        timer_seconds: Time for which the timer is measured [s].
    """
    machine = describe_machine()
    return [
        _check_processor(machine),
        _check_governor(machine["governor"]),
        _check_kernel(),
        _check_priority(),
        _check_memory_lock(),
        _check_timer(timer_seconds),
    ]


def timer_delays(seconds: float) -> np.ndarray:
    """Sleep until absolute deadlines with a period of PERIOD.

    Args:
        seconds: Time of the measurement [s].

    Returns:
        Delay after each deadline [s].
    """
    begin = time.monotonic()
    delays = []
    for k in range(1, max(1, round(seconds / PERIOD)) + 1):
        deadline = begin + k * PERIOD
        time.sleep(max(0.0, deadline - time.monotonic()))
        delays.append(time.monotonic() - deadline)
    return np.array(delays)


def _check_processor(machine: dict[str, Any]) -> Finding:
    value = f"{machine['cpu']}, {machine['cores']} cores, {platform.machine()}"
    flags = _processor_flags()
    if flags:
        found = [name for name in ("sse4_2", "avx", "avx2", "avx512f") if name in flags]
        value += f", {' '.join(found) or 'no SSE 4.2'}"
    if platform.machine() == "x86_64" and flags and "avx" not in flags:
        remedy = "MuJoCo needs AVX: the controller works here, the simulation does not"
        return Finding(AREA, "processor", value, Verdict.LIMITED, remedy)
    return Finding(AREA, "processor", value, Verdict.GOOD)


def _processor_flags() -> set[str]:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:  # not Linux
        return set()
    flags = [line.partition(":")[2] for line in lines if line.startswith("flags")]
    return set(flags[0].split()) if flags else set()


def _check_governor(governor: str | None) -> Finding:
    if governor in (None, "performance"):
        return Finding(AREA, "frequency governor", governor or "none", Verdict.GOOD)
    remedy = "ticks are slower at first; run: sudo cpupower frequency-set -g performance"
    return Finding(AREA, "frequency governor", governor, Verdict.LIMITED, remedy)


def _check_kernel() -> Finding:
    preemption = "PREEMPT_RT" if "PREEMPT_RT" in platform.version() else "without PREEMPT_RT"
    return Finding(AREA, "kernel", f"{platform.release()}, {preemption}", Verdict.INFO)


def _check_priority() -> Finding:
    """Check whether this user may run a thread with SCHED_FIFO, without doing so."""
    limit = resource.getrlimit(resource.RLIMIT_RTPRIO)[0]
    may = os.geteuid() == 0 or limit == resource.RLIM_INFINITY or limit >= _PRIORITY
    subject = f"SCHED_FIFO, priority {_PRIORITY}"
    if may:
        return Finding(AREA, subject, "permitted", Verdict.GOOD)
    value = f"not permitted, largest priority {limit}"
    return Finding(AREA, subject, value, Verdict.LIMITED, f"{_RIGHTS}* - rtprio {_PRIORITY}")


def _check_memory_lock() -> Finding:
    limit = resource.getrlimit(resource.RLIMIT_MEMLOCK)[0]
    if os.geteuid() == 0 or limit == resource.RLIM_INFINITY:
        return Finding(AREA, "locked memory", "no limit", Verdict.GOOD)
    value = f"at most {limit / _GIB:.3f} GiB"
    return Finding(AREA, "locked memory", value, Verdict.LIMITED, f"{_RIGHTS}* - memlock unlimited")


def _check_timer(seconds: float) -> Finding:
    delays = timer_delays(seconds)
    p50, p99, worst = (1e6 * value for value in np.quantile(delays, (0.5, 0.99, 1.0)))
    value = (
        f"{delays.size} deadlines, {1000 * PERIOD:g} ms apart: {p50:.0f} us late at p50, "
        f"{p99:.0f} at p99, {worst:.0f} at most"
    )
    if 1e-6 * p99 <= _MAX_DELAY:
        return Finding(AREA, "timer", value, Verdict.GOOD)
    remedy = "end other programs, or give the controller a core of its own: isolcpus, taskset"
    return Finding(AREA, "timer", value, Verdict.LIMITED, remedy)
