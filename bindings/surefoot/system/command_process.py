"""Signals and streams of a process of the command surefoot, prepared before its slow imports."""

from __future__ import annotations

import io
import os
import signal
import sys
from types import FrameType, TracebackType
from typing import Any

INTERRUPTED = 130  # exit status after Ctrl-C
# [s] Time after which an interrupt is repeated that Python has discarded. Chosen: the destructor or
# callback that discarded it has returned by then.
_REPEAT_TIME = 0.05

_interrupted = False


def prepare_process() -> None:
    """Prepare this process if it is the command surefoot; do nothing in any other process.

    Ctrl-C during imports ends the process at once, with one line and status 130: an exception would
    pass through libraries that print, replace or discard it. A failed import is reported in one
    line. Streams that the shell has closed become the null device, so that no file gets their
    numbers.
    """
    if not is_command(sys.argv, sys.orig_argv):
        return
    _open_closed_streams()
    sys.excepthook = _report_failed_import
    sys.unraisablehook = _repeat_interrupt
    # A shell starts background jobs with Ctrl-C ignored.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _exit_at_once)


def is_command(argv: list[str], orig_argv: list[str]) -> bool:
    """Return whether this process was started as surefoot or python -m surefoot.

    Args:
        argv: sys.argv; begins with "-m" while Python imports the package of python -m.
        orig_argv: sys.orig_argv.
    """
    # Worker processes get the arguments of their parent.
    if not argv or "--multiprocessing-fork" in orig_argv:
        return False
    if argv[0] == "-m" and len(orig_argv) >= len(argv):
        module = orig_argv[-len(argv)].removeprefix("-m")
        return module.partition(".")[0] == "surefoot"
    return os.path.basename(argv[0]) in ("surefoot", "surefoot.exe", "surefoot-script.py")


class Interruptible:
    """Context manager: lets Ctrl-C raise KeyboardInterrupt in a prepared process."""

    def __enter__(self) -> None:
        if signal.getsignal(signal.SIGINT) is _exit_at_once:
            signal.signal(signal.SIGINT, _raise_interrupt)

    def __exit__(self, *_: object) -> None:
        if signal.getsignal(signal.SIGINT) is _raise_interrupt:
            signal.signal(signal.SIGINT, _exit_at_once)


def was_interrupted() -> bool:
    """Return whether Ctrl-C was pressed in a prepared process.

    An exception may then be a consequence: an import that is interrupted in C code raises
    ImportError.
    """
    return _interrupted


def discard_stream(stream: Any) -> None:
    """Connect the descriptor of a stream to the null device, because it cannot be written."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
    except (OSError, ValueError):  # the stream has no descriptor, as in tests
        pass


class _ErrorDescriptor(io.FileIO):
    """Descriptor 2, which discards text after its reader has closed: no progress line is needed."""

    def write(self, data: Any) -> int:
        try:
            return super().write(data)
        except OSError:
            discard_stream(self)
            return len(data)


def _open_closed_streams() -> None:
    for descriptor in (0, 1, 2):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # gets the lowest free number, which is `descriptor`
    # Not every locale can show every file name.
    if sys.stdout is None:
        sys.stdout = open(1, "w", closefd=False)
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")
    encoding = getattr(sys.stderr, "encoding", "utf-8")
    sys.stderr = io.TextIOWrapper(
        _ErrorDescriptor(2, "w", closefd=False),
        encoding=encoding,
        errors="backslashreplace",
        line_buffering=True,
        write_through=True,
    )


def _exit_at_once(signal_number: int, frame: FrameType | None) -> None:
    try:
        os.write(2, b"surefoot: error: interrupted\n")
    finally:
        os._exit(INTERRUPTED)


def _raise_interrupt(signal_number: int, frame: FrameType | None) -> None:
    global _interrupted
    if _is_importing(frame):  # commands import MuJoCo and others where they need them
        _exit_at_once(signal_number, frame)
    _interrupted = True
    raise KeyboardInterrupt


def _is_importing(frame: FrameType | None) -> bool:
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


def _repeat_interrupt(unraisable: Any) -> None:
    """Repeat an interrupt that a destructor or a callback has discarded; print other exceptions."""
    if not issubclass(unraisable.exc_type, KeyboardInterrupt):
        sys.__unraisablehook__(unraisable)
        return
    import threading  # here, because imports before prepare_process() delay it

    timer = threading.Timer(_REPEAT_TIME, os.kill, (os.getpid(), signal.SIGINT))
    timer.daemon = True
    timer.start()


def _report_failed_import(
    kind: type[BaseException], problem: BaseException, trace: TracebackType | None
) -> None:
    if issubclass(kind, ImportError):
        print("surefoot: error:", " ".join(str(problem).split()), file=sys.stderr)
    else:
        sys.__excepthook__(kind, problem, trace)
