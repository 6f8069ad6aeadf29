# SPDX-License-Identifier: BSD-3-Clause
"""The store of long runs."""

from __future__ import annotations

from pathlib import Path

import pytest
from surefoot import Error
from surefoot.store import open_store


def test_a_store_gives_back_what_was_put_in_and_mends_its_end(tmp_path: Path) -> None:
    path = str(tmp_path / "store")
    with open_store(path, "surefoot assess", {"robot": "go1"}) as store:
        store.add("surefoot", "a", {"rows": [1]})
        store.add("surefoot", "b", {"rows": [2]})
    whole = Path(path).read_bytes()
    Path(path).write_bytes(whole[:-4])
    with open_store(path, "surefoot assess", {"robot": "go1"}) as store:
        assert store.results == {("surefoot", "a"): {"rows": [1]}}
        store.add("surefoot", "b", {"rows": [2]})
    assert Path(path).read_bytes() == whole


@pytest.mark.parametrize("content", [b"garbage", b"garbage\n", b"a = 1\nb = 2", b'{"key": 1}\n'])
def test_a_store_that_is_something_else_is_left_alone(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "store"
    path.write_bytes(content)
    with pytest.raises(Error, match="line 1"), open_store(str(path), "surefoot assess", {}):
        pass
    assert path.read_bytes() == content


def test_a_store_of_another_run_or_in_use_is_refused(tmp_path: Path) -> None:
    path = str(tmp_path / "store")
    with open_store(path, "surefoot assess", {"robot": "go1", "card": 1}):
        with pytest.raises(Error, match="at work in it"), open_store(path, "surefoot assess", {}):
            pass
    Path(path).write_bytes(Path(path).read_bytes() + b'{"who": "x')
    content = Path(path).read_bytes()
    with pytest.raises(Error, match="differs in robot"):
        with open_store(path, "surefoot assess", {"robot": "a1", "card": 1}):
            pass
    assert Path(path).read_bytes() == content


@pytest.mark.parametrize("entry", ['{"who": ["x"], "key": "y", "result": {}}', '{"who": "x"}'])
def test_a_line_that_is_no_entry_is_named(tmp_path: Path, entry: str) -> None:
    path = tmp_path / "store"
    path.write_text('{"surefoot assess": {}}\n' + entry + "\n")
    with pytest.raises(Error, match="line 2 is no entry of surefoot assess"):
        with open_store(str(path), "surefoot assess", {}):
            pass
