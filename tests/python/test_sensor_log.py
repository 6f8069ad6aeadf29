# SPDX-License-Identifier: BSD-3-Clause
"""Sensor log files: formats, column names and refused files."""

from __future__ import annotations

import numpy as np
import pytest
import surefoot
from estimate_helpers import moving_log, small_csv, small_table, with_columns, write_rows
from surefoot import Error
from surefoot.estimate import COLUMNS, read_log, write_log
from surefoot.sensor_log.column_names import find_column

NAMES = {
    "accelerometer_0": ("accelerometer", 0),
    "ACC.X": ("accelerometer", 0),
    "accel_2": ("accelerometer", 2),
    "imu.accelerometer[1]": ("accelerometer", 1),
    "imu_gyroscope_z": ("gyroscope", 2),
    "gyro[0]": ("gyroscope", 0),
    "quat_w": ("quaternion", 0),
    "imu.quaternion.3": ("quaternion", 3),
    "motorState[3].q": ("q", 3),
    "motorState_11_tauEst": ("tauEst", 11),
    "motorState.4.dq": ("dq", 4),
    "q_FR_hip": ("q", 0),
    "q_RL_calf_joint": ("q", 11),
    "dq_FL_1": ("dq", 4),
    "tau_7": ("tauEst", 7),
    "footForce_RR": ("footForce", 2),
    "foot_force_est_FR": ("footForceEst", 0),
    "footForceEst[3]": ("footForceEst", 3),
    "truth_foot_forces_FL_z": ("truth_foot_forces", 5),
    "Timestamp": ("time", None),
    "q": ("q", None),
}
UNKNOWN_NAMES = [
    "qx",
    "quality",
    "q_12",
    "q_FR",
    "gyro_w",
    "motorState[12].q",
    "motorState[0].ddq",
    "",
]


@pytest.mark.parametrize(("name", "meant"), NAMES.items())
def test_column_name_variants_are_recognised(name, meant) -> None:
    column, index = find_column(name)
    assert (column.name, index) == meant


@pytest.mark.parametrize("name", UNKNOWN_NAMES)
def test_unknown_column_name_is_not_guessed(name) -> None:
    assert find_column(name) is None


@pytest.mark.parametrize("suffix", [".csv", ".npz", ".NPZ"])
def test_written_log_reads_back_unchanged(tmp_path, suffix) -> None:
    log, path = moving_log(), tmp_path / f"log{suffix}"
    write_log(path, log)
    again = read_log(path)
    assert set(again.columns) == set(log.columns)
    for name, values in log.columns.items():
        kind = np.float64 if name.startswith("truth_") else np.float32  # precision of LowState
        np.testing.assert_array_equal(again.columns[name].astype(kind), values, err_msg=name)
    np.testing.assert_array_equal(again.time, log.time)
    assert (again.ignored, again.warnings, again.clock) == ((), (), "tick")


def test_minimal_log_needs_clock_gyroscope_accelerometer_and_angles(tmp_path) -> None:
    log = read_log(small_csv(tmp_path / "a.csv"))
    assert set(log.columns) == {"time", "gyroscope", "accelerometer", "q"}
    assert log.period == pytest.approx(0.002)
    assert not log.sensor("tauEst").any() and log.sensor("tauEst").shape == (5, 12)


@pytest.mark.parametrize("delimiter", [";", "\t"])
def test_csv_cells_may_be_quoted_empty_or_separated_by_tab_or_semicolon(
    tmp_path, delimiter
) -> None:
    text = small_csv(tmp_path / "a.csv").read_text().replace(",", delimiter).splitlines()
    text[2] = text[2].replace(f"9.81{delimiter}", f'"9.81"{delimiter}', 1)
    text[3] = text[3].replace(f"9.81{delimiter}", delimiter, 1)
    (tmp_path / "b.csv").write_text("\ufeff" + "\n".join(text), encoding="utf-8")
    up = read_log(tmp_path / "b.csv").columns["accelerometer"][:, 2]
    np.testing.assert_array_equal(up, [9.81, 9.81, np.nan, 9.81, 9.81])


def test_unknown_columns_are_ignored_and_named(tmp_path) -> None:
    path = small_csv(tmp_path / "a.csv")
    lines = path.read_text().split()
    path.write_text("\n".join(["phase," + lines[0], *("stance," + line for line in lines[1:])]))
    assert read_log(path).ignored == ("phase",)


def test_npz_components_may_be_separate_arrays(tmp_path) -> None:
    table = {name: np.array(values) for name, values in small_table().items()}
    angles = table.pop("q")
    table["time"] = table["time"][:, 0]
    table |= {f"motorState[{k}].q": angles[:, k] for k in range(12)}
    np.savez(tmp_path / "a.npz", robot="go1", **table)
    log = read_log(tmp_path / "a.npz")
    np.testing.assert_array_equal(log.columns["q"], angles)
    assert log.ignored == ("robot",)


def test_wrapping_tick_gives_continuous_time(tmp_path) -> None:
    table = small_table()
    table["tick"] = [[(2**32 - 4 + 2 * k) % 2**32] for k in range(5)]
    del table["time"]
    np.testing.assert_allclose(
        read_log(small_csv(tmp_path / "a.csv", table)).time, 0.002 * np.arange(5)
    )


def test_constant_tick_falls_back_to_the_time_column(tmp_path) -> None:
    log = read_log(small_csv(tmp_path / "a.csv", {"tick": [[0]] * 5, **small_table()}))
    assert log.clock == "time" and "tick is constant" in log.warnings[0]


def test_all_nan_optional_column_counts_as_missing(tmp_path) -> None:
    log = read_log(
        small_csv(tmp_path / "a.csv", {**small_table(), "quaternion": [["nan"] * 4] * 5})
    )
    assert "quaternion" not in log.columns and "quaternion" in log.warnings[0]


def without(name):
    return {key: values for key, values in small_table().items() if key != name}


def with_time(*times):
    return {**small_table(len(times)), "time": [[t] for t in times]}


def cell(name, value):
    table = small_table()
    table[name] = [list(row) for row in table[name]]
    table[name][2][0] = value
    return table


BAD_CSV = {
    "no gyroscope": (without("gyroscope"), "missing column 'gyroscope'", "valid names"),
    "no accelerometer": (without("accelerometer"), "missing column 'accelerometer'", "got gyro"),
    "no q": (without("q"), "missing column 'q'", "expected a clock"),
    "no clock": (without("time"), "missing column 'tick' (or 'time')", "got accelerometer"),
    "a name misspelt": (
        {**without("gyroscope"), "gyrscope": [[0.0] * 3] * 5},
        "missing column 'gyroscope' (is it 'gyrscope_0'?)",
        "valid names",
    ),
    "eleven joints": ({**without("q"), "q": [[0.1] * 11] * 5}, "'q'", "got 11", "expected 12"),
    "twice the same": ({**small_table(), "acc": [[0.0] * 3] * 5}, "'acc_0'", "expected it once"),
    "a word": (cell("q", "broken"), "line 4", "'q_0'", "got 'broken'", "expected a number"),
    "a clock that goes back": (
        with_time(0.0, 0.002, 0.001),
        "'time'",
        "line 4",
        "got 0.001 after 0.002",
        "never goes",
    ),
    "a clock that stands still": (
        with_time(1.0, 1.0, 1.0),
        "'time'",
        "same value 1 in 3 rows",
        "advances",
    ),
    "a clock without a unit": (with_time(0.0, 2e-6, 4e-6), "'time'", "step of 2e-06", "in seconds"),
    "a clock without digits": (
        with_time(*[1.0] * 40, 2.0),
        *("'time'", "the row before in 39 of 41 rows", "digits"),
    ),
    "seconds for ticks": (
        {**without("time"), "tick": [[0.002 * k] for k in range(5)]},
        "'tick'",
        "whole milliseconds",
    ),
    "a needed column of NaN": (
        {**without("gyroscope"), "gyroscope": [["nan"] * 3] * 5},
        "'gyroscope'",
        "NaN or infinity in every row",
    ),
}


@pytest.mark.parametrize(("table", "words"), [(c[0], c[1:]) for c in BAD_CSV.values()], ids=BAD_CSV)
def test_invalid_csv_error_names_column_got_and_expected(tmp_path, table, words) -> None:
    with pytest.raises(Error) as refused:
        read_log(small_csv(tmp_path / "bad.csv", table))
    for word in (*words, "bad.csv", "got", "expected"):
        assert word in str(refused.value)


BAD_TEXT = {
    "empty": ("", "empty file"),
    "a header alone": ("tick,q_imu\n", "missing column"),
    "numbers alone": ("1,2,3\n4,5,6\n", "line 1: got numbers"),
}


@pytest.mark.parametrize(("text", "word"), BAD_TEXT.values(), ids=BAD_TEXT)
def test_a_file_that_is_no_log_is_refused(tmp_path, text, word) -> None:
    (tmp_path / "bad.csv").write_text(text)
    with pytest.raises(Error, match=word):
        read_log(tmp_path / "bad.csv")


def test_rows_that_are_missing_or_ragged_are_refused(tmp_path) -> None:
    header = small_csv(tmp_path / "a.csv").read_text().split()
    (tmp_path / "a.csv").write_text(header[0] + "\n")
    with pytest.raises(Error, match="no rows"):
        read_log(tmp_path / "a.csv")
    (tmp_path / "a.csv").write_text("\n".join([*header[:3], "0.1,0.2", *header[3:]]))
    with pytest.raises(Error, match=r"line 4: got 2 cells, expected 19"):
        read_log(tmp_path / "a.csv")
    one = write_rows(tmp_path / "b.csv", ["time", "gyroscope"], [[0.0, "[0, 0, 0]"]])
    with pytest.raises(Error, match=r"'gyroscope': got 1 number per row, expected 3 columns"):
        read_log(one)


BAD_ARRAYS = {
    "width": ({"q": np.zeros((5, 11))}, r"'q': got shape \(5, 11\), expected \(rows, 12\)"),
    "transposed": ({"gyroscope": np.zeros((3, 5))}, "is it transposed"),
    "length": ({"q": np.zeros((4, 12))}, "unequal length"),
    "words": ({"q": np.full((5, 12), "a")}, "expected numbers"),
    "no rows": ({k: np.zeros((0, len(v[0]))) for k, v in small_table().items()}, "without rows"),
}


@pytest.mark.parametrize(("change", "word"), BAD_ARRAYS.values(), ids=BAD_ARRAYS)
def test_invalid_npz_array_is_refused(tmp_path, change, word) -> None:
    np.savez(tmp_path / "a.npz", **{**small_table(), **change})
    with pytest.raises(Error, match=word):
        read_log(tmp_path / "a.npz")


def test_files_that_cannot_be_read_are_refused(tmp_path) -> None:
    for name in ("nowhere.csv", "nowhere.npz", "log.txt"):
        with pytest.raises(Error, match=name):
            read_log(tmp_path / name)
    (tmp_path / "a.npz").write_bytes(b"no archive")
    with pytest.raises(Error, match="no valid NPZ file"):
        read_log(tmp_path / "a.npz")
    (tmp_path / "a.csv").mkdir()
    with pytest.raises(Error, match="cannot read"):
        read_log(tmp_path / "a.csv")
    with pytest.raises(Error, match=r"\.csv or \.npz"):
        write_log(tmp_path / "log.txt", moving_log())


def test_every_column_can_be_written_and_read(tmp_path) -> None:
    rng = np.random.default_rng(1)
    columns = {c.name: rng.integers(0, 90, (7, c.width)).astype(float) for c in COLUMNS}
    columns["time"] = 0.002 * np.arange(7.0)[:, None]
    columns["tick"] = 2.0 * np.arange(7.0)[:, None]
    columns["footForce"][:] = -300.0
    del columns["mode"]
    for name in ("a.csv", "a.npz"):
        write_log(tmp_path / name, with_columns(**columns))
        again = read_log(tmp_path / name).columns
        assert set(again) == set(columns)
        for key, values in columns.items():
            np.testing.assert_array_equal(again[key], values, err_msg=key)


def test_estimate_module_defines_its_public_names() -> None:
    assert all(hasattr(surefoot.estimate, name) for name in surefoot.estimate.__all__)
