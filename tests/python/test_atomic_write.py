# SPDX-License-Identifier: BSD-3-Clause
"""Atomic writes: a file is replaced as a whole or not at all."""

from __future__ import annotations

import os
import threading
from pathlib import Path

import pytest
from surefoot.files.atomic_write import atomic_path, write_text_atomically


def test_interrupted_write_keeps_the_old_file(tmp_path: Path) -> None:
    file = tmp_path / "a.txt"
    write_text_atomically(file, "old")
    with pytest.raises(KeyboardInterrupt), atomic_path(file) as place:
        place.write_text("ne")
        raise KeyboardInterrupt
    assert file.read_text() == "old" and list(tmp_path.iterdir()) == [file]


def test_write_keeps_symlinks_and_writes_to_pipes(tmp_path: Path) -> None:
    file, link, pipe = tmp_path / "a.txt", tmp_path / "link", tmp_path / "pipe"
    link.symlink_to(file)
    write_text_atomically(link, "new")
    assert link.is_symlink() and file.read_text() == "new"
    os.mkfifo(pipe)
    read: list[str] = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_text()))
    reader.start()
    write_text_atomically(pipe, "through")
    reader.join(timeout=10)
    assert read == ["through"] and pipe.is_fifo()


def test_write_to_an_open_file_descriptor_path() -> None:
    reading, writing = os.pipe()
    write_text_atomically(Path(f"/dev/fd/{writing}"), "through")
    os.close(writing)
    with open(reading) as end:
        assert end.read() == "through"
