"""What keeps other programs and Python itself from holding the robot up."""

from __future__ import annotations

import gc
import os

_PRIORITY = 70  # below the controller's, above everything ordinary


class RealTimePriority:
    """Real-time scheduling where the system permits it, and no garbage collection, for a while.

    A cycle leaves no cycles of references behind, so nothing piles up.

    Attributes:
        granted: What was permitted, in words.
    """

    granted = "not asked"

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
