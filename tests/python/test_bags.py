# SPDX-License-Identifier: BSD-3-Clause
"""ROS 2 bags: LowStates of Unitree's packages, Imu and JointState messages, corrupt bags."""

from __future__ import annotations

import numpy as np
import pytest
from estimate_helpers import moving_log, robot
from surefoot import Error
from surefoot.estimate import read_log, run_estimator
from surefoot.sensor_log.bag_messages import (
    IMU,
    JOINT_STATE,
    UNITREE_GO,
    UNITREE_LEGGED,
    message_types,
)
from surefoot.sensor_log.column_definitions import MOTOR_NAMES

rosbag2 = pytest.importorskip("rosbags.rosbag2")
PLUGINS = {"db3": rosbag2.StoragePlugin.SQLITE3, "mcap": rosbag2.StoragePlugin.MCAP}
START = 1_700_000_000_000_000_000


def write_bag(folder, topics, plugin="db3"):
    """Write a bag; `topics` gives type, typestore and (stamp [ns], message) rows for each topic."""
    with rosbag2.Writer(folder, version=9, storage_plugin=PLUGINS[plugin]) as bag:
        for topic, (kind, store, rows) in topics.items():
            connection = bag.add_connection(topic, kind, typestore=store)
            for stamp, message in rows:
                bag.write(connection, stamp, store.serialize_cdr(message, kind))
    return folder


def low_states(kind, rows=None):
    """Return type, typestore and messages of the LowStates of moving_log()."""
    store = message_types(kind)
    package = kind.removesuffix("LowState")
    log = moving_log()
    low_state = store.types[kind]
    imu_type = store.types[package + ("IMUState" if kind == UNITREE_GO else "IMU")]
    motor_type, battery = store.types[package + "MotorState"], store.types[package + "BmsState"]
    messages = []
    for k in range(log.rows if rows is None else rows):
        row = {name: values[k].astype(np.float32) for name, values in log.columns.items()}
        imu = imu_type(
            row["quaternion"], row["gyroscope"], row["accelerometer"], np.zeros(3, "f4"), 0
        )
        motors = [filled(store, motor_type) for _ in range(20)]
        for m in range(12):
            motors[m].q, motors[m].dq = float(row["q"][m]), float(row["dq"][m])
            motors[m].tau_est = float(row["tauEst"][m])
        message = filled(store, low_state)
        message.tick = int(log.columns["tick"][k, 0])
        setattr(message, "imu_state" if kind == UNITREE_GO else "imu", imu)
        message.motor_state = motors
        message.foot_force = row["footForce"].astype(np.int16)
        message.foot_force_est = row["footForceEst"].astype(np.int16)
        setattr(message, "bms_state" if kind == UNITREE_GO else "bms", filled(store, battery))
        messages.append((START + 2_000_000 * k, message))
    return kind, store, messages


def filled(store, kind):
    """Return a message of zeros; nested messages are None."""
    _, fields = store.fielddefs[kind.__msgtype__]
    values = []
    for _, (node, detail) in fields:
        if node.name == "BASE":
            values.append(0.0 if detail[0].startswith("float") else 0)
        elif node.name == "ARRAY" and detail[0][0].name == "BASE":
            kind_name = detail[0][1][0]
            values.append(np.zeros(detail[1], kind_name.replace("float", "f").replace("f32", "f4")))
        else:
            values.append(None)
    return kind(*values)


@pytest.mark.parametrize("plugin", PLUGINS)
@pytest.mark.parametrize("kind", [UNITREE_GO, UNITREE_LEGGED])
def test_bag_of_low_states_has_the_values_of_the_log(kind, plugin, tmp_path) -> None:
    folder = write_bag(tmp_path / "bag", {"/lowstate": low_states(kind)}, plugin)
    (file,) = folder.glob(f"*.{plugin}")
    for path in (folder, file):
        log = read_log(path)
        for name in ("gyroscope", "accelerometer", "quaternion", "q", "dq", "tauEst", "footForce"):
            np.testing.assert_array_equal(log.columns[name], moving_log().columns[name], name)
        np.testing.assert_array_equal(log.time, moving_log().time)
        assert (log.clock, log.notes) == ("tick", ())
    np.testing.assert_allclose(
        run_estimator(robot(), log).q, run_estimator(robot(), moving_log()).q, atol=1e-12
    )


def test_busiest_of_several_low_state_topics_is_read_with_a_note(tmp_path) -> None:
    topics = {"/lf/lowstate": low_states(UNITREE_GO, 20), "/lowstate": low_states(UNITREE_GO, 200)}
    log = read_log(write_bag(tmp_path / "bag", topics))
    assert log.rows == 200 and log.ignored == ("/lf/lowstate",)
    assert log.notes == ("/lowstate is read: of 2 such topics it has the most messages",)


def test_zero_tick_falls_back_to_the_time_of_reception(tmp_path) -> None:
    kind, store, messages = low_states(UNITREE_GO, 200)
    for _, message in messages:
        message.tick = 0
    log = read_log(write_bag(tmp_path / "bag", {"/lowstate": (kind, store, messages)}))
    assert log.clock == "time"
    np.testing.assert_allclose(log.time, moving_log().time[:200], atol=1e-9)


def imu_and_joints(names=MOTOR_NAMES):
    """Return topics of Imu at 500 Hz and of JointState at 250 Hz, joints in alphabetical order."""
    store = message_types(IMU)
    types, log = store.types, moving_log()
    stamp, header = types["builtin_interfaces/msg/Time"], types["std_msgs/msg/Header"]
    vector, quaternion = types["geometry_msgs/msg/Vector3"], types["geometry_msgs/msg/Quaternion"]
    order = sorted(range(12), key=lambda k: MOTOR_NAMES[k])
    imu, joints = [], []
    for k in range(log.rows):
        time = START + 2_000_000 * k
        head = header(stamp(time // 10**9, time % 10**9), "imu")
        row = {name: values[k].tolist() for name, values in log.columns.items()}
        w, x, y, z = row["quaternion"]
        none = np.zeros(9)
        message = types[IMU](
            *(head, quaternion(x, y, z, w), none, vector(*row["gyroscope"]), none),
            *(vector(*row["accelerometer"]), none),
        )
        imu.append((time + 700_000, message))
        if k % 2 == 0:
            values = [np.array([row[name][m] for m in order]) for name in ("q", "dq", "tauEst")]
            joint_names = [f"{names[m]}_joint" for m in order]
            joints.append((time + 900_000, types[JOINT_STATE](head, joint_names, *values)))
    return {"/imu/data": (IMU, store, imu), "/joint_states": (JOINT_STATE, store, joints)}


def test_imu_messages_are_joined_with_the_newest_joint_states(tmp_path) -> None:
    log = read_log(write_bag(tmp_path / "bag", imu_and_joints()))
    own = moving_log()
    for name in ("gyroscope", "accelerometer", "quaternion"):
        np.testing.assert_array_equal(log.columns[name], own.columns[name])
    newest = 2 * (np.arange(own.rows) // 2)
    for name in ("q", "dq", "tauEst"):
        np.testing.assert_array_equal(log.columns[name], own.columns[name][newest])
    np.testing.assert_allclose(log.time, own.time, atol=1e-9)
    assert log.notes == ("each row is a message of /imu/data with the newest one of /joint_states",)


def test_joint_states_of_other_joints_are_refused(tmp_path) -> None:
    names = [name.replace("FR_calf", "FR_foot") for name in MOTOR_NAMES]
    with pytest.raises(Error, match=r"message 1 of the JointStates: got the joints FL_calf_joint"):
        read_log(write_bag(tmp_path / "bag", imu_and_joints(names)))


def test_bag_without_the_messages_names_its_topics(tmp_path) -> None:
    topics = {"/imu/data": imu_and_joints()["/imu/data"]}
    with pytest.raises(
        Error, match=r"got the topics /imu/data \(sensor_msgs/msg/Imu, 800\), expec"
    ):
        read_log(write_bag(tmp_path / "bag", topics))


def test_clock_that_goes_back_is_refused_by_message(tmp_path) -> None:
    kind, store, messages = low_states(UNITREE_GO, 100)
    messages[40][1].tick -= 50
    with pytest.raises(Error, match=r"message 41, column 'tick': got 30 after 78"):
        read_log(write_bag(tmp_path / "bag", {"/lowstate": (kind, store, messages)}))


def test_map_of_column_names_is_refused_for_a_bag(tmp_path) -> None:
    bag = write_bag(tmp_path / "bag", {"/lowstate": low_states(UNITREE_GO, 10)})
    (tmp_path / "map.toml").write_text("tick = 'a'")
    with pytest.raises(Error, match="leave out --columns"):
        read_log(bag, tmp_path / "map.toml")


@pytest.mark.parametrize("plugin", PLUGINS)
def test_corrupt_bag_is_refused_by_name(plugin, tmp_path) -> None:
    folder = write_bag(tmp_path / "bag", {"/lowstate": low_states(UNITREE_GO, 50)}, plugin)
    (file,) = folder.glob(f"*.{plugin}")
    good, rng = file.read_bytes(), np.random.default_rng(1)
    corrupt = [good[: len(good) // 2], b"SQLite format 3", bytes(1000), good[:16], b"x" * 50]
    for _ in range(40):
        damaged = bytearray(good)
        start = int(rng.integers(0, len(good) - 64))
        damaged[start : start + 64] = rng.integers(0, 256, 64, dtype=np.uint8).tobytes()
        corrupt.append(bytes(damaged))
    refused = 0
    for data in corrupt:
        file.write_bytes(data)
        for path in (folder, file):
            try:
                read_log(path)
            except Error as problem:
                refused += 1
                assert "bag" in str(problem) and "\n" not in str(problem)
    assert refused >= 10
    file.write_bytes(good)
    (folder / "metadata.yaml").write_text("a: [")
    with pytest.raises(Error, match="no valid ROS 2 bag"):
        read_log(folder)
