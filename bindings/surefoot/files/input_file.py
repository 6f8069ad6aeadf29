"""Reading of files that a user names: regular files of a sensible size only."""

from __future__ import annotations

import stat
from pathlib import Path

from surefoot._core import Error

_MEGABYTE = 1 << 20


def read_input_file(path: Path, kind: str, max_bytes: int) -> bytes:
    """Return the bytes of a file.

    Args:
        path: The file; symbolic links are followed.
        kind: What the file is, for messages, such as "URDF".
        max_bytes: Largest accepted size. A larger file is refused without being read.

    Raises:
        Error: The file is missing, cannot be read, is a folder, a pipe or a device, or is larger.
    """
    try:
        status = path.stat()
        if stat.S_ISDIR(status.st_mode):
            raise Error(f"{kind} '{path}': got a folder, expected a file")
        # Reading a pipe or a device could block or never end.
        if not stat.S_ISREG(status.st_mode):
            raise Error(f"{kind} '{path}': got a pipe or a device, expected a file")
        if status.st_size > max_bytes:
            raise Error(
                f"{kind} '{path}': got {status.st_size / _MEGABYTE:.0f} MB, expected at most "
                f"{max_bytes // _MEGABYTE} MB; is it another file?"
            )
        return path.read_bytes()
    except OSError as problem:
        raise Error(f"{kind}: cannot read '{path}': {problem.strerror}") from None
    except ValueError as problem:  # a null character in the path
        raise Error(f"{kind}: got path {str(path)!r}: {problem}; expected a file") from None
