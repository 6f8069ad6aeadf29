"""Atomic writes: a file is replaced only after its new content is complete."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def atomic_path(path: Path) -> Iterator[Path]:
    """Yield a temporary path beside `path`, and move it to `path` on success; raises OSError.

    A symbolic link stays a link: its target is replaced. A pipe or a device is written directly.
    """
    # Test before path.resolve(): the target of /dev/stdout may have no name.
    if path.exists() and not path.is_file():
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
    """Write a text file atomically, in UTF-8; raises OSError."""
    with atomic_path(path) as beside:
        beside.write_text(text, encoding="utf-8")
