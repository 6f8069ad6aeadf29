"""Store of the partial results of a long run, from which an interrupted run resumes."""

from __future__ import annotations

import fcntl
import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

from surefoot._core import Error


class ResultStore:
    """Results by name and key, kept in a file of JSON lines. Its first line identifies the run.

    Attributes:
        results: The results so far, by (name, key).
    """

    def __init__(self, handle: IO[bytes] | None, results: dict[tuple[str, str], Any]) -> None:
        self._handle, self.results = handle, results

    def add(self, name: str, key: str, result: dict[str, Any]) -> None:
        """Keep a result, and flush its line to the operating system."""
        self.results[name, key] = result
        if self._handle is not None:
            line = json.dumps({"who": name, "key": key, "result": result}, allow_nan=False)
            self._handle.write(line.encode() + b"\n")
            self._handle.flush()


@contextmanager
def open_result_store(
    path: str | None, kind: str, run_identity: dict[str, Any]
) -> Iterator[ResultStore]:
    """Yield an open store with the results so far.

    Args:
        path: The file, created if missing. None: the store keeps results in memory only.
        kind: Command that makes the results.
        run_identity: Settings of the run. A run resumes only from a store with equal settings.

    Raises:
        Error: The file is not a store, belongs to a run with other settings, or is in use by
            another process.
        OSError: The file cannot be written.
    """
    if path is None:
        yield ResultStore(None, {})
        return
    with Path(path).open("a+b") as handle:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Error(f"store '{path}': another run uses it; choose another --store") from None
        entries, end = _read_entries(path, kind, handle)
        if entries:
            _check_same_run(path, entries[0][kind], run_identity)
        # Cut off the incomplete last line that a killed run may have left.
        handle.truncate(end)
        handle.seek(0, 2)
        if not entries:
            handle.write(json.dumps({kind: run_identity}).encode() + b"\n")
            handle.flush()
        yield ResultStore(handle, {(e["who"], e["key"]): e["result"] for e in entries[1:]})


def _read_entries(path: str, kind: str, handle: IO[bytes]) -> tuple[list[dict[str, Any]], int]:
    """Return the entries of all complete lines, and the offset [bytes] after the last of them."""
    handle.seek(0)
    content = handle.read()
    whole, newline, rest = content.rpartition(b"\n")
    run_identity = json.dumps({kind: 0})[:-2].encode()
    if not newline and not (rest.startswith(run_identity) or run_identity.startswith(rest)):
        raise Error(f"store '{path}': line 1 is not an entry of {kind}; choose another --store")
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
        raise Error(
            f"store '{path}': line {number} is not an entry of {kind}; choose another --store"
        )
    return entry


def _check_same_run(path: str, stored_identity: Any, run_identity: dict[str, Any]) -> None:
    now = json.loads(json.dumps(run_identity))
    if stored_identity == now:
        return
    old = stored_identity if isinstance(stored_identity, dict) else {}
    names = [name for name in now if old.get(name) != now[name]]
    raise Error(
        f"store '{path}': holds another run, which differs in {', '.join(names) or 'all'}; use "
        "another file, or the arguments that the store was begun with"
    )
