# SPDX-License-Identifier: BSD-3-Clause
"""CSV logs of other tools: encodings, separators, cut files, clocks; each is read or refused."""

from __future__ import annotations

import codecs
import itertools

import numpy as np
import pytest
from estimate_helpers import small_csv, small_table
from surefoot import Error
from surefoot.estimate import read_log

ROWS = 8


@pytest.fixture
def lines(tmp_path):
    """Lines of a valid log: a header and eight rows."""
    return small_csv(tmp_path / "good.csv", small_table(ROWS)).read_text().splitlines()


def read(tmp_path, data):
    path = tmp_path / "log.csv"
    path.write_bytes(data if isinstance(data, bytes) else data.encode())
    return read_log(path)


def assert_same(log, rows=ROWS):
    table = small_table(rows)
    for name in ("gyroscope", "accelerometer", "q"):
        np.testing.assert_array_equal(log.columns[name], table[name])
    np.testing.assert_allclose(log.time, 0.002 * np.arange(rows), atol=1e-12)


UNCHANGED = {
    "a blank second line": lambda ls: "\n".join([ls[0], "", *ls[1:], ""]),
    "blank lines at the end": lambda ls: "\n".join([*ls, "", " ", "\t", ""]),
    "lines of delimiters": lambda ls: "\n".join([*ls[:3], "," * 18, *ls[3:], ""]),
    "a byte order mark": lambda ls: codecs.BOM_UTF8 + "\n".join(ls).encode(),
    "Windows line ends": lambda ls: "\r\n".join(ls),
    "old Macintosh line ends": lambda ls: "\r".join(ls),
    "mixed line ends": lambda ls: "\r\n".join(ls[:3]) + "\n" + "\r".join(ls[3:]),
    "no last line end": lambda ls: "\n".join(ls),
    "semicolons": lambda ls: "\n".join(ls).replace(",", ";"),
    "tabs": lambda ls: "\n".join(ls).replace(",", "\t"),
    "blanks": lambda ls: "\n".join(ls).replace(",", "  "),
    "blanks after commas": lambda ls: "\n".join(ls).replace(",", ", "),
    "a declared separator": lambda ls: "\n".join(["sep=;", *ls]).replace(",", ";"),
    "a commented header": lambda ls: "# " + "\n".join(ls),
    "a comment before": lambda ls: "# recorded on Monday\n" + "\n".join(ls),
    "quotes and blanks": lambda ls: "\n".join(
        '"' + line.replace(",", '" , "') + '"' for line in ["#" + ls[0], *ls[1:]]
    ),
    "a blank line in quotes": lambda ls: "\n".join([ls[0], '""', *ls[1:]]),
    "quotes": lambda ls: "\n".join('"' + line.replace(",", '","') + '"' for line in ls),
    "a delimiter at the end of rows": lambda ls: "\n".join([ls[0], *(f"{x}," for x in ls[1:])]),
}


@pytest.mark.parametrize("change", UNCHANGED.values(), ids=UNCHANGED)
def test_harmless_dialect_is_read_without_a_note(change, lines, tmp_path) -> None:
    log = read(tmp_path, change(lines))
    assert_same(log)
    assert log.notes == ()


CONVERTED = {
    "UTF-16 with mark": (
        lambda ls: "\n".join(ls).encode("utf-16"),
        ["read as UTF-16-LE"],
    ),
    "UTF-16 BE without mark": (
        lambda ls: "\n".join(ls).encode("utf-16-be"),
        ["read as UTF-16-BE"],
    ),
    "UTF-32": (lambda ls: "\n".join(ls).encode("utf-32"), ["read as UTF-32-LE"]),
    "decimal commas": (
        lambda ls: "\n".join(ls).replace(",", ";").replace(".", ","),
        ["line 2, column 'time': decimal commas are read as points"],
    ),
    "decimal commas and tabs": (
        lambda ls: "\n".join(ls).replace(",", "\t").replace(".", ","),
        ["line 2, column 'time': decimal commas"],
    ),
    "repeated headers": (
        lambda ls: "\n".join([*ls[:3], ls[0], *ls[3:6], ls[0], *ls[6:]]),
        ["line 4: the header is repeated 2 times"],
    ),
    "comments between rows": (
        lambda ls: "\n".join([*ls[:3], "# paused", *ls[3:]]),
        ["line 4: 1 comment lines are left out"],
    ),
    "a name that is not UTF-8": (
        lambda ls: "\n".join([ls[0] + ",température", *(f"{x},20" for x in ls[1:])]).encode(
            "latin-1"
        ),
        ["line 1: bytes that are not UTF-8 are read as Latin-1"],
    ),
    "NULs at the end": (
        lambda ls: "\n".join(ls).encode() + b"\n" + bytes(500),
        ["500 NUL characters at the end of the file are removed"],
    ),
}


@pytest.mark.parametrize(("change", "words"), CONVERTED.values(), ids=CONVERTED)
def test_converted_dialect_is_read_with_a_note(change, words, lines, tmp_path) -> None:
    log = read(tmp_path, change(lines))
    assert_same(log)
    assert len(log.notes) == len(words)
    for note, word in zip(log.notes, words, strict=True):
        assert word in note


CUT = {
    "in the middle of a row": lambda text: text[: text.rindex("9.81")],
    "in the last number": lambda text: text[: text.rindex("-1.6") + 2],
    "at the sign of the last number": lambda text: text[: text.rindex("-1.6") + 1],
    "after one cell, with a line end": lambda text: text[: text.rindex("9.81")] + "\n",
}


@pytest.mark.parametrize("cut", CUT.values(), ids=CUT)
def test_last_line_that_is_cut_off_is_left_out_with_a_note(cut, lines, tmp_path) -> None:
    log = read(tmp_path, cut("\n".join(lines)))
    assert_same(log, ROWS - 1)
    assert log.notes == (f"line {ROWS + 1}: the last line is cut off and is left out",)


def with_clock(scale, origin=0.0):
    def change(lines):
        rows = [line.split(",") for line in lines[1:]]
        stamps = [f"{origin + scale * 0.002 * k:.0f}" for k in range(len(rows))]
        return "\n".join(
            [lines[0], *(",".join([s, *r[1:]]) for s, r in zip(stamps, rows, strict=True))]
        )

    return change


@pytest.mark.parametrize(
    ("change", "unit"),
    [
        (with_clock(1e3, 7e6), "milliseconds"),
        (with_clock(1e6), "microseconds"),
        (with_clock(1e9, 1_700_000_000_000_000_000), "nanoseconds"),
    ],
)
def test_clock_in_another_unit_is_converted_with_a_note(change, unit, lines, tmp_path) -> None:
    log = read(tmp_path, change(lines))
    np.testing.assert_allclose(log.time, 0.002 * np.arange(ROWS), atol=3e-7)
    assert log.notes == (f"column 'time' is read in {unit} and converted to seconds",)


def test_name_of_a_clock_states_its_unit(tmp_path) -> None:
    table = small_table(ROWS)
    stamps = table.pop("time")
    path = small_csv(tmp_path / "a.csv", {"time_ms": [[1.5 + 1e3 * t] for (t,) in stamps], **table})
    log = read_log(path)
    np.testing.assert_allclose(log.time, 0.002 * np.arange(ROWS), atol=1e-9)
    assert log.notes == ("column 'time' is read in milliseconds and converted to seconds",)


SLOW = {
    "seconds in the name": ({"time_s": [[float(k)] for k in range(ROWS)]}, "s in seconds"),
    "fractions": ({"time": [[1.003 * k] for k in range(ROWS)]}, "got 1.003 and a median step of"),
    "tick beside a clock in seconds": (
        {
            "tick": [[1000 * k] for k in range(ROWS)],
            "time_s": [[float(k)] for k in range(ROWS)],
        },
        "column 'time': got a median step of 1, expected 0.0004",
    ),
    "tick beside another duration": (
        {"tick": [[1000 * k] for k in range(ROWS)], "time": [[0.02 * k] for k in range(ROWS)]},
        "column 'tick': got a duration of 0.007 s, expected that of column 'time', 0.14 s",
    ),
    "five rows a second": ({"tick": [[200 * k] for k in range(ROWS)]}, "median step of 200"),
}


@pytest.mark.parametrize(("clocks", "words"), SLOW.values(), ids=SLOW)
def test_slow_log_is_not_taken_for_a_fast_one_in_another_unit(clocks, words, tmp_path) -> None:
    table = {name: v for name, v in small_table(ROWS).items() if name != "time"}
    with pytest.raises(Error) as refused:
        read_log(small_csv(tmp_path / "a.csv", {**clocks, **table}))
    assert words in str(refused.value)


def test_tick_in_microseconds_is_converted_and_wraps(tmp_path) -> None:
    table = small_table(ROWS)
    del table["time"]
    table["tick"] = [[(2**32 - 5000 + 2000 * k) % 2**32] for k in range(ROWS)]
    log = read_log(small_csv(tmp_path / "a.csv", table))
    np.testing.assert_allclose(log.time, 0.002 * np.arange(ROWS), atol=1e-12)
    assert log.notes == ("column 'tick' is read in microseconds and converted to milliseconds",)


def test_rows_that_repeat_the_clock_or_have_nan_are_noted_by_line(lines, tmp_path) -> None:
    rows = [line.split(",") for line in lines]
    rows[5][0] = rows[4][0]
    rows[7][2], rows[8][3] = "nan", ""
    log = read(tmp_path, "\n".join(",".join(row) for row in rows) + "\n")
    assert log.notes == (
        "1 rows repeat the clock 'time' of the row before and are skipped; the first is line 6",
        "2 rows with NaN, infinity or an empty cell in 'gyroscope' are left out; the first is "
        "line 8, column 'gyroscope_1'",
    )


def replaced(row, column, text):
    def change(lines):
        rows = [line.split(",") for line in lines]
        rows[row][column] = text
        return "\n".join(",".join(r) for r in rows) + "\n"

    return change


REFUSED = {
    "text": (replaced(3, 5, "n/a"), "line 4, column 'accelerometer_1': got 'n/a'"),
    "a second header line with units": (
        lambda ls: "\n".join([ls[0], ",".join(["s"] * 19), *ls[1:]]),
        "line 2, column 'time': got 's'",
    ),
    "digits with an underscore": (replaced(2, 1, "1_0"), "line 3, column 'gyroscope_0': got '1_0'"),
    "other digits": (replaced(2, 1, "١٢"), "line 3, column 'gyroscope_0': got '١٢'"),
    "a date": (replaced(1, 0, "2026-11-29 06:20"), "line 2, column 'time': got '2026-11-29"),
    "a comment at the end of a row": (replaced(2, 18, "-1.6 # end"), "line 3, column 'q_11'"),
    "decimal commas with commas": (
        lambda ls: "\n".join([ls[0], *(line.replace(".", ",") for line in ls[1:])]),
        "decimal commas, separate the cells by ';'",
    ),
    "decimal commas and points": (
        lambda ls: "\n".join(ls).replace(",", ";").replace("9.81", "9,81", 3),
        "line 2, column 'accelerometer_2': got '9,81' in a file with decimal commas and",
    ),
    "thousands": (
        lambda ls: "\n".join(ls).replace(",", ";").replace("9.81", "1.009,81"),
        "got '1.009,81' in a file with decimal commas and",
    ),
    "a short row": (
        lambda ls: "\n".join([*ls[:4], ls[4][:20], *ls[5:]]),
        "line 5: got 5 cells, expected 19",
    ),
    "a NUL inside": (
        lambda ls: "\n".join([*ls[:2], ls[2] + "\0", *ls[3:]]),
        "line 3: got a NUL character",
    ),
    "an open quote": (lambda ls: "\n".join([*ls[:2], '"' + ls[2], *ls[3:]]), "line 3: got wrong"),
    "rows in another order": (
        lambda ls: "\n".join([ls[0], *ls[4:6], *ls[1:4], *ls[6:]]) + "\n",
        "line 4, column 'time': got 0 after 0.008, expected a clock that never goes backwards",
    ),
    "a header alone": (lambda ls: ls[0], "got a header and no rows"),
}


@pytest.mark.parametrize(("change", "words"), REFUSED.values(), ids=REFUSED)
def test_other_content_is_refused_with_its_first_line_column_and_text(
    change, words, lines, tmp_path
) -> None:
    with pytest.raises(Error) as refused:
        read(tmp_path, change(lines))
    assert words in str(refused.value)
    assert "\n" not in str(refused.value)


def test_text_in_an_unused_column_does_no_harm(lines, tmp_path) -> None:
    text = [lines[0] + ",state", *(f"{line},stand up" for line in lines[1:])]
    log = read(tmp_path, "\n".join(text))
    assert_same(log)
    assert (log.notes, log.ignored) == ((), ("state",))


def test_conversions_combine(lines, tmp_path) -> None:
    text = "\r\n".join([*lines, lines[0], "", lines[-1][:9]])
    text = text.replace(",", ";").replace(".", ",")
    log = read(tmp_path, text.encode("utf-16"))
    assert_same(log)
    assert [note.split(":")[0] for note in log.notes] == [
        *("the file is read as UTF-16-LE", f"line {ROWS + 2}", "line 2, column 'time'"),
        f"line {ROWS + 4}",
    ]
    assert len(list(itertools.chain(log.notes))) == 4
