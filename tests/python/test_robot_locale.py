# SPDX-License-Identifier: BSD-3-Clause
"""Robot files are the same under a locale with a decimal comma, made here by localedef."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
import surefoot

SOURCE = """comment_char %
escape_char /
LC_NUMERIC
decimal_point ","
thousands_sep "."
grouping 3;3
END LC_NUMERIC
"""
ROUND_TRIP = """
import ctypes, locale, sys
locale.setlocale(locale.LC_ALL, "comma")
assert locale.localeconv()["decimal_point"] == ","
text = ctypes.create_string_buffer(40)
ctypes.CDLL(None).snprintf(text, 40, b"%g", ctypes.c_double(0.5))
assert text.value == b"0,5", text.value
import surefoot
from surefoot.robot.loading import describe_robot
described = describe_robot("go1")
robot = surefoot.load_robot(described.name)
robot.save(sys.argv[1])
twin = surefoot.Robot.load(sys.argv[1])
assert (twin.mass, twin.config.friction) == (robot.mass, 0.65)
try:
    config = twin.config
    config.friction = 2.5
    surefoot.Robot.from_serialized_model(twin.serialized_model(), config)
except surefoot.Error as problem:
    assert "got 2.5" in str(problem), problem
"""
STAND = """
from surefoot.stand import StandSettings, run_stand
log = run_stand(StandSettings("go1", 0.2))
assert not log.fell
print(repr(float(log.q_true[-1, 2])))
"""


@pytest.fixture
def comma(tmp_path: Path) -> dict[str, str]:
    """Return the environment of a process that finds the locale `comma`."""
    (tmp_path / "comma.src").write_text(SOURCE)
    subprocess.run(
        ["localedef", "-c", "-i", tmp_path / "comma.src", tmp_path / "comma"],
        check=False,  # it warns of missing categories by its status
        capture_output=True,
    )
    assert (tmp_path / "comma" / "LC_NUMERIC").is_file()
    return {**os.environ, "LOCPATH": str(tmp_path)}


def run(code: str, environment: dict[str, str], *arguments: str) -> str:
    command = [sys.executable, "-c", code, *arguments]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def test_robot_file_written_under_a_comma_locale_is_the_same(
    comma: dict[str, str], tmp_path: Path
) -> None:
    run(ROUND_TRIP, comma, str(tmp_path / "comma.robot"))
    surefoot.load_robot("go1").save(str(tmp_path / "point.robot"))
    written = (tmp_path / "comma.robot").read_bytes()
    assert written == (tmp_path / "point.robot").read_bytes()


def test_simulated_robot_is_the_same_under_a_comma_locale(comma: dict[str, str]) -> None:
    change = 'import locale; locale.setlocale(locale.LC_ALL, "comma")'
    assert run(change + STAND, comma) == run(STAND, comma)
