"""Entry point of the command surefoot."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from surefoot._core import Error
from surefoot.cli.arguments import parse_arguments
from surefoot.cli.graphics import kept_environment
from surefoot.system.command_process import (
    INTERRUPTED,
    Interruptible,
    discard_stream,
    was_interrupted,
)

# Exit statuses.
DONE = 0
FILE_ERROR = 1
WRONG_ARGUMENT = 2


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command.

    Args:
        argv: Arguments without the program name. None: the arguments of this process.

    Returns:
        Exit status: 0 done, 1 a file could not be written, 2 a wrong argument, 3 the robot fell,
        130 interrupted. An error is reported in one line on stderr.
    """
    argv = list(sys.argv[1:] if argv is None else argv)
    with Interruptible():
        try:
            status = _run(argv)
            sys.stdout.flush()
        except BaseException as problem:
            status = _report(problem)
    return status


def _run(argv: Sequence[str]) -> int:
    arguments = parse_arguments(argv)
    # Reports show the words. A file name that is not UTF-8 would end the writing of a report.
    arguments.argv = [word.encode("utf-8", "backslashreplace").decode() for word in argv]
    with kept_environment():
        return int(arguments.run(arguments) or DONE)


def _report(problem: BaseException) -> int:
    """Print an exception in one line; return the exit status. Raise a programming error again."""
    if isinstance(problem, SystemExit):  # raised by argparse after --help or its own error line
        return int(problem.code or 0)
    if isinstance(problem, KeyboardInterrupt) or was_interrupted():
        return _print_error("interrupted", INTERRUPTED)
    if isinstance(problem, Error):
        return _print_error(str(problem), WRONG_ARGUMENT)
    if isinstance(problem, BrokenPipeError):  # the reader of stdout has closed, as in gains | head
        _discard_unwritable_text()
        return FILE_ERROR
    if isinstance(problem, OSError):
        _discard_unwritable_text()
        return _print_error(str(problem), FILE_ERROR)
    if isinstance(problem, UnicodeError):
        text = f"a file name cannot be encoded ({problem}), expected a UTF-8 locale"
        return _print_error(f"{text}; run: export LC_ALL=C.UTF-8", WRONG_ARGUMENT)
    raise problem


def _discard_unwritable_text() -> None:
    """Discard the buffer of stdout if it cannot be written: Python would try again at its end."""
    try:
        sys.stdout.flush()
    except OSError:
        discard_stream(sys.stdout)


def _print_error(text: str, status: int) -> int:
    print("surefoot: error:", " ".join(text.split()), file=sys.stderr)
    return status
