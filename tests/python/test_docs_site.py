# SPDX-License-Identifier: BSD-3-Clause
"""The documentation site builds without a warning, and a defect of its sources is named."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.build

ROOT = Path(__file__).parents[2]


def _build(root: Path, output: Path) -> tuple[int, list[str]]:
    command = [sys.executable, str(root / "docs" / "tools" / "build_site.py")]
    done = subprocess.run(
        [*command, "--output", str(output)], capture_output=True, text=True, timeout=600
    )
    return done.returncode, (done.stdout + done.stderr).splitlines()


def test_the_site_builds_and_is_searchable(tmp_path: Path) -> None:
    status, lines = _build(ROOT, tmp_path / "docs")
    assert (status, lines[-1][-10:]) == (0, "0 problems"), "\n".join(lines)
    assert (tmp_path / "docs" / "search.html").is_file()
    index = (tmp_path / "docs" / "index.html").read_text()
    assert "stand.webp" in index
    scripts = [line for line in index.splitlines() if "<script" in line or "<link" in line]
    assert scripts and not any("https://" in line for line in scripts)  # it opens without a network


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of what the site is made of, with a few pages, to be damaged."""
    root = tmp_path_factory.mktemp("copy")
    for entry in ROOT.iterdir():
        if entry.name not in ("docs", "controller", "out") and not entry.name.startswith("."):
            (root / entry.name).symlink_to(entry)
    shutil.copytree(ROOT / "controller", root / "controller")
    shutil.copytree(ROOT / "docs", root / "docs")
    return root


@pytest.mark.parametrize(
    ("file", "old", "new", "named"),
    [
        (
            "controller/include/surefoot/error.hpp",
            "namespace surefoot {",
            "namespace surefoot {\nint undocumented();",
            "Member undocumented()",
        ),
        (
            "docs/tools/python_reference.py",
            '"Errors": "Error"',
            '"Errors": "Error Gone"',
            "no group has, or no name is: {'Gone'}",
        ),
    ],
)
def test_a_defect_is_named_in_one_line(
    copy: Path, file: str, old: str, new: str, named: str
) -> None:
    path = copy / file
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    try:
        status, lines = _build(copy, copy / "out" / "docs")
    finally:
        path.write_text(text)
    assert status == 1 and sum(named in line for line in lines) == 1, "\n".join(lines)


def test_a_broken_link_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    sys.path.insert(0, str(ROOT / "docs" / "tools"))
    import build_site

    docs = tmp_path / "docs"
    docs.mkdir()
    (docs / "conf.py").write_text('extensions = ["myst_parser"]\n')
    (docs / "index.md").write_text("# Page\n\n[there](no-page.md)\n")
    monkeypatch.setattr(build_site, "ROOT", tmp_path)
    (problem,) = build_site.run_sphinx("html", tmp_path / "out" / "docs")
    assert problem.startswith("docs/index.md:3: ") and "no-page" in problem


def test_a_public_name_without_docstring_is_named(tmp_path: Path) -> None:
    sys.path.insert(0, str(ROOT / "docs" / "tools"))
    from build_site import undocumented

    report = (
        "Undocumented Python objects\n====\nsurefoot.sim\n----\nClasses:\n * Plant -- missing\n"
    )
    (tmp_path / "python.txt").write_text(report)
    assert undocumented(tmp_path) == ["surefoot.sim: Plant has no documentation on any page"]
