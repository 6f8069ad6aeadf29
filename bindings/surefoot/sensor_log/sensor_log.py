"""Log of a robot's sensors, with ground truth where it is known."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.column_definitions import COLUMN_BY_NAME


@dataclass(frozen=True)
class SensorLog:
    """Columns of a log, in the units and orders of column_definitions.COLUMNS.

    Attributes:
        source: Name of the file or process that the log comes from, for messages.
        columns: Arrays (n, width) by name. Columns named ``truth_...`` never reach the estimator.
        time: (n,) time since the first row [s]; NaN where the clock is not finite.
        clock: Name of the column from which `time` is computed.
        ignored: Unknown names in the file.
        warnings: Findings that make the log doubtful.
        notes: What the reader of the file converted or left out, one sentence each.
    """

    source: str
    columns: dict[str, Array]
    time: Array
    clock: str = "tick"
    ignored: tuple[str, ...] = ()
    warnings: tuple[str, ...] = field(default=())
    notes: tuple[str, ...] = field(default=())

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(self.time)

    @property
    def period(self) -> float:
        """Median positive step of the clock [s]; 0.002 if there is none."""
        steps = np.diff(self.time[np.isfinite(self.time)])
        return float(np.median(steps[steps > 0.0])) if np.any(steps > 0.0) else 0.002

    def sensor(self, name: str) -> Array:
        """Return a column (n, width); zeros if the log does not have it."""
        if name in self.columns:
            return self.columns[name]
        return np.zeros((self.rows, COLUMN_BY_NAME[name].width))
