"""Summary of an estimate in numbers; summary_fields.py lists their meanings."""

from __future__ import annotations

import importlib.metadata
from collections import Counter
from typing import Any

import numpy as np

from surefoot._core import SensorVerdict, Status
from surefoot.estimate.baseline_summary import baseline_summary
from surefoot.estimate.contact_events import row_durations, slip_events, transitions
from surefoot.estimate.estimate_result import SENSOR_NAMES, Estimate
from surefoot.estimate.joint_velocities import METHOD
from surefoot.estimate.strides import stride_summary
from surefoot.estimate.truth_summary import truth_summary
from surefoot.files.json_values import json_value
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.column_definitions import CLOCK_COLUMNS, COLUMN_BY_NAME

# [s] Time between two points of the polyline whose length is computed. Chosen: with less time,
# noise of the estimate adds length, and with more time, the polyline cuts corners.
PATH_INTERVAL = 0.1


def summarise(estimate: Estimate) -> dict[str, Any]:
    """Return every field of summary_fields.FIELDS as a JSON value; None if a field has no value."""
    parts = (
        _log(estimate),
        _end_state(estimate),
        _sensors(estimate),
        _contact(estimate),
        truth_summary(estimate),
        {"baselines": baseline_summary(estimate)},
    )
    return {name: json_value(value) for part in parts for name, value in part.items()}


def _log(estimate: Estimate) -> dict[str, Any]:
    log = estimate.log
    names = [*log.columns]
    other_clock = set(CLOCK_COLUMNS) - {log.clock}
    counts = Counter(Status(int(value)).name for value in estimate.status)
    counts["NON_FINITE"] += estimate.rows_without_time
    return {
        "version": importlib.metadata.version("surefoot"),
        "robot": estimate.robot.name,
        "file": log.source,
        "rows": log.rows,
        "duration": float(estimate.time[-1] - estimate.time[0]),
        "rate": 1.0 / log.period,
        "clock": log.clock,
        "columns_used": [
            n for n in names if not COLUMN_BY_NAME[n].is_truth and n not in other_clock
        ],
        "columns_derived": {"dq": METHOD} if "dq" in estimate.derived else {},
        "columns_missing": [name for name in estimate.derived if name != "dq"],
        "truth_columns": [name for name in names if COLUMN_BY_NAME[name].is_truth],
        "ignored_columns": [*log.ignored, *(name for name in names if name in other_clock)],
        "warnings": list(estimate.warnings),
        "notes": list(log.notes),
        "non_finite_rows": estimate.non_finite,
        "duplicate_rows": estimate.duplicates,
        "gaps": estimate.gaps,
        "longest_gap_s": estimate.longest_gap,
        "statuses": {name: count for name, count in counts.items() if count},
        "update_us": _percentiles(estimate.update_us[estimate.update_us > 0.0]),
    }


def _percentiles(values: Array) -> dict[str, float] | None:
    if len(values) == 0:
        return None
    p50, p90, p99 = np.percentile(values, [50, 90, 99])
    return {"p50": p50, "p90": p90, "p99": p99, "max": values.max()}


def _end_state(estimate: Estimate) -> dict[str, Any]:
    valid = estimate.valid
    height = estimate.q[valid, 2]
    return {
        "position": estimate.q[-1, :3],
        "position_std": estimate.std[-1, 6:9],
        "velocity": estimate.v_world[-1],
        "velocity_std": estimate.std[-1, 3:6],
        "rpy_deg": np.degrees(estimate.rpy[-1]),
        "rpy_std_deg": np.degrees(estimate.rpy_std[-1]),
        "path_length": path_length(estimate.time[valid], estimate.q[valid, :3]),
        "height_range": [height.min(), height.max()] if len(height) else None,
        "payload_kg": estimate.payload[-1],
        "com_shift": estimate.com_shift[-1],
        "friction": estimate.friction[-1],
    }


def path_length(time: Array, position: Array) -> float:
    """Return the length [m] of a path, computed as a polyline with a point every 0.1 s.

    Args:
        time: (n,) times [s].
        position: (n, 3) positions [m].
    """
    if len(time) < 2:
        return 0.0
    points = np.unique(np.searchsorted(time, np.arange(time[0], time[-1], PATH_INTERVAL)))
    corners = np.vstack([position[points], position[-1:]])
    return float(np.linalg.norm(np.diff(corners, axis=0), axis=1).sum())


def _sensors(estimate: Estimate) -> dict[str, Any]:
    durations = row_durations(estimate)
    verdicts = {}
    for k, name in enumerate(SENSOR_NAMES):
        codes = estimate.verdicts[:, k]
        verdicts[name] = {
            "now": SensorVerdict(int(codes[-1])).name,
            "share": {
                SensorVerdict(int(code)).name: durations[codes == code].sum() / durations.sum()
                for code in np.unique(codes)
            },
        }
    accepted = estimate.status == Status.OK.value
    dimension = estimate.nis_dimension[accepted].sum()
    return {
        "gyroscope_bias": estimate.gyroscope_bias[-1],
        "gyroscope_bias_std": estimate.std[-1, 9:12],
        "accelerometer_bias": estimate.accelerometer_bias[-1],
        "accelerometer_bias_std": estimate.std[-1, 12:15],
        "nis_per_dimension": estimate.nis[accepted].sum() / dimension if dimension > 0 else None,
        "verdicts": verdicts,
    }


def _contact(estimate: Estimate) -> dict[str, Any]:
    found = transitions(estimate.time, estimate.contact)
    valid = estimate.valid
    durations = row_durations(estimate)[valid]
    feet = {}
    for leg, foot in enumerate(LEGS):
        on = estimate.contact[valid, leg] > 0.5
        feet[foot] = {
            "transitions": sum(change.leg == leg for change in found),
            "share": durations[on].sum() / durations.sum() if len(durations) else None,
        }
    return {
        "contact": feet,
        "contact_transitions": [
            {"time": change.time, "foot": LEGS[change.leg], "contact": change.begins}
            for change in found
        ],
        "slip_events": slip_events(estimate),
        "strides": stride_summary(estimate),
    }
