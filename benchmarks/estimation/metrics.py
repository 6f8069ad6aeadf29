"""Results of the benchmark, and the metrics of its figures."""

from __future__ import annotations

from dataclasses import dataclass, field

from estimation.log_rows import Array
from estimation.metric import Metric
from estimation.walking_metrics import WALKING_METRICS

Values = dict[str, float]


@dataclass
class Result:
    """Result of one seed of one case.

    Attributes:
        values: Values by name of the figure; NaN if the estimator gives no value.
        series: Arrays (n,) by name, which are evaluated together with those of other seeds.
    """

    values: Values
    series: dict[str, Array] = field(default_factory=dict)


def find_metric(case: str, name: str) -> Metric:
    """Return the metric of a figure; a figure that is not in METRICS has no limit."""
    return METRICS.get(f"{case}/{name}") or METRICS.get(name.split(":")[0], Metric(""))


METRICS: dict[str, Metric] = {
    **WALKING_METRICS,
    "fell": Metric("runs", upper_limit=0, merged="sum"),
    "quiet/height drift": Metric("mm", upper_limit=5),
    "quiet_long/height drift": Metric("mm", upper_limit=5),
    "false": Metric("transitions", upper_limit=0, merged="sum"),
    "velocity RMSE": Metric("m/s", upper_limit=0.02),
    "velocity RMSE per axis": Metric("m/s"),
    "tilt RMSE": Metric("deg"),
    "tilt RMSE beyond bias": Metric("deg", upper_limit=0.3),
    "force RMSE": Metric("% of weight", upper_limit=8),
    "NIS in band": Metric("% of ticks", lower_limit=90),
    "NEES in band": Metric("% of ticks", lower_limit=90),
    "NIS mean": Metric("per dof"),
    "NEES mean": Metric("per dof"),
    "transitions": Metric("", merged="sum"),
    "missed": Metric("transitions", upper_limit=0, merged="sum"),
    "delay max": Metric("ms", upper_limit=20),
    "delay p95": Metric("ms", upper_limit=20),
    "calibration error": Metric("", upper_limit=0.1),
    "tilted quaternion": Metric("s", upper_limit=1),
    "moving start": Metric("s", upper_limit=1),
    "speed at start": Metric("m/s"),
    "frozen IMU, velocity error": Metric("m/s", upper_limit=0.1),
    "doubled accelerometer, velocity RMSE": Metric("m/s", upper_limit=0.02),
    "lost rows, velocity error": Metric("m/s", upper_limit=0.1),
    "velocity RMSE at the end": Metric("m/s", upper_limit=0.02),
    "gyro bias error": Metric("rad/s", upper_limit=0.002),
    "vertical bias error": Metric("m/s^2", upper_limit=0.03),
    "horizontal bias sigma, still": Metric("m/s^2", lower_limit=0.08),
    "horizontal bias error, moved": Metric("m/s^2", upper_limit=0.05),
    "reached": Metric("deg", lower_limit=None),
    "inclination RMS, VQF": Metric("deg", merged="rms"),
    "inclination RMS, torques": Metric("deg", merged="rms"),
    "inclination RMS, no torques": Metric("deg", merged="rms"),
    "inclination RMS / that of VQF, torques": Metric("", upper_limit=1.0, merged="rms"),
    "inclination RMS / that of VQF, no torques": Metric("", upper_limit=1.0, merged="rms"),
    "height error": Metric("mm", upper_limit=5),
    "tilt error": Metric("deg", upper_limit=0.5),
    "mass error": Metric("%", upper_limit=10),
    "11 kg, height error": Metric("mm", upper_limit=20),
    "greatest payload": Metric("kg"),
}
