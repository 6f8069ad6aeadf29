"""A store: every part of a long run on disk when it is done; one that ended, however, goes on."""

from __future__ import annotations

import fcntl
import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

from surefoot._core import Error


class ResultStore:
    """Results by whose they are and a key; JSON, one a line, the first says of what run.

    Attributes:
        results: What is there already.
    """

    def __init__(self, handle: IO[bytes] | None, results: dict[tuple[str, str], Any]) -> None:
        self._handle, self.results = handle, results

    def add(self, name: str, key: str, result: dict[str, Any]) -> None:
        """Keep a result; it is in the system's hands when this returns."""
        self.results[name, key] = result
        if self._handle is not None:
            line = json.dumps({"who": name, "key": key, "result": result}, allow_nan=False)
            self._handle.write(line.encode() + b"\n")
            self._handle.flush()


@contextmanager
def open_result_store(
    path: str | None, kind: str, run_identity: dict[str, Any]
) -> Iterator[ResultStore]:
    """Open a store, or keep results in memory only.

    Args:
        path: The file; made if it is not there.
        kind: The command whose run it is.
        run_identity: What makes two runs the same.

    Raises:
        Error: The file holds something else, or another run is at work in it.
        OSError: It cannot be written.
    """
    if path is None:
        yield ResultStore(None, {})
        return
    with Path(path).open("a+b") as handle:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Error(f"store '{path}': another run is at work in it") from None
        entries, end = _read_entries(path, kind, handle)
        if entries:
            _check_same_run(path, entries[0][kind], run_identity)
        # It is ours: a last line that a killed run left unfinished is cut off.
        handle.truncate(end)
        handle.seek(0, 2)
        if not entries:
            handle.write(json.dumps({kind: run_identity}).encode() + b"\n")
            handle.flush()
        yield ResultStore(handle, {(e["who"], e["key"]): e["result"] for e in entries[1:]})


def _read_entries(path: str, kind: str, handle: IO[bytes]) -> tuple[list[dict[str, Any]], int]:
    """Return the entries, and where the last whole one ends."""
    handle.seek(0)
    content = handle.read()
    whole, newline, rest = content.rpartition(b"\n")
    run_identity = json.dumps({kind: 0})[:-2].encode()
    if not newline and not (rest.startswith(run_identity) or run_identity.startswith(rest)):
        raise Error(f"store '{path}': line 1 is no entry of {kind}")
    lines = whole.split(b"\n") if newline else []
    entries = [_parse_entry(path, kind, number, line) for number, line in enumerate(lines, 1)]
    return entries, len(content) - len(rest)


def _parse_entry(path: str, kind: str, number: int, line: bytes) -> dict[str, Any]:
    try:
        entry = json.loads(line)
    except ValueError:
        entry = None
    types = {kind: dict} if number == 1 else {"who": str, "key": str, "result": dict}
    if not isinstance(entry, dict) or {k: type(v) for k, v in entry.items()} != types:
        raise Error(f"store '{path}': line {number} is no entry of {kind}")
    return entry


def _check_same_run(path: str, stored_identity: Any, run_identity: dict[str, Any]) -> None:
    now = json.loads(json.dumps(run_identity))
    if stored_identity == now:
        return
    old = stored_identity if isinstance(stored_identity, dict) else {}
    names = [name for name in now if old.get(name) != now[name]]
    raise Error(
        f"store '{path}': holds another run, which differs in {', '.join(names) or 'all'}; name "
        "another file, or ask for what it was begun with"
    )
