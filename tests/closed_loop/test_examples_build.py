# SPDX-License-Identifier: BSD-3-Clause
"""The C++ examples build and run.

This test runs in parallel with others, so that the real-time tests, which run alone, find the
examples built. It is one test, because two processes must not build in one folder.
"""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from example_builds import EXAMPLES, build_examples

pytestmark = pytest.mark.build


def output_of(program: Path) -> str:
    return subprocess.run(
        [program, program.with_name("go1.robot")],
        check=True,
        capture_output=True,
        text=True,
        timeout=120,
    ).stdout


def test_every_example_builds_and_those_that_need_no_robot_run() -> None:
    folder = build_examples()
    names = {path.stem for path in EXAMPLES.glob("*.cpp")}
    assert len(names) >= 4
    assert {name for name in names if (folder / name).is_file()} == names
    assert output_of(folder / "stand").startswith("ok:")
    assert output_of(folder / "custom_task") == "camera at 0.080 m, desired 0.080 m\n"
