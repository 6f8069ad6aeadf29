"""State estimation over the log of a real or simulated robot, without a controller."""

from __future__ import annotations

from typing import Any

from surefoot.estimate.baselines.from_estimate import with_baselines
from surefoot.estimate.estimate_result import Estimate
from surefoot.estimate.run import run_estimator
from surefoot.estimate.summary import summarise
from surefoot.estimate.summary_fields import FIELDS
from surefoot.estimate.trajectory import trajectory, write_trajectory
from surefoot.reports.summary_field import Field
from surefoot.sensor_log.column_definitions import COLUMNS, Column
from surefoot.sensor_log.read import read_log
from surefoot.sensor_log.sensor_log import SensorLog
from surefoot.sensor_log.write import write_log

__all__ = [
    "COLUMNS",
    "FIELDS",
    "Column",
    "Estimate",
    "Field",
    "SensorLog",
    "read_log",
    "run_estimator",
    "summarise",
    "trajectory",
    "with_baselines",
    "write_log",
    "write_report",
    "write_trajectory",
]


def __getattr__(name: str) -> Any:
    # Import the report on first use, because only the report needs matplotlib.
    if name == "write_report":
        from surefoot.estimate.report import write_report

        return write_report
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
