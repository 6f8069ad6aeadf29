"""Record of the estimator's output after each row of a log."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import EstimatorReport, Robot, SensorVerdict, StateEstimator, Status
from surefoot.estimate.estimate_result import FOOT_SENSORS, SENSOR_NAMES

_DIAGONAL = 16 * np.arange(15)
_ROTATION = (15 * np.arange(3)[:, None] + np.arange(3)).ravel()
_COVARIANCE_ENTRIES = np.concatenate([_DIAGONAL, _ROTATION])  # indices into the flat covariance
_UNJUDGED = SensorVerdict.UNJUDGED.value


class EstimateRecorder:
    """Arrays of the estimator's output, filled row by row.

    Args:
        robot: Robot of the estimator.
        rows: Number of rows.
    """

    def __init__(self, robot: Robot, rows: int) -> None:
        self.status = np.full(rows, Status.NON_FINITE.value, dtype=np.int64)
        self.update_us = np.zeros(rows)
        self.verdicts = np.full((rows, len(SENSOR_NAMES)), _UNJUDGED, dtype=np.int64)
        shapes: dict[str, tuple[int, ...]] = {
            **{"q": (robot.nq,), "v": (robot.nv,), "contact": (4,), "covariance": (24,)},
            **{"gyroscope_bias": (3,), "accelerometer_bias": (3,), "slip": (4,), "friction": ()},
            **{"contact_by_source": (4, 4), "foot_forces_from_torques": (4,), "refused": (4,)},
            **{"nis": (), "nis_dimension": (), "payload": (), "com_shift": (3,)},
        }
        self._rows = {name: np.full((rows, *shape), np.nan) for name, shape in shapes.items()}
        self._last_verdicts: list[Any] = []
        self._verdict_codes = self.verdicts[:1].copy()

    def record(self, k: int, status: Status, estimator: StateEstimator, elapsed_us: float) -> None:
        """Record row k; of a rejected row, record only status, update time and verdicts."""
        report = estimator.report
        self.update_us[k] = elapsed_us
        self.status[k] = status.value
        self._record_verdicts(k, report)
        if status != Status.OK:
            return
        rows, state = self._rows, estimator.state
        rows["q"][k], rows["v"][k], rows["contact"][k] = state.q, state.v, state.contact
        rows["covariance"][k] = report.covariance.ravel()[_COVARIANCE_ENTRIES]
        rows["gyroscope_bias"][k] = report.gyroscope_bias
        rows["accelerometer_bias"][k] = report.accelerometer_bias
        rows["nis"][k], rows["nis_dimension"][k] = report.nis, report.nis_dimension
        rows["slip"][k], rows["refused"][k] = report.slip, report.rejected_feet
        rows["friction"][k] = report.friction
        rows["contact_by_source"][k] = report.contact_by_source
        rows["foot_forces_from_torques"][k] = report.foot_forces_from_torques[2]
        rows["payload"][k], rows["com_shift"][k] = report.payload, report.com_shift

    def _record_verdicts(self, k: int, report: EstimatorReport) -> None:
        sources = report.contact_sources
        verdict_sources: list[Any] = [
            report.gyroscope,
            report.accelerometer,
            report.quaternion,
            sources,
        ]
        if (
            verdict_sources != self._last_verdicts
        ):  # convert verdicts only when they change, because the conversion is slow
            self._last_verdicts = verdict_sources
            verdicts = [
                *verdict_sources[:3],
                *(v for row in sources[: len(FOOT_SENSORS)] for v in row),
            ]
            self._verdict_codes = np.array([verdict.value for verdict in verdicts])
        self.verdicts[k] = self._verdict_codes

    def arrays(self) -> dict[str, Any]:
        """Return the arrays by name; a rejected row repeats the last accepted row."""
        count = np.arange(len(self.status))
        last = np.maximum.accumulate(np.where(self.status == Status.OK.value, count, -1))
        # Rows before the first accepted row repeat row 0, which is NaN in this case.
        rows = {name: values[np.maximum(last, 0)] for name, values in self._rows.items()}
        covariance = rows.pop("covariance")
        rows["std"] = np.sqrt(np.maximum(covariance[:, :15], 0.0))
        rows["rotation_covariance"] = covariance[:, 15:].reshape(-1, 3, 3)
        return rows
