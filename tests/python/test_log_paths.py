# SPDX-License-Identifier: BSD-3-Clause
"""Paths that are no readable log: folders, FIFOs, links in a loop, empty, huge, unreadable."""

from __future__ import annotations

import os
import subprocess
import sys
import time

import numpy as np
import pytest
from estimate_helpers import moving_log, small_csv, small_table, with_columns
from surefoot import Error
from surefoot.cli import main
from surefoot.estimate import read_log, write_log
from surefoot.replay import read_recording
from surefoot.sensor_log import file_checks
from surefoot.sensor_log.column_map import read_column_map

SUFFIXES = ("csv", "npz", "db3", "mcap")
SECONDS = 10.0  # longest time until a path is refused


def folder(path):
    path.mkdir()


def fifo(path):
    os.mkfifo(path)


def loop(path):
    path.symlink_to(path.name)


def empty(path):
    path.touch()


def broken_link(path):
    path.symlink_to("nowhere")


def gigabyte(path):
    with path.open("wb") as file:
        file.truncate(10**9)


def device(path):
    path.symlink_to("/dev/zero")


PATHS = {
    folder: "a folder",
    fifo: "got a FIFO, expected a regular file",
    loop: "Too many levels of symbolic links",
    empty: "got an empty file",
    broken_link: "No such file or directory",
    gigabyte: "expected",
    device: "got a device, expected a regular file",
}


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("make", PATHS)
def test_path_that_is_no_log_is_refused_at_once(make, suffix, tmp_path, capsys) -> None:
    path = tmp_path / f"log.{suffix}"
    make(path)
    readers = [read_log] if suffix != "npz" else [read_log, read_recording]
    for read in readers:
        start = time.monotonic()
        with pytest.raises(Error) as refused:
            read(path)
        assert time.monotonic() - start < SECONDS
        assert PATHS[make] in str(refused.value) and f"log.{suffix}" in str(refused.value)
    assert main(["estimate", str(path)]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.count("\n") == 1


@pytest.mark.parametrize("make", [folder, fifo, loop, empty, device])
def test_map_of_column_names_is_refused_alike(make, tmp_path) -> None:
    make(tmp_path / "map.toml")
    with pytest.raises(Error) as refused:
        read_column_map(tmp_path / "map.toml")
    assert PATHS[make] in str(refused.value)


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can drop its rights")
@pytest.mark.parametrize("suffix", ["csv", "npz"])
def test_file_without_read_permission_is_refused(suffix, tmp_path) -> None:
    write_log(tmp_path / f"log.{suffix}", moving_log())
    (tmp_path / f"log.{suffix}").chmod(0)
    tmp_path.chmod(0o755)
    code = (
        "import os\n"
        "from surefoot import Error\n"
        "from surefoot.estimate import read_log\n"
        "os.setresuid(65534, 65534, 65534)\n"
        "try:\n"
        f"    read_log('log.{suffix}')\n"
        "except Error as problem:\n"
        "    print(problem)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert f"cannot read 'log.{suffix}': no read permission" in done.stdout


def test_npz_of_huge_arrays_is_refused_before_they_are_unpacked(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(file_checks, "MAX_ARRAY_BYTES", 10**7)
    path = tmp_path / "log.npz"
    np.savez_compressed(path, q=np.zeros(10**7))
    assert path.stat().st_size < 10**6
    for read in (read_log, read_recording):
        with pytest.raises(Error, match="got arrays of 80 MB, expected up to 10 MB"):
            read(path)


@pytest.mark.parametrize("text", ["\n", ",", "0,", "a,b\n", "x"])
def test_large_text_that_is_no_log_is_refused_in_ten_seconds(text, tmp_path) -> None:
    (tmp_path / "log.csv").write_text(text * (60_000_000 // len(text)))
    start = time.process_time()
    with pytest.raises(Error, match=r"log\.csv: "):
        read_log(tmp_path / "log.csv")
    assert time.process_time() - start < SECONDS


def test_npy_file_named_npz_is_refused(tmp_path) -> None:
    with (tmp_path / "log.npz").open("wb") as file:
        np.save(file, np.zeros((5, 12)))
    for read in (read_log, read_recording):
        with pytest.raises(Error, match="got no valid NPZ file"):
            read(tmp_path / "log.npz")


def test_path_that_is_not_utf8_is_estimated_and_named(tmp_path, capsys) -> None:
    path = os.fsdecode(os.fsencode(tmp_path) + b"/l\xffg.csv")
    write_log(path, moving_log())
    report = str(tmp_path / "page")
    assert main(["estimate", path, "--json", str(tmp_path / "a.json"), "--report", report]) == 0
    assert r"l\xffg.csv" in capsys.readouterr().out
    assert read_log(path).source.endswith(r"l\xffg.csv")
    assert main(["estimate", path + ".csv"]) == 2
    assert main(["replay", path]) == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 2 and r"l\xffg.csv" in err


def test_log_without_a_usable_row_is_written_and_ends_with_status_2(tmp_path, capsys) -> None:
    torques = np.where(np.arange(12) == 4, 1e5, moving_log().sensor("tauEst"))
    write_log(tmp_path / "log.csv", with_columns(tauEst=torques))
    out = tmp_path / "out.json"
    assert main(["estimate", str(tmp_path / "log.csv"), "--json", str(out)]) == 2
    text, err = capsys.readouterr()
    assert text.startswith("go1: 0 of 800 rows") and out.exists()
    assert "got no usable row of 800 (800 " in err and err.count("\n") == 1


def test_conversions_are_printed_on_stderr_and_in_the_summary(tmp_path, capsys) -> None:
    write_log(tmp_path / "log.csv", moving_log())
    text = (tmp_path / "log.csv").read_text()
    (tmp_path / "log.csv").write_text(text.replace(",", ";").replace(".", ","), encoding="utf-16")
    assert main(["estimate", str(tmp_path / "log.csv"), "--report", str(tmp_path / "page")]) == 0
    err = capsys.readouterr().err.splitlines()
    assert len(err) == 2 and all(line.startswith("surefoot: note: ") for line in err)
    assert "read as UTF-16-LE" in err[0] and "decimal commas are read as points" in err[1]
    page = (tmp_path / "page" / "index.html").read_text()
    summary = (tmp_path / "page" / "summary.json").read_text()
    assert "Note: the file is read as UTF-16-LE" in page
    assert "the file is read as UTF-16-LE" in summary


def test_dates_as_clock_of_an_npz_are_converted(tmp_path) -> None:
    table = {name: np.array(values) for name, values in small_table().items()}
    table["time"] = np.datetime64("2026-11-29T06:20", "ms") + 2 * np.arange(5)
    np.savez(tmp_path / "a.npz", **table)
    log = read_log(tmp_path / "a.npz")
    np.testing.assert_allclose(log.time, read_log(small_csv(tmp_path / "a.csv")).time, atol=1e-6)
    assert log.notes == ("column 'time' is read in nanoseconds and converted to seconds",)
