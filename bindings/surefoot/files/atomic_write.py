"""Files that are whole or not there at all."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def atomic_path(path: Path) -> Iterator[Path]:
    """Yield a place beside a file's, and move there what was written; raises OSError.

    A link stays one; what is no file, a pipe or a device, is written to as it is.
    """
    if path.exists() and not path.is_file():  # unresolved: what /dev/stdout leads to has no name
        yield path
        return
    path = path.resolve()
    beside = path.with_name(path.name + ".part")
    try:
        yield beside
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)


def write_text_atomically(path: Path, text: str) -> None:
    """Write a text file beside its place first, then move it there; raises OSError."""
    with atomic_path(path) as beside:
        beside.write_text(text, encoding="utf-8")
