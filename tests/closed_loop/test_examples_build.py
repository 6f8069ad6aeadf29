# SPDX-License-Identifier: BSD-3-Clause
"""The C++ examples build: not alone, so that what runs them alone does not wait for it."""

from __future__ import annotations

from example_builds import EXAMPLES, built


def test_every_example_builds() -> None:
    folder = built()
    names = {path.stem for path in EXAMPLES.glob("*.cpp")}
    assert len(names) >= 4
    assert {name for name in names if (folder / name).is_file()} == names
