"""Reader of ROS 2 bags: LowStates of Unitree's packages, or Imu and JointState messages."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from surefoot._core import Error
from surefoot.sensor_log.bag_messages import (
    IMU,
    JOINT_STATE,
    UNITREE_GO,
    UNITREE_LEGGED,
    message_types,
)
from surefoot.sensor_log.bag_rows import imu_and_joint_columns, low_state_columns
from surefoot.sensor_log.column_map import ColumnMap
from surefoot.sensor_log.file_checks import check_log_file, printable_path
from surefoot.sensor_log.log_table import LogTable

_SUFFIXES = (".db3", ".mcap")
_METADATA = "metadata.yaml"


def is_bag(path: Path) -> bool:
    """Return whether a path names a ROS 2 bag: a storage file, or a folder with metadata.yaml."""
    return path.suffix.lower() in _SUFFIXES or _is_folder(path)


def _is_folder(path: Path) -> bool:
    return path.is_dir() and (path / _METADATA).exists()


def _is_part(file: Path) -> bool:
    return file.name == _METADATA or file.suffix.lower() in _SUFFIXES


def read_bag(path: Path, column_map: ColumnMap) -> LogTable:
    """Read the columns of a bag.

    The topic of LowStates with the most messages is read. Without LowStates, each Imu message is
    one row, with the newest JointState before it.

    Raises:
        Error: The package rosbags is missing, the bag is corrupt, or no topic has the messages.
    """
    source = printable_path(path)
    if column_map.names:
        raise Error(
            f"log: got a map of column names for the bag '{source}', expected one only for CSV and "
            "NPZ logs; leave out --columns"
        )
    files = [file for file in path.iterdir() if _is_part(file)] if _is_folder(path) else [path]
    for file in files:
        check_log_file(file)
    try:
        from rosbags.rosbag2 import Reader
    except ModuleNotFoundError as problem:
        raise Error(
            f"log: module '{problem.name}' not found: bags need the extra 'bags'; run: "
            "pip install 'surefoot[bags]'"
        ) from None
    with _refusing_corrupt_bags(source), Reader(path) as reader:
        return _read_topics(source, reader)


@contextmanager
def _refusing_corrupt_bags(source: str) -> Iterator[None]:
    try:
        yield
    except (Error, MemoryError):
        raise
    except Exception as problem:  # rosbags raises many kinds, AssertionError among them
        text = f"{type(problem).__name__}: {problem}"[:200]
        raise Error(
            f"{source}: got no valid ROS 2 bag ({text}), expected a bag in SQLite or MCAP format"
        ) from None


def _read_topics(source: str, reader: Any) -> LogTable:
    notes: list[str] = []
    low_state = _busiest(reader, (UNITREE_GO, UNITREE_LEGGED), notes)
    if low_state is not None:
        columns, used = low_state_columns(list(_messages(reader, low_state))), {low_state.topic}
    else:
        imu, joints = (_busiest(reader, (kind,), notes) for kind in (IMU, JOINT_STATE))
        if imu is None or joints is None:
            topics = [f"{c.topic} ({c.msgtype}, {c.msgcount})" for c in reader.connections]
            raise Error(
                f"{source}: got the topics {', '.join(topics) or 'none'}, expected messages of "
                f"{UNITREE_GO} or {UNITREE_LEGGED}, or of {IMU} and {JOINT_STATE}"
            )
        notes.append(f"each row is a message of {imu.topic} with the newest one of {joints.topic}")
        columns = imu_and_joint_columns(
            source, list(_messages(reader, imu)), list(_messages(reader, joints))
        )
        used = {imu.topic, joints.topic}
    if not np.size(next(iter(columns.values()))):
        raise Error(f"{source}: got no complete rows, expected one per message")
    ignored = [connection.topic for connection in reader.connections]
    return LogTable(
        columns,
        [topic for topic in ignored if topic not in used],
        notes,
        lambda row: f"message {row + 1}",
    )


def _busiest(reader: Any, kinds: tuple[str, ...], notes: list[str]) -> Any | None:
    """Return the connection of these message types with the most messages, or None."""
    found = [c for c in reader.connections if c.msgtype in kinds and c.msgcount]
    if not found:
        return None
    best = max(found, key=lambda connection: connection.msgcount)
    if len(found) > 1:
        notes.append(f"{best.topic} is read: of {len(found)} such topics it has the most messages")
    return best


def _messages(reader: Any, connection: Any) -> Iterator[tuple[int, Any]]:
    """Yield time of reception [ns] and message of each message of a connection."""
    embedded = connection.msgdef.data if connection.msgdef.format.name == "MSG" else None
    store = message_types(connection.msgtype, embedded)
    for _, stamp, data in reader.messages([connection]):
        yield stamp, store.deserialize_cdr(data, connection.msgtype)
