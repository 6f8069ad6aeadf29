"""The journal: every trial on disk when it is done, and whose search it is."""

from __future__ import annotations

import fcntl
import json
import logging
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import optuna
from optuna.storages import BaseStorage, InMemoryStorage, JournalStorage
from optuna.storages.journal import JournalFileBackend, JournalFileOpenLock
from optuna.trial import TrialState

from surefoot._core import Error

STUDY = "surefoot"
SEARCH = "search"  # user attribute: what is searched


@contextmanager
def open_store(path: str | None) -> Iterator[BaseStorage]:
    """Open a journal file, or keep trials in memory only; raises Error, OSError.

    One search at a time: trials under way of a search that was killed are run again, so none other
    may be at work in the same file.
    """
    logging.getLogger("optuna").setLevel(logging.ERROR)
    if path is None:
        yield InMemoryStorage()
        return
    lock = Path(f"{path}.in-use")
    with lock.open("w") as handle:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise Error(f"store '{path}': another search is at work in it") from None
        try:
            yield _journal(path)
        finally:
            lock.unlink(missing_ok=True)


def _journal(path: str) -> JournalStorage:
    _check_lines(Path(path))
    backend = JournalFileBackend(path, lock_obj=JournalFileOpenLock(path))
    Path(f"{path}.lock").unlink(missing_ok=True)  # of a search that was killed while it wrote
    try:
        return JournalStorage(backend)
    except (KeyError, TypeError, ValueError) as problem:
        raise Error(f"store '{path}': is no journal of trials ({problem})") from None


def _check_lines(path: Path) -> None:
    """Raise Error at the first line that is no entry; cut off a last one that was not finished."""
    if not path.exists():
        return
    content = path.read_bytes()
    whole = content.rpartition(b"\n")[0] + b"\n" if b"\n" in content else b""
    for number, line in enumerate(whole.splitlines(), 1):
        try:
            entry = json.loads(line)
        except ValueError:
            entry = None
        if not isinstance(entry, dict) or "op_code" not in entry:
            raise Error(f"store '{path}': line {number} is no journal entry; is the file corrupt?")
    if whole != content:
        if not whole:
            raise Error(f"store '{path}': line 1 is no journal entry; is the file corrupt?")
        with path.open("r+b") as handle:
            handle.truncate(len(whole))


def open_study(
    storage: BaseStorage, sampler: Any, objectives: int, search: dict[str, Any], path: str | None
) -> optuna.Study:
    """Open the study of a store, or begin it.

    Args:
        storage: The store.
        sampler: Optuna's.
        objectives: How many, all to be minimised.
        search: What is searched, plain data; a store of another search is refused.
        path: Of the store, for the message.

    Raises:
        Error: The store holds another search.
    """
    study = optuna.create_study(
        storage=storage,
        sampler=sampler,
        study_name=STUDY,
        directions=["minimize"] * objectives,
        load_if_exists=True,
    )
    there = study.user_attrs.get(SEARCH)
    if there is None:
        study.set_user_attr(SEARCH, search)
    elif there != search:
        names = [name for name in search if there.get(name) != search[name]]
        raise Error(
            f"store '{path}': holds another search, which differs in {', '.join(names) or 'all'}; "
            "name another file, or ask for what it was begun with"
        )
    return study


def reclaim(study: optuna.Study) -> int:
    """Give trials up that a killed search left under way, and queue them anew; return how many."""
    left = study.get_trials(deepcopy=False, states=(TrialState.RUNNING,))
    for trial in left:
        study.enqueue_trial(trial.params)
        study.tell(trial.number, state=TrialState.FAIL)
    return len(left)
