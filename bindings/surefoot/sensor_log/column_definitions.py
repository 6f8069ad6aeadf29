"""Columns of a log: names, widths, units and aliases."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.messages.low_state_layout import LEGS

JOINTS = ("hip", "thigh", "calf")
MOTOR_NAMES = tuple(f"{leg}_{joint}" for leg in LEGS for joint in JOINTS)


@dataclass(frozen=True)
class Column:
    """One column of a log.

    Attributes:
        name: Name of the LowState field.
        labels: Names of the components in order; their number is the column's width.
        unit: SI unit; "" for counts and ratios.
        meaning: Meaning of the column in one line.
        aliases: Other accepted names, in lower case.
        required: True if every log must have the column.
    """

    name: str
    labels: tuple[str, ...]
    unit: str
    meaning: str
    aliases: tuple[str, ...] = ()
    required: bool = False

    @property
    def width(self) -> int:
        """Number of components per row."""
        return len(self.labels)

    @property
    def is_truth(self) -> bool:
        """True if the column is ground truth, which never reaches the estimator."""
        return self.name.startswith("truth_")

    def component(self, index: int) -> str:
        """Return the name that one component has in the header of a CSV."""
        return self.name if self.width == 1 else f"{self.name}_{index}"


_XYZ, _WXYZ, _ONE = ("x", "y", "z"), ("w", "x", "y", "z"), ("",)
_FEET_XYZ = tuple(f"{leg}_{axis}" for leg in LEGS for axis in _XYZ)

COLUMNS: tuple[Column, ...] = (
    Column("tick", _ONE, "ms", "clock of the robot, wraps at 2^32; or give time"),
    Column("time", _ONE, "s", "clock with any origin; or give tick", ("timestamp",)),
    Column("gyroscope", _XYZ, "rad/s", "imu.gyroscope, IMU axes", ("gyro",), required=True),
    Column(
        "accelerometer",
        _XYZ,
        "m/s^2",
        "imu.accelerometer, IMU axes",
        ("acc", "accel"),
        required=True,
    ),
    Column("quaternion", _WXYZ, "", "imu.quaternion, w x y z, IMU to world", ("quat",)),
    Column("q", MOTOR_NAMES, "rad", "joint angles", required=True),
    Column("dq", MOTOR_NAMES, "rad/s", "joint velocities"),
    Column("tauEst", MOTOR_NAMES, "N.m", "joint torques", ("tau", "tau_est")),
    Column("footForce", LEGS, "counts", "raw foot force", ("foot_force",)),
    Column("footForceEst", LEGS, "N", "foot force", ("foot_force_est",)),
    Column("mode", MOTOR_NAMES, "", "mode of the motors; accepted but not used"),
    Column("truth_p", _XYZ, "m", "position of the base, world"),
    Column("truth_quaternion", _WXYZ, "", "w x y z, base to world"),
    Column("truth_v", _XYZ, "m/s", "velocity of the base, world axes"),
    Column("truth_foot_forces", _FEET_XYZ, "N", "force of the ground on each foot, world axes"),
    Column("truth_contact", LEGS, "", "whether a foot is loaded, 0 or 1"),
    Column("truth_com", _XYZ, "m", "centre of mass, world"),
)
COLUMN_BY_NAME = {column.name: column for column in COLUMNS}
REPLAY_PREFIX = "replay_"  # prefix of the arrays for surefoot replay in the same file
RUN_PREFIX = "run_"  # prefix of the arrays that surefoot run adds to the file
CLOCK_COLUMNS = ("tick", "time")
SENSOR_COLUMNS = ("gyroscope", "accelerometer", "quaternion", "q", "dq", "tauEst")
FOOT_COLUMNS = ("footForce", "footForceEst")
REQUIRED_COLUMNS = tuple(column.name for column in COLUMNS if column.required)


def valid_names() -> str:
    """Return the valid column names for error texts, as "name (width), ..."."""
    return ", ".join(f"{column.name} ({column.width})" for column in COLUMNS)
