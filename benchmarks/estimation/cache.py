"""Recorded logs on disk, one .npz each; a log is made anew when what it was made from changes."""

from __future__ import annotations

import hashlib
import os
from pathlib import Path

import numpy as np

from estimation.log_rows import Log
from estimation.recording import Scenario, record

VERSION = 1  # of the log's layout


def load_or_record(folder: Path, case: str, seed: int, scenario: Scenario) -> Log:
    """Return a log from `folder`/case/robot-seed-key.npz, recorded if it is not there yet.

    The key is that of the recording's settings; the controller's code is not in it, so remove the
    folder to record with another controller.
    """
    key = hashlib.sha256(f"{VERSION} {scenario!r}".encode()).hexdigest()[:10]
    path = folder / case / f"{scenario.robot}-{seed}-{key}.npz"
    if not path.is_file():
        path.parent.mkdir(parents=True, exist_ok=True)
        part = path.with_suffix(f".{os.getpid()}.part")
        with part.open("wb") as file:
            np.savez(file, **record(scenario))
        part.replace(path)
    with np.load(path) as arrays:
        return dict(arrays)
