"""Names that other tools give to the columns of a log.

- `angular_velocity.x`, `position[3]` with `name[3]`: Imu and JointState of ROS sensor_msgs
- `%time`, `field.header.stamp`, `field.position0`: `rostopic echo -p` of ros_comm
- `__time`, `/joint_states/FR_hip_joint/position`: PlotJuggler (plotjuggler_ros, jointstates_msg.h)
- `imu.gyroscope[0]`, `motorState[0].tauEst`: the SDK's comm.h; unitree_ros_to_real, LowState.msg
- `imu_state.gyroscope[0]`, `motor_state[0].tau_est`: unitree_ros2, unitree_go/msg/LowState.msg
- `imu_qw`, `FR_hip_tau_est`, `foot_FL_est`, `time_s`: lowstate_full_logger, a ROS 2 node for Go2
- `imu.angular_velocity.x`, `joint_states.FL_Hip.position`, `feet_forces.FL.z`,
  `base_ground_truth.position.x`: serow, evaluation/mujoco_test/quadruped/go2_mujoco_test.cpp
- `imu/angular_velocity`, `joint_states/positions`: serow, test/mujoco_test/go2_mujoco_test.cpp

column_names.py knows the LowState fields; this module knows the other names.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.column_definitions import JOINTS

_LEG = "(?P<leg>fr|fl|rr|rl)"
_UNIT = r"(?:[_ \[(]*(?:s|sec|secs|seconds|ms|us|ns|nsec)[\])]?)?"
_TRUTH = r"(?:.*[./])?base_ground_truth[./_]"
# Patterns of single components: column and a regular expression. The groups leg, joint and axis
# name the component; index is its number.
_COMPONENTS = [
    ("gyroscope", r"angular_velocity[./_](?P<axis>[xyz])"),
    ("accelerometer", r"linear_acceleration[./_](?P<axis>[xyz])"),
    ("quaternion", r"orientation[./_](?P<axis>[wxyz])"),
    ("quaternion", r"imu[./_]q(?P<axis>[wxyz])"),
    ("q", rf"{_LEG}_(?P<joint>hip|thigh|calf)(?:_joint)?[./_](?:position|pos|q)"),
    ("dq", rf"{_LEG}_(?P<joint>hip|thigh|calf)(?:_joint)?[./_](?:velocity|vel|dq)"),
    ("tauEst", rf"{_LEG}_(?P<joint>hip|thigh|calf)(?:_joint)?[./_](?:effort|torque|tau_?est|tau)"),
    ("footForce", rf"foot[./_]{_LEG}"),
    ("footForceEst", rf"foot[./_]{_LEG}_est"),
    ("footForceEst", rf"feet_forces?[./]{_LEG}[./]z"),
]
_TRUTH_COMPONENTS = [
    ("truth_p", rf"{_TRUTH}position[./_](?P<axis>[xyz])"),
    ("truth_quaternion", rf"{_TRUTH}orientation[./_](?P<axis>[wxyz])"),
    ("truth_v", rf"{_TRUTH}linear_velocity[./_](?P<axis>[xyz])"),
    ("truth_com", rf"{_TRUTH}com_position[./_](?P<axis>[xyz])"),
]
# Clocks, best first: the sensor's own stamp, then the names of a plain clock, then the recorder's.
_CLOCKS = [
    r"(?:.*[./])?header[./]stamp",
    rf"(?:time|timestamp|timestamps|t){_UNIT}",
    r"%time|__time|ros_?time|unix_time",
]
_STAMP_PART = re.compile(r"(?:.*[./])?header[./]stamp[./](?P<part>n?)(?:ano)?secs?")
# Messages of other topics have the same fields; commands and references are no measurements.
_OTHER = re.compile(r"odom|pose|twist|truth|covariance|cmd|command|desired|target|ref|goal|bias")
_MATCHERS = [(column, re.compile(rf"(?:.*[./_])?{text}")) for column, text in _COMPONENTS]
_TRUTH_MATCHERS = [(column, re.compile(text)) for column, text in _TRUTH_COMPONENTS]
_CLOCK_MATCHERS = [re.compile(text) for text in _CLOCKS]
# rostopic prints nanoseconds, PlotJuggler seconds.
_UNIT_OF_CLOCK = {"%time": "nanoseconds", "__time": "seconds"}
_UNIT_OF_SUFFIX = {
    **dict.fromkeys(("s", "sec", "secs", "seconds"), "seconds"),
    **{"ms": "milliseconds", "us": "microseconds", "ns": "nanoseconds", "nsec": "nanoseconds"},
}
_AXES = {4: ("w", "x", "y", "z"), 3: ("x", "y", "z")}


@dataclass(frozen=True)
class WholeColumn:
    """Array of another tool that holds a whole column.

    Attributes:
        column: Name of the column.
        order: Index in the array for each component of the column.
        note: How the array is read, for the user.
    """

    column: str
    order: tuple[int, ...]
    note: str


_FL_FIRST = (3, 4, 5, 0, 1, 2, 9, 10, 11, 6, 7, 8)
_ORDER_NOTE = "is read with the legs in the order FL FR RL RR, as serow writes it"
_WHOLE = {
    "angular_velocity": WholeColumn("gyroscope", (0, 1, 2), ""),
    "linear_acceleration": WholeColumn("accelerometer", (0, 1, 2), ""),
    "orientation": WholeColumn("quaternion", (3, 0, 1, 2), "is read as x y z w, as in ROS"),
    "joint_states/positions": WholeColumn("q", _FL_FIRST, _ORDER_NOTE),
    "joint_states/velocities": WholeColumn("dq", _FL_FIRST, _ORDER_NOTE),
    "joint_states/efforts": WholeColumn("tauEst", _FL_FIRST, _ORDER_NOTE),
}


def find_foreign(word: str) -> tuple[str, int] | None:
    """Return the column and component that another tool's name (lower case) means, or None."""
    for column, matcher in _TRUTH_MATCHERS:
        if match := matcher.fullmatch(word):
            return column, _component(column, match.groupdict())
    if _OTHER.search(word):
        return None
    for column, matcher in _MATCHERS:
        if match := matcher.fullmatch(word):
            return column, _component(column, match.groupdict())
    return ("time", 0) if clock_rank(word) is not None else None


def find_whole(word: str) -> WholeColumn | None:
    """Return the column that an array of another tool holds, or None; `word` is lower case."""
    if _OTHER.search(word):
        return None
    for name, whole in _WHOLE.items():
        if word == name or word.endswith((f"/{name}", f".{name}")):
            return whole
    return None


def clock_rank(word: str) -> int | None:
    """Return the rank of a clock's name (lower case), 0 the best; None if it names no clock."""
    for rank, matcher in enumerate(_CLOCK_MATCHERS):
        if matcher.fullmatch(word):
            return rank
    return None


def clock_unit(word: str) -> str | None:
    """Return the unit that a clock's name (lower case) states: "seconds" .. "nanoseconds"."""
    if word in _UNIT_OF_CLOCK or _STAMP_PART.fullmatch(word):
        return _UNIT_OF_CLOCK.get(word, "seconds")
    match = re.fullmatch(r".*[_ \[(]+(?P<unit>[a-z]+)[\])]?", word)
    return None if match is None else _UNIT_OF_SUFFIX.get(match["unit"])


def stamp_part(word: str) -> str | None:
    """Return "s" or "ns" if a name (lower case) is that part of a ROS stamp, else None."""
    match = _STAMP_PART.fullmatch(word)
    return None if match is None or _OTHER.search(word) else f"{match['part']}s"


def _component(column: str, groups: dict[str, str]) -> int:
    if "axis" in groups:
        width = 4 if column.endswith("quaternion") else 3
        return _AXES[width].index(groups["axis"])
    leg = LEGS.index(groups["leg"].upper())
    return 3 * leg + JOINTS.index(groups["joint"]) if "joint" in groups else leg


_JOINT_ARRAYS = {"position": "q", "velocity": "dq", "effort": "tauEst"}
_JOINT_ARRAY = re.compile(
    r"(?P<prefix>.*?)(?P<field>name|position|velocity|effort)\[?_?(?P<k>\d+)\]?"
)


def joint_array(text: str) -> tuple[str, str, int] | None:
    """Return prefix, field and place of a sensor_msgs/JointState array in a name, or None.

    The field is "name" or a column. Example: field.position3 gives ("field.", "q", 3).
    """
    match = _JOINT_ARRAY.fullmatch(text.strip().lower())
    if match is None or _OTHER.search(match["prefix"]):
        return None
    return match["prefix"], _JOINT_ARRAYS.get(match["field"], "name"), int(match["k"])


def motor_of_joint(name: str) -> int | None:
    """Return the motor of a joint's name (FR_hip_joint), or None if the name is another's."""
    match = re.fullmatch(
        rf"(?:.*[/_])?{_LEG}_(?P<joint>hip|thigh|calf)(?:_joint)?", name.strip().strip('"').lower()
    )
    return None if match is None else _component("q", match.groupdict())
