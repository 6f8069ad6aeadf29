"""Cache of recorded logs, one .npz each; a log is recorded again when its settings change."""

from __future__ import annotations

import hashlib
import os
from pathlib import Path

import numpy as np

from estimation.log_rows import Log
from estimation.recording import Scenario, record

VERSION = 1  # version of the log's layout


def load_or_record(folder: Path, case: str, seed: int, scenario: Scenario) -> Log:
    """Return the log `folder`/case/robot-seed-key.npz; record it if it does not exist yet.

    The key is a hash of the scenario's settings but not of the controller's code. So remove the
    folder to record with another version of the controller.
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
