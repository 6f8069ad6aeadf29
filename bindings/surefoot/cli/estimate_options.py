"""The options of surefoot estimate."""

from __future__ import annotations

import argparse
import textwrap

from surefoot.cli.robot_choice import add_robot_options
from surefoot.estimate.trajectory import TRAJECTORY_COLUMNS
from surefoot.sensor_log.columns import COLUMNS, Column

_EPILOG = """\
a log has one row a report and these columns, SI units, feet and legs FR FL RR RL, each hip thigh
calf:

{columns}

* needed, with one of the clocks. Others are zeros where they are missing, dq is made from q.
truth_ columns judge the estimate and never reach the estimator. In an NPZ a column is an array
(rows, width); in a CSV its numbers are columns of a header's names, accelerometer_0 ...;
imu.accelerometer[0], acc_x, motorState[3].q, q_FL_hip, q_FL_hip_joint, footForce_RL are read too.

a trajectory has a row for each row of the log that is no repetition:

{trajectory}

exit status: 0 done, 1 a file could not be written, 2 a wrong argument or a log that is refused, 130
interrupted"""


def add_estimate_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot estimate."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG.format(
        columns=_table([(_column_name(column), _column_text(column)) for column in COLUMNS]),
        trajectory=_table(list(TRAJECTORY_COLUMNS.items())),
    )
    add = parser.add_argument
    add("log", metavar="LOG.csv|LOG.npz", help="what the sensors of a robot said")
    add_robot_options(parser, "go1")
    add("--gains", metavar="FILE.toml", help="gains that differ from the robot's own")
    add("--json", metavar="FILE|-", help="write the summary as one JSON object; - is stdout")
    add("--trajectory", metavar="FILE.csv|FILE.npz", help="write the estimate row by row")
    add("--report", metavar="DIR", help="write plots, index.html and summary.json")


def _column_name(column: Column) -> str:
    return f"{'*' if column.required else ''}{column.name} ({column.width})"


def _column_text(column: Column) -> str:
    also = f"; also {', '.join(column.aliases)}" if column.aliases else ""
    return f"{f'[{column.unit}] ' if column.unit else ''}{column.meaning}{also}"


def _table(rows: list[tuple[str, str]]) -> str:
    width = max(len(name) for name, _ in rows) + 2
    return textwrap.indent("\n".join(f"{name:<{width}}{text}" for name, text in rows), "  ")
