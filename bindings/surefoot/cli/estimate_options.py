"""Options of surefoot estimate."""

from __future__ import annotations

import argparse
import textwrap

from surefoot.cli.robot_choice import add_robot_options
from surefoot.estimate.trajectory import TRAJECTORY_COLUMNS
from surefoot.sensor_log.column_definitions import COLUMNS, Column

_EPILOG = """\
A log has one row per sample and these columns, in SI units. Legs and feet are ordered FR FL RR RL,
each leg hip thigh calf:

{columns}

* required, together with one of the clocks. Other missing columns are zero; missing dq is computed
from q. truth_ columns are only compared with the estimate; the estimator does not receive them. In
an NPZ file a column is an array (rows, width). In a CSV file each number has its own column, with a
header such as accelerometer_0, imu.accelerometer[0], acc_x, motorState[3].q, q_FL_hip,
q_FL_hip_joint or footForce_RL. The names of ROS messages, of bags turned into CSV and of serow are
known too. For others, --columns gives a TOML file:

  time = "stamp_us"
  gyroscope = ["wx", "wy", "wz"]
  q_0 = "front right hip"

A clock may count seconds, milliseconds, microseconds or nanoseconds. What is converted or left out
is printed on stderr. A bag (.db3, .mcap or its folder) needs the extra 'bags'. It has LowStates of
unitree_go or unitree_legged_msgs, or Imu and JointState messages.

A trajectory has one row for each row of the log that does not repeat the row before:

{trajectory}

exit status: 0 done, 1 a file could not be written, 2 a wrong argument, an invalid log, or a log
without a usable row, 130 interrupted"""


def add_estimate_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot estimate."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG.format(
        columns=_table([(_column_name(column), _column_text(column)) for column in COLUMNS]),
        trajectory=_table(list(TRAJECTORY_COLUMNS.items())),
    )
    add = parser.add_argument
    add("log", metavar="LOG", help="sensor log of a robot: CSV, NPZ or ROS 2 bag")
    add("--columns", metavar="FILE.toml", help="names of the columns in the log")
    add_robot_options(parser, "go1")
    add("--gains", metavar="FILE.toml", help="gains that differ from the robot's own")
    add(
        "--baseline",
        action="store_true",
        help="also run a linear Kalman filter and leg odometry, both with the attitude of VQF",
    )
    add("--json", metavar="FILE|-", help="write the summary as one JSON object; - is stdout")
    add("--trajectory", metavar="FILE.csv|FILE.npz", help="write the estimated trajectory")
    add("--report", metavar="DIR", help="write plots, index.html and summary.json")


def _column_name(column: Column) -> str:
    return f"{'*' if column.required else ''}{column.name} ({column.width})"


def _column_text(column: Column) -> str:
    also = f"; also {', '.join(column.aliases)}" if column.aliases else ""
    return f"{f'[{column.unit}] ' if column.unit else ''}{column.meaning}{also}"


def _table(rows: list[tuple[str, str]]) -> str:
    width = max(len(name) for name, _ in rows) + 2
    return textwrap.indent("\n".join(f"{name:<{width}}{text}" for name, text in rows), "  ")
