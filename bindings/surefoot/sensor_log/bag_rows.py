"""Columns of a log from the messages of a bag."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import MOTOR_COUNT
from surefoot.sensor_log.foreign_names import motor_of_joint

Messages = Sequence[tuple[int, Any]]  # time of reception [ns] and message
_MOTOR_FIELDS = {"q": "q", "dq": "dq", "tauEst": "tauest"}
_JOINT_FIELDS = {"q": "position", "dq": "velocity", "tauEst": "effort"}


def low_state_columns(messages: Messages) -> dict[str, Array]:
    """Return the columns (n, width) of LowState messages of unitree_go or unitree_legged_msgs.

    `time` is the time of reception since the first message [s].
    """
    rows: dict[str, list[Any]] = {"tick": []}
    for _, message in messages:
        imu = _field(message, "imustate", "imu")
        motors = _field(message, "motorstate")[:MOTOR_COUNT]
        values = {
            "tick": [_field(message, "tick")],
            "quaternion": _field(imu, "quaternion"),
            "gyroscope": _field(imu, "gyroscope"),
            "accelerometer": _field(imu, "accelerometer"),
            "footForce": _field(message, "footforce"),
            "footForceEst": _field(message, "footforceest"),
        }
        for name, field in _MOTOR_FIELDS.items():
            values[name] = [_field(motor, field) for motor in motors]
        for name, value in values.items():
            rows.setdefault(name, []).append(value)
    columns = {name: np.array(value, dtype=np.float64) for name, value in rows.items()}
    return {**columns, "time": _seconds([stamp for stamp, _ in messages])}


def imu_and_joint_columns(source: str, imu: Messages, joints: Messages) -> dict[str, Array]:
    """Return the columns (n, width) of Imu messages with the newest JointState before each.

    `time` is the stamp in the header of the Imu messages, or their time of reception if the stamps
    do not advance.

    Raises:
        Error: The JointStates lack a joint of the legs.
    """
    imu_stamps, joint_stamps = (_stamps(messages) for messages in (imu, joints))
    newest = np.searchsorted(joint_stamps, imu_stamps, side="right") - 1
    rows = np.flatnonzero(newest >= 0)
    columns = {
        name: values[newest[rows]] for name, values in _joint_columns(source, joints).items()
    }
    samples = [imu[int(k)][1] for k in rows]
    for name, field, axes in (
        ("quaternion", "orientation", "wxyz"),
        ("gyroscope", "angular_velocity", "xyz"),
        ("accelerometer", "linear_acceleration", "xyz"),
    ):
        values = [[getattr(getattr(s, field), axis) for axis in axes] for s in samples]
        columns[name] = np.array(values, dtype=np.float64).reshape(-1, len(axes))
    # An Imu without orientation says so by -1 (sensor_msgs/Imu).
    if all(s.orientation_covariance[0] == -1.0 for s in samples):
        del columns["quaternion"]
    return {**columns, "time": _seconds(imu_stamps[rows])}


def _joint_columns(source: str, joints: Messages) -> dict[str, Array]:
    columns: dict[str, list[list[float]]] = {}
    places: dict[tuple[str, ...], list[int]] = {}  # JointStates repeat their names
    for number, (_, message) in enumerate(joints):
        names = tuple(message.name)
        if names not in places:
            motors = [motor_of_joint(name) for name in names]
            missing = [k for k in range(MOTOR_COUNT) if k not in motors]
            if missing:
                raise Error(
                    f"{source}: message {number + 1} of the JointStates: got the joints "
                    f"{', '.join(names) or 'none'}, expected FR_hip_joint .. RL_calf_joint"
                )
            places[names] = [motors.index(k) for k in range(MOTOR_COUNT)]
        for column, field in _JOINT_FIELDS.items():
            values = getattr(message, field)
            nothing = len(values) != len(names)
            row = [np.nan if nothing else float(values[k]) for k in places[names]]
            columns.setdefault(column, []).append(row)
    return {name: np.array(values) for name, values in columns.items()}


def _stamps(messages: Messages) -> np.ndarray:
    """Return the stamps of the headers (n,) [ns], or the times of reception if they are equal."""
    stamps = np.array(
        [m.header.stamp.sec * 10**9 + m.header.stamp.nanosec for _, m in messages], dtype=np.int64
    )
    received = np.array([time for time, _ in messages], dtype=np.int64)
    return stamps if np.ptp(stamps) > 0 else received


def _seconds(stamps: Sequence[int] | np.ndarray) -> Array:
    """Return the time (n, 1) since the first stamp [s] of stamps (n,) [ns]."""
    values = np.asarray(stamps, dtype=np.int64)
    return np.asarray(1e-9 * (values - values[:1]).astype(np.float64))[:, None]


def _field(message: Any, *names: str) -> Any:
    """Return the first field that has one of the names without underscores and capitals."""
    for key, value in vars(message).items():
        if key.replace("_", "").lower() in names:
            return value
    raise KeyError(names[0])
