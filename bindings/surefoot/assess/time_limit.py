"""Limit of the run time of code that may never return."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from surefoot._core import Error


class TimeLimitExceeded(Error):
    """The code in the context of time_limit() took longer than the limit."""


@contextmanager
def time_limit(seconds: float, what: str) -> Iterator[None]:
    """Raise TimeLimitExceeded if the code in this context takes longer than a limit.

    Outside the main thread there is no limit: the limit uses the signal SIGALRM, and Python handles
    signals only in the main thread.

    Args:
        seconds: Longest wall time of the code [s].
        what: Name of the code in the message.
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
