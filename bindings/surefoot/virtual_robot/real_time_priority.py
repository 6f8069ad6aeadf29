"""Real-time priority, so that other processes and Python do not delay the virtual robot."""

from __future__ import annotations

import gc
import os

# SCHED_FIFO priority. Chosen: lower than the priority of the controller, 80 (kPriority).
_PRIORITY = 70


class RealTimePriority:
    """Context manager that requests SCHED_FIFO and switches off the garbage collector of Python.

    VirtualRobot.cycle() creates no objects that refer to each other in a circle, so memory does not
    grow without the collector.

    Attributes:
        granted: Scheduling that the system granted, as text.
    """

    granted = "not requested"

    def __enter__(self) -> RealTimePriority:
        gc.collect()
        gc.disable()
        try:
            os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(_PRIORITY))
            self.granted = f"SCHED_FIFO priority {_PRIORITY}"
        except (OSError, AttributeError) as problem:
            self.granted = f"ordinary scheduling (SCHED_FIFO: {problem})"
        return self

    def __exit__(self, *_: object) -> None:
        gc.enable()
        if self.granted.startswith("SCHED_FIFO"):
            os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))
