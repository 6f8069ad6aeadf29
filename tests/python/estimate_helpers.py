# SPDX-License-Identifier: BSD-3-Clause
"""A short sensor log of a moving go1, and functions that modify and write logs."""

from __future__ import annotations

import csv
import functools
import itertools
from dataclasses import replace

import numpy as np
import surefoot
from surefoot.estimate import SensorLog
from surefoot.sensor_log.clock import read_clock
from surefoot.stand import SensorRecorder, StandSettings, parse_reference, run_stand

DEG_PER_RAD = 180.0 / np.pi


@functools.cache
def robot() -> surefoot.Robot:
    return surefoot.load_robot("go1")


@functools.cache
def moving_log() -> SensorLog:
    """Return the log of a go1 that turns and leans on its feet for 1.6 s."""
    requests = (parse_reference("yaw=8,roll=6,pitch=-4@0.3"), parse_reference("yaw=-6,roll=0@0.9"))
    recorder = SensorRecorder()
    run_stand(StandSettings(duration=1.6, references=requests), sensors=recorder)
    return recorder.log("stand")


def with_columns(log: SensorLog | None = None, **columns) -> SensorLog:
    """Return the log with some columns replaced; None removes a column."""
    log = log or moving_log()
    rows = {**log.columns, **columns}
    rows = {name: values for name, values in rows.items() if values is not None}
    clock, time = read_clock("with_columns", rows)
    return replace(log, columns=rows, time=time, clock=clock)


def reorder_legs(order, values):
    """Return columns (n, 12) with the legs in another order."""
    return values.reshape(-1, 4, 3)[:, order].reshape(-1, 12)


def write_rows(path, header, rows):
    with path.open("w", newline="") as file:
        csv.writer(file).writerows([header, *rows])
    return path


def small_table(rows: int = 5):
    """Return the smallest valid log: a list of rows for each column name."""
    table = {"time": [[0.002 * k] for k in range(rows)]}
    table["gyroscope"] = [[0.0, 0.0, 0.0]] * rows
    table["accelerometer"] = [[0.0, 0.0, 9.81]] * rows
    table["q"] = [[0.0, 0.8, -1.6] * 4] * rows
    return table


def small_csv(path, table=None):
    """Write a table, by default small_table(), as a CSV file with header names name_k."""
    table = table or small_table()
    header, parts = [], []
    for name, values in table.items():
        width = len(values[0])
        header += [name] if width == 1 else [f"{name}_{k}" for k in range(width)]
        parts.append(values)
    return write_rows(
        path, header, [list(itertools.chain(*row)) for row in zip(*parts, strict=True)]
    )
