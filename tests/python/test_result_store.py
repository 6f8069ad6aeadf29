# SPDX-License-Identifier: BSD-3-Clause
"""The result store of long runs."""

from __future__ import annotations

from pathlib import Path

import pytest
from surefoot import Error
from surefoot.files.result_store import open_result_store


def test_store_returns_its_results_and_repairs_a_truncated_end(tmp_path: Path) -> None:
    path = str(tmp_path / "store")
    with open_result_store(path, "surefoot assess", {"robot": "go1"}) as store:
        store.add("surefoot", "a", {"rows": [1]})
        store.add("surefoot", "b", {"rows": [2]})
    whole = Path(path).read_bytes()
    Path(path).write_bytes(whole[:-4])
    with open_result_store(path, "surefoot assess", {"robot": "go1"}) as store:
        assert store.results == {("surefoot", "a"): {"rows": [1]}}
        store.add("surefoot", "b", {"rows": [2]})
    assert Path(path).read_bytes() == whole


@pytest.mark.parametrize("content", [b"garbage", b"garbage\n", b"a = 1\nb = 2", b'{"key": 1}\n'])
def test_foreign_file_is_refused_and_unchanged(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "store"
    path.write_bytes(content)
    with pytest.raises(Error, match="line 1"), open_result_store(str(path), "surefoot assess", {}):
        pass
    assert path.read_bytes() == content


def test_a_store_of_another_run_or_in_use_is_refused(tmp_path: Path) -> None:
    path = str(tmp_path / "store")
    with open_result_store(path, "surefoot assess", {"robot": "go1", "card": 1}):
        with (
            pytest.raises(Error, match="another run uses it"),
            open_result_store(path, "surefoot assess", {}),
        ):
            pass
    Path(path).write_bytes(Path(path).read_bytes() + b'{"who": "x')
    content = Path(path).read_bytes()
    with pytest.raises(Error, match="differs in robot"):
        with open_result_store(path, "surefoot assess", {"robot": "a1", "card": 1}):
            pass
    assert Path(path).read_bytes() == content


@pytest.mark.parametrize("entry", ['{"who": ["x"], "key": "y", "result": {}}', '{"who": "x"}'])
def test_invalid_store_line_is_named(tmp_path: Path, entry: str) -> None:
    path = tmp_path / "store"
    path.write_text('{"surefoot assess": {}}\n' + entry + "\n")
    with pytest.raises(Error, match="line 2 is not an entry of surefoot assess"):
        with open_result_store(str(path), "surefoot assess", {}):
            pass
