"""Logs of real or simulated robots, and the state estimator over them without a controller."""

from surefoot.estimate.columns import COLUMNS, Column
from surefoot.estimate.read import read_log
from surefoot.estimate.result import Estimate
from surefoot.estimate.run import run_estimator
from surefoot.estimate.sensor_log import SensorLog
from surefoot.estimate.write import write_log

__all__ = ["COLUMNS", "Column", "Estimate", "SensorLog", "read_log", "run_estimator", "write_log"]
