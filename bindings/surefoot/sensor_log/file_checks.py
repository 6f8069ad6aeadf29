"""Checks of a log file before it is opened: kind, size and permission."""

from __future__ import annotations

import errno
import os
import stat
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from surefoot._core import Error
from surefoot.files.corrupt_npz import CORRUPT_NPZ

# [bytes] Largest text file. Chosen: 20 minutes of all columns at 500 Hz are 400 MB. Measured: 93 MB
# take 4 s and 0.6 GB of memory.
MAX_TEXT_BYTES = 500_000_000
# [bytes] Largest sum of the arrays of an NPZ file after decompression. Chosen: an hour of all
# columns at 500 Hz is 1.3 GB as float64.
MAX_ARRAY_BYTES = 2_000_000_000
_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a FIFO",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}


def printable_path(path: str | Path) -> str:
    r"""Return a path as text that every terminal and file can hold.

    Bytes that are not UTF-8 become escapes such as ``\xff``.
    """
    return os.fsencode(path).decode("utf-8", "backslashreplace")


def check_log_file(path: Path) -> int:
    """Return the size of a log file [bytes].

    Opening a FIFO would wait for a writer, so the check comes before.

    Raises:
        Error: The path does not exist, is no regular file, is empty, or may not be read.
    """
    name = printable_path(path)
    try:
        status = path.stat()
    except (OSError, ValueError) as problem:  # ValueError: a NUL in the path
        reason = getattr(problem, "strerror", None) or problem
        raise Error(
            f"log: cannot read '{name}': {reason}; expected the path of an existing log"
        ) from None
    kind = _KINDS.get(stat.S_IFMT(status.st_mode))
    if kind is not None:
        raise Error(f"log: cannot read '{name}': got {kind}, expected a regular file")
    if not os.access(path, os.R_OK):
        raise Error(
            f"log: cannot read '{name}': no read permission, expected a readable file; "
            "run chmod +r on it"
        )
    if status.st_size == 0:
        raise Error(f"{name}: got an empty file, expected column names and rows")
    return status.st_size


@contextmanager
def refusing_corrupt_npz(path: Path) -> Iterator[None]:
    """Raise Error instead of the exceptions of an NPZ file that is corrupt or cannot be read."""
    name = printable_path(path)
    try:
        yield
    except OSError as problem:
        if problem.errno != errno.EINVAL:
            raise Error(f"log: cannot read '{name}': {problem.strerror or problem}") from None
        # zipfile seeks to a negative place
        raise Error(f"{name}: got no valid NPZ file, expected an NPZ log") from None
    except CORRUPT_NPZ as problem:
        raise Error(f"{name}: got no valid NPZ file ({problem}), expected an NPZ log") from None


def check_npz_file(path: Path) -> None:
    """Check an NPZ file before its arrays are decompressed.

    Raises:
        Error: As check_log_file(); or the file is no ZIP archive, or its arrays are too large.
    """
    check_log_file(path)
    name = printable_path(path)
    with refusing_corrupt_npz(path), zipfile.ZipFile(path) as archive:
        size = sum(member.file_size for member in archive.infolist())
    if size > MAX_ARRAY_BYTES:
        raise Error(
            f"{name}: got arrays of {size / 1e6:.0f} MB, expected up to "
            f"{MAX_ARRAY_BYTES / 1e6:.0f} MB; split the log"
        )
