"""Folder of a report."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any


def write_figures(figures: Any, folder: Path, name: str = "summary.json") -> None:
    """Create the folder of a report if it is missing, and write its figures as JSON.

    Args:
        figures: JSON values without NaN and infinity.
        folder: Folder of the report.
        name: Name of the file.

    Raises:
        OSError: The folder or the file cannot be written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    text = json.dumps(figures, indent=2, allow_nan=False)
    (folder / name).write_text(text + "\n", encoding="utf-8")
