"""Atomic writes: a file is replaced only after its new content is complete."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def atomic_path(path: Path) -> Iterator[Path]:
    """Yield a temporary path beside `path`; on success, move the temporary file to `path`.

    If `path` is a symbolic link, its target is replaced and the link stays. If `path` is a pipe or
    a device, `path` itself is yielded.

    Raises:
        OSError: The file cannot be moved.
    """
    # Check this before path.resolve(), because the target of /dev/stdout may have no name.
    if path.exists() and not path.is_file():
        yield path
        return
    path = path.resolve()
    temporary_path = path.with_name(path.name + ".part")
    try:
        yield temporary_path
        os.replace(temporary_path, path)
    finally:
        temporary_path.unlink(missing_ok=True)


def write_text_atomically(path: Path, text: str) -> None:
    """Write a text file atomically, in UTF-8; raise OSError if the file cannot be written."""
    with atomic_path(path) as temporary_path:
        temporary_path.write_text(text, encoding="utf-8")
