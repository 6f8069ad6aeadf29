# SPDX-License-Identifier: BSD-3-Clause
"""NPZ files with a corrupt array header and a valid checksum."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from surefoot import Error
from surefoot.bench.problems.qp_sequence import load_sequence
from surefoot.estimate import read_log
from surefoot.replay import read_recording

CORRUPTIONS = {
    "a brace": (b"}", b"\xbd"),  # tokenize.TokenError
    "a comma": (b", '", b",B'"),  # TypeError
    "a quote": (b"descr'", b"descr "),
    "a type": (b"<f8", b",f8"),  # SyntaxError
    "a digit": (b"(5,)", b"(9**9**3,)"),
    "too much": (b"(5,), ", b"(9" + 16 * b"0" + b",), "),  # MemoryError
}


def corrupted_npz(name: str, old: bytes, new: bytes) -> bytes:
    """Return an NPZ file of one array whose header is corrupt and of unchanged length."""
    plain = io.BytesIO()
    np.save(plain, np.zeros(5))
    whole = plain.getvalue()
    header, numbers = whole[:128], whole[128:]
    assert old in header
    header = header.replace(old, new, 1).rstrip().ljust(127) + b"\n"
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as file:
        file.writestr(f"{name}.npy", header + numbers)
    return packed.getvalue()


@pytest.mark.parametrize("part", CORRUPTIONS)
@pytest.mark.parametrize(
    ("read", "names"),
    [
        (read_recording, ("replay_reports", "replay_commands", "replay_head")),
        (read_log, ("tick",)),
        (load_sequence, ("meta",)),
    ],
)
def test_corrupt_npz_header_raises_an_error(
    read: Callable[[Path], object], names: tuple[str, ...], part: str, tmp_path: Path
) -> None:
    path = tmp_path / "hurt.npz"
    path.write_bytes(corrupted_npz(names[0], *CORRUPTIONS[part]))
    with zipfile.ZipFile(path, "a") as file:
        for name in names[1:]:
            file.writestr(f"{name}.npy", b"")
    with pytest.raises(Error, match=r"hurt\.npz: got .*expected"):
        read(path)
