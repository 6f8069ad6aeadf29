# SPDX-License-Identifier: BSD-3-Clause
"""Retired words of docs/words.txt do not come back."""

from __future__ import annotations

import re
import subprocess
from fnmatch import fnmatch
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LIST = ROOT / "docs" / "words.txt"
UNCHECKED = {"CHANGELOG.md", "docs/words.txt", "docs/glossary.md"}  # they name retired words

Rule = tuple[re.Pattern[str], list[str]]


def read_rules(text: str) -> list[Rule]:
    """Return every pattern with the files in which it is allowed."""
    lines = [line.split() for line in text.splitlines() if line.strip() and line[0] != "#"]
    return [(re.compile(pattern, re.IGNORECASE), allowed) for pattern, *allowed in lines]


def retired_words(path: str, text: str, rules: list[Rule]) -> list[str]:
    """Return a line for every retired word in a file's path or text."""
    found = []
    for pattern, allowed in rules:
        if any(fnmatch(path, place) for place in allowed):
            continue
        if pattern.search(path):
            found.append(f"{path}: the name has '{pattern.pattern}'")
        for number, line in enumerate(text.splitlines(), 1):
            if match := pattern.search(line):
                found.append(f"{path}:{number}: '{match[0]}' is retired, see docs/glossary.md")
    return found


def tracked_files() -> list[str]:
    """Return every text file that git tracks, or will track."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    try:
        listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    except (FileNotFoundError, subprocess.CalledProcessError):
        pytest.skip("not a git checkout: the list of files is unknown")
    binary = (".webp", ".png", ".npz")
    return [name for name in listed.stdout.splitlines() if not name.endswith(binary)]


def test_no_file_has_a_retired_word() -> None:
    rules = read_rules(LIST.read_text())
    found = []
    for name in tracked_files():
        if name not in UNCHECKED and (ROOT / name).is_file():
            found += retired_words(name, (ROOT / name).read_text(), rules)
    assert found == []


def test_every_allowed_place_still_has_its_word() -> None:
    files = tracked_files()
    for pattern, allowed in read_rules(LIST.read_text()):
        for place in allowed:
            names = [name for name in files if fnmatch(name, place)]
            texts = (f"{name}\n{(ROOT / name).read_text()}" for name in names)
            assert any(pattern.search(text) for text in texts), f"{pattern.pattern}: {place}"


@pytest.mark.parametrize("word", ["flung_legs", "the command ladder", "a Crew of two", "anew"])
def test_a_retired_word_is_found(word: str) -> None:
    rules = read_rules(LIST.read_text())
    assert retired_words("controller/src/file.cpp", f"// {word}\n", rules)
    assert retired_words(f"controller/src/{word}.cpp", "", rules)
