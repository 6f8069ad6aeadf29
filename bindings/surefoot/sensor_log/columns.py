"""The columns of a log: names, widths, units, and what else they may be called."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.messages.low_state_layout import LEGS

JOINTS = ("hip", "thigh", "calf")
MOTOR_NAMES = tuple(f"{leg}_{joint}" for leg in LEGS for joint in JOINTS)


@dataclass(frozen=True)
class Column:
    """One column of a log.

    Attributes:
        name: As LowState calls it.
        labels: Names of its components in order; their number is its width.
        unit: SI; "" for counts and ratios.
        meaning: One line.
        aliases: What else it may be called, lower case.
        required: Whether no estimate can be made without it.
    """

    name: str
    labels: tuple[str, ...]
    unit: str
    meaning: str
    aliases: tuple[str, ...] = ()
    required: bool = False

    @property
    def width(self) -> int:
        """Numbers in a row."""
        return len(self.labels)

    @property
    def is_truth(self) -> bool:
        """Whether it is for judging only and never reaches the estimator."""
        return self.name.startswith("truth_")

    def component(self, index: int) -> str:
        """Return the name of one component as a CSV's header has it."""
        return self.name if self.width == 1 else f"{self.name}_{index}"


_XYZ, _WXYZ, _ONE = ("x", "y", "z"), ("w", "x", "y", "z"), ("",)
_FEET_XYZ = tuple(f"{leg}_{axis}" for leg in LEGS for axis in _XYZ)

COLUMNS: tuple[Column, ...] = (
    Column("tick", _ONE, "ms", "clock of the robot, wraps at 2^32; or time"),
    Column("time", _ONE, "s", "clock, from any start; or tick", ("timestamp",)),
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
    Column("footForce", LEGS, "counts", "raw foot forces", ("foot_force",)),
    Column("footForceEst", LEGS, "N", "foot forces", ("foot_force_est",)),
    Column("mode", MOTOR_NAMES, "", "of the motors; taken for known and not used"),
    Column("truth_p", _XYZ, "m", "base, world"),
    Column("truth_quaternion", _WXYZ, "", "base to world, w x y z"),
    Column("truth_v", _XYZ, "m/s", "base, world axes"),
    Column("truth_foot_forces", _FEET_XYZ, "N", "ground on foot, world axes, x y z of each foot"),
    Column("truth_contact", LEGS, "", "whether a foot bears any force, 0 or 1"),
    Column("truth_com", _XYZ, "m", "centre of mass, world"),
)
COLUMN_BY_NAME = {column.name: column for column in COLUMNS}
REPLAY_PREFIX = "replay_"  # begin of the names of arrays for surefoot replay, in the same file
RUN_PREFIX = "run_"  # the same of those that surefoot run adds
CLOCK_COLUMNS = ("tick", "time")
SENSOR_COLUMNS = ("gyroscope", "accelerometer", "quaternion", "q", "dq", "tauEst")
FOOT_COLUMNS = ("footForce", "footForceEst")
REQUIRED_COLUMNS = tuple(column.name for column in COLUMNS if column.required)


def valid_names() -> str:
    """Return what columns may be called, for errors: name (width)."""
    return ", ".join(f"{column.name} ({column.width})" for column in COLUMNS)
