"""A limit of time for what may never return."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from surefoot._core import Error


class TimeLimitExceeded(Error):
    """What is within time_limit() took longer."""


@contextmanager
def time_limit(seconds: float, what: str) -> Iterator[None]:
    """Raise Overdue if what is within takes longer; only in the main thread is there a limit.

    Args:
        seconds: At most [s].
        what: For the message.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def raise_exceeded(number: int, frame: FrameType | None) -> None:
        raise TimeLimitExceeded(f"{what} took longer than {seconds:g} s, expected it to return")

    previous_handler = signal.signal(signal.SIGALRM, raise_exceeded)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, previous_handler)
