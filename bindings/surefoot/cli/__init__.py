"""Entry point of the command surefoot."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from surefoot._core import Error
from surefoot.cli.arguments import parse_arguments

# Exit statuses.
DONE = 0
WRONG_ARGUMENT = 2
INTERRUPTED = 130


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command.

    Args:
        argv: Arguments without the program name. None: the arguments of this process.

    Returns:
        Exit status: 0 done, 1 a file could not be written, 2 a wrong argument, 3 the robot fell,
        130 interrupted. An error is reported in one line on stderr.
    """
    argv = list(sys.argv[1:] if argv is None else argv)
    try:
        arguments = parse_arguments(argv)
        arguments.argv = argv
        status = arguments.run(arguments) or DONE
        sys.stdout.flush()
    except SystemExit as end:  # raised by argparse after --help, --version or its own error line
        return int(end.code or 0)
    except Error as problem:
        return _print_error(str(problem), WRONG_ARGUMENT)
    except BrokenPipeError:  # the reader of stdout has closed, as in surefoot gains | head
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except OSError as problem:
        return _print_error(str(problem), 1)
    except KeyboardInterrupt:
        return _print_error("interrupted", INTERRUPTED)
    return int(status)


def _print_error(text: str, status: int) -> int:
    print("surefoot: error:", " ".join(text.split()), file=sys.stderr)
    return status
