# SPDX-License-Identifier: BSD-3-Clause
"""Column names of other tools, and maps of column names."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from estimate_helpers import moving_log, write_rows
from surefoot import Error
from surefoot.cli import main
from surefoot.estimate import read_log, write_log
from surefoot.sensor_log.column_definitions import MOTOR_NAMES
from surefoot.sensor_log.column_names import find_column
from surefoot.sensor_log.foreign_names import find_whole

LEGS = ("FR", "FL", "RR", "RL")
NAMES = {
    "/imu/data/angular_velocity/x": ("gyroscope", 0),
    "field.linear_acceleration.z": ("accelerometer", 2),
    "orientation.w": ("quaternion", 0),
    "/joint_states/FR_hip_joint/position": ("q", 0),
    "joint_states.RL_Calf.velocity": ("dq", 11),
    "/joint_states/FL_thigh_joint/effort": ("tauEst", 4),
    "field.motorState3.q": ("q", 3),
    "state.motorState[0].tauEst": ("tauEst", 0),
    "/lowstate/motor_state[11]/tau_est": ("tauEst", 11),
    "/lowstate/imu_state/quaternion[3]": ("quaternion", 3),
    "field.imu.gyroscope1": ("gyroscope", 1),
    "/lowstate/foot_force[2]": ("footForce", 2),
    "field.footForceEst0": ("footForceEst", 0),
    "/lowstate/tick": ("tick", None),
    "imu_qw": ("quaternion", 0),
    "imu_gyro_x": ("gyroscope", 0),
    "imu_acc_z": ("accelerometer", 2),
    "FR_hip_tau_est": ("tauEst", 0),
    "RR_calf_q": ("q", 8),
    "foot_FL": ("footForce", 1),
    "foot_FL_est": ("footForceEst", 1),
    "feet_forces.RR.z": ("footForceEst", 2),
    "base_ground_truth.position.x": ("truth_p", 0),
    "base_ground_truth.orientation.w": ("truth_quaternion", 0),
    "time_s": ("time", 0),
    "%time": ("time", 0),
    "__time": ("time", 0),
    "field.header.stamp": ("time", 0),
}
OTHERS = [
    "/odom/pose/pose/orientation/x",
    "field.angular_velocity_covariance0",
    "/imu/data/orientation_covariance[0]",
    "/lowcmd/motor_cmd[0]/q",
    "FR_hip_q_ref",
    "desired/FR_hip_joint/position",
    "imu_rpy_x",
    "position[0]",
    "motorState[13].q",
    "run_time_error",
    "FR_foot_joint.position",
]


@pytest.mark.parametrize(("name", "meant"), NAMES.items())
def test_name_of_another_tool_is_recognised(name, meant) -> None:
    column, index = find_column(name)
    assert (column.name, index) == meant


@pytest.mark.parametrize("name", OTHERS)
def test_name_of_another_message_is_not_taken(name) -> None:
    assert find_column(name) is None


def parts(column):
    """Return the components of a column of moving_log() as lists of numbers."""
    return moving_log().columns[column].T.tolist()


def named(columns):
    """Return header and rows of a CSV with the given names, each with a list of numbers."""
    return list(columns), list(zip(*columns.values(), strict=True))


def sdk_names(motor="motorState[{}].{}", tau="tauEst", imu="imu.{}[{}]", force="footForce[{}]"):
    columns = {"tick": parts("tick")[0]}
    for name in ("quaternion", "gyroscope", "accelerometer"):
        columns |= {imu.format(name, k): v for k, v in enumerate(parts(name))}
    for name, field in (("q", "q"), ("dq", "dq"), ("tauEst", tau)):
        columns |= {motor.format(k, field): v for k, v in enumerate(parts(name))}
        columns |= {motor.format(k, field): [0.0] * moving_log().rows for k in range(12, 20)}
    columns |= {force.format(k): v for k, v in enumerate(parts("footForce"))}
    return columns


def ros_names(separator="/", imu="/imu/data/", joint="/joint_states/{}_joint/{}", clock="__time"):
    columns = {clock: (1.7e9 + moving_log().time).tolist()}
    for name, field, axes in (
        ("quaternion", "orientation", "wxyz"),
        ("gyroscope", "angular_velocity", "xyz"),
        ("accelerometer", "linear_acceleration", "xyz"),
    ):
        values = dict(zip(axes, parts(name), strict=True))
        columns |= {f"{imu}{field}{separator}{axis}": values[axis] for axis in sorted(axes)}
        columns |= {f"{imu}{field}_covariance[{k}]": [0.0] * moving_log().rows for k in range(9)}
    for name, field in (("q", "position"), ("dq", "velocity"), ("tauEst", "effort")):
        values = dict(zip(MOTOR_NAMES, parts(name), strict=True))
        columns |= {joint.format(motor, field): values[motor] for motor in sorted(MOTOR_NAMES)}
    return columns


def rostopic_names():
    rows = moving_log().rows
    stamps = [int(2_000_000 * k) + 1_700_000_000_000_000_000 for k in range(rows)]
    columns = ros_names(".", "field.", "unused {} {}", "%time")
    columns = {name: v for name, v in columns.items() if not name.startswith("unused")}
    columns["%time"] = [stamp + 40_000 * (k % 2) for k, stamp in enumerate(stamps)]
    columns["field.header.stamp"] = stamps
    order = sorted(range(12), key=lambda k: MOTOR_NAMES[k])
    columns |= {f"field.name{k}": [f"{MOTOR_NAMES[m]}_joint"] * rows for k, m in enumerate(order)}
    for name, field in (("q", "position"), ("dq", "velocity"), ("tauEst", "effort")):
        columns |= {f"field.{field}{k}": parts(name)[m] for k, m in enumerate(order)}
    return columns


def ros2_stamps():
    columns = ros_names(".", "", "{}.{}", "header.stamp.sec")
    nanoseconds = [1_700_000_000_999_000_000 + 2_000_000 * k for k in range(moving_log().rows)]
    columns["header.stamp.sec"] = [stamp // 10**9 for stamp in nanoseconds]
    columns["header.stamp.nanosec"] = [stamp % 10**9 for stamp in nanoseconds]
    return columns


def go2_logger():
    columns = {"time_s": moving_log().time.tolist()}
    columns |= {f"imu_q{a}": v for a, v in zip("wxyz", parts("quaternion"), strict=True)}
    columns |= {f"imu_gyro_{a}": v for a, v in zip("xyz", parts("gyroscope"), strict=True)}
    columns |= {f"imu_acc_{a}": v for a, v in zip("xyz", parts("accelerometer"), strict=True)}
    for name, field in (("q", "q"), ("dq", "dq"), ("tauEst", "tau_est")):
        columns |= {f"{m}_{field}": v for m, v in zip(MOTOR_NAMES, parts(name), strict=True)}
    columns |= {f"foot_{leg}": v for leg, v in zip(LEGS, parts("footForce"), strict=True)}
    return columns


TOOLS = {
    "SDK": sdk_names,
    "pybind SDK": lambda: sdk_names("state.motorState[{}].{}", imu="state.imu.{}[{}]"),
    "unitree_legged_msgs by rostopic": lambda: sdk_names(
        "field.motorState{}.{}", "tauEst", "field.imu.{}{}", "field.footForce{}"
    ),
    "unitree_ros2 by PlotJuggler": lambda: sdk_names(
        "/lowstate/motor_state[{}]/{}",
        "tau_est",
        "/lowstate/imu_state/{}[{}]",
        "/lowstate/foot_force[{}]",
    ),
    "sensor_msgs by PlotJuggler": ros_names,
    "serow": lambda: ros_names(".", "imu.", "joint_states.{}.{}", "timestamp"),
    "sensor_msgs by rostopic": rostopic_names,
    "sensor_msgs with stamps in two parts": ros2_stamps,
    "a logger of Go2": go2_logger,
}


@pytest.mark.parametrize("tool", TOOLS)
def test_log_of_another_tool_has_the_same_values(tool, tmp_path) -> None:
    log = read_log(write_rows(tmp_path / "log.csv", *named(TOOLS[tool]())))
    np.testing.assert_allclose(log.time, moving_log().time, atol=3e-7)
    for name in ("gyroscope", "accelerometer", "quaternion", "q", "dq", "tauEst"):
        np.testing.assert_array_equal(log.columns[name], moving_log().columns[name], name)


def test_joint_names_that_change_are_refused(tmp_path) -> None:
    columns = rostopic_names()
    columns["field.name3"] = ["FR_calf_joint", "other", *columns["field.name3"][2:]]
    path = write_rows(tmp_path / "log.csv", *named(columns))
    with pytest.raises(
        Error, match=r"line 3, column 'field.name3': got 'other', expected 'FR_calf"
    ):
        read_log(path)


def test_joint_states_without_names_are_not_guessed(tmp_path) -> None:
    columns = {k: v for k, v in rostopic_names().items() if not k.startswith("field.name")}
    with pytest.raises(Error, match="missing column 'q'"):
        read_log(write_rows(tmp_path / "log.csv", *named(columns)))


def test_arrays_of_serow_are_reordered_with_a_note(tmp_path) -> None:
    log = moving_log()
    order = [3, 4, 5, 0, 1, 2, 9, 10, 11, 6, 7, 8]
    np.savez(
        tmp_path / "log.npz",
        **{
            "timestamps": log.time,
            "imu/angular_velocity": log.columns["gyroscope"],
            "imu/linear_acceleration": log.columns["accelerometer"],
            "joint_states/positions": log.columns["q"][:, order],
        },
    )
    again = read_log(tmp_path / "log.npz")
    np.testing.assert_array_equal(again.columns["q"], log.columns["q"])
    assert "'joint_states/positions' is read with the legs in the order FL FR" in again.notes[0]
    assert find_whole("imu/orientation").order == (3, 0, 1, 2)


def own_names(tmp_path):
    """Write moving_log() with names that no tool has; return log and map."""
    columns = {"stamp us": [2000 * k for k in range(moving_log().rows)]}
    columns |= {f"w{a}": v for a, v in zip("xyz", parts("gyroscope"), strict=True)}
    columns |= {f"f{a}": v for a, v in zip("xyz", parts("accelerometer"), strict=True)}
    columns |= {f"Gelenk {k}": v for k, v in enumerate(parts("q"))}
    columns |= {"q_0": [7.0] * moving_log().rows}
    joints = ", ".join(f'"Gelenk {k}"' for k in range(12))
    text = (
        f'time = "stamp us"\ngyroscope = ["wx", "wy", "wz"]\nq = [{joints}]\n'
        'accelerometer_0 = "fx"\n"imu.accelerometer[1]" = "fy"\nacc_z = "fz"\n'
    )
    (tmp_path / "map.toml").write_text(text)
    return write_rows(tmp_path / "log.csv", *named(columns)), tmp_path / "map.toml", text


def test_column_map_names_the_columns_and_precedes_other_names(tmp_path) -> None:
    path, columns, _ = own_names(tmp_path)
    log = read_log(path, columns)
    for name in ("gyroscope", "accelerometer", "q"):
        np.testing.assert_array_equal(log.columns[name], moving_log().columns[name])
    assert log.ignored == ("q_0",)


def test_column_map_of_the_command_applies_to_npz(tmp_path, capsys) -> None:
    write_log(tmp_path / "log.npz", moving_log())
    arrays = dict(np.load(tmp_path / "log.npz"))
    arrays["Winkel"] = arrays.pop("q")
    np.savez(tmp_path / "log.npz", **arrays)
    (tmp_path / "map.toml").write_text('q = "Winkel"')
    words = ["estimate", str(tmp_path / "log.npz")]
    assert main(words) == 2
    assert "missing column 'q'" in capsys.readouterr().err
    assert main([*words, "--columns", str(tmp_path / "map.toml")]) == 0


BAD_MAPS = {
    "unknown key": ("gyros = ['wx']", "unknown column 'gyros' (did you mean 'gyroscope'?)"),
    "unknown name": ("time = 'stamp ns'", "time: got 'stamp ns', expected a name in"),
    "name twice": ("time = 'wx'\nfootForce_0 = 'wx'", "footForce_0: got 'wx' for two columns"),
    "too few names": ("gyroscope = ['wx']", "expected a name or a list of 3 names"),
    "a number": ("time = 3", "time: got 3, expected a name in quotes"),
    "a table": ("[q]\na = 'b'", "q: got {'a': 'b'}, expected a name or a list of 12 names"),
    "one name for 12 columns": ("q = 'wx'", "column 'wx': got 1 number per row, expected 12"),
    "no TOML": ("q = ", "is not valid TOML"),
}


@pytest.mark.parametrize(("text", "words"), BAD_MAPS.values(), ids=BAD_MAPS)
def test_invalid_column_map_is_refused_by_key(text, words, tmp_path) -> None:
    path, columns, _ = own_names(tmp_path)
    columns.write_text(text)
    with pytest.raises(Error) as refused:
        read_log(path, columns)
    assert words in str(refused.value)


def test_every_component_has_the_axis_that_its_name_says() -> None:
    for (k, leg), (j, joint) in itertools.product(
        enumerate(LEGS), enumerate(("hip", "thigh", "calf"))
    ):
        column, index = find_column(f"{leg}_{joint}_joint.position")
        assert (column.name, index) == ("q", 3 * k + j)
