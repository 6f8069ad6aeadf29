"""A log of what a robot's sensors said, and what was true where somebody knew."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.columns import COLUMN_BY_NAME


@dataclass(frozen=True)
class SensorLog:
    """Columns of a log, in the units and orders of columns.COLUMNS.

    Attributes:
        source: Where it is from, for messages.
        columns: (n, width) by name, those that the log has; truth_ ones never reach an estimator.
        time: (n,) since the first row [s]; NaN where the clock says nothing.
        clock: Name of the column that time is from.
        ignored: Names in the file that mean nothing here.
        warnings: What was strange about it.
    """

    source: str
    columns: dict[str, Array]
    time: Array
    clock: str = "tick"
    ignored: tuple[str, ...] = ()
    warnings: tuple[str, ...] = field(default=())

    @property
    def rows(self) -> int:
        """Rows of the file."""
        return len(self.time)

    @property
    def period(self) -> float:
        """Median step of the clock that is no repetition [s]."""
        steps = np.diff(self.time[np.isfinite(self.time)])
        return float(np.median(steps[steps > 0.0])) if np.any(steps > 0.0) else 0.002

    def sensor(self, name: str) -> Array:
        """Return a column (n, width), zeros if the log has none of that name."""
        if name in self.columns:
            return self.columns[name]
        return np.zeros((self.rows, COLUMN_BY_NAME[name].width))
