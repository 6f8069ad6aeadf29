"""Journal file of trials, from which an interrupted search resumes."""

from __future__ import annotations

import fcntl
import json
import logging
import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import optuna
from optuna.storages import BaseStorage, InMemoryStorage, JournalStorage
from optuna.storages.journal import JournalFileBackend, JournalFileOpenLock
from optuna.trial import TrialState

from surefoot._core import Error
from surefoot.tune.search.settings import SearchSettings

STUDY = "surefoot"
SEARCH = "search"  # user attribute of the study: SearchSettings.identity()
START = "start"  # user attribute of the trial with the start gains


@contextmanager
def open_trial_journal(path: str | None) -> Iterator[BaseStorage]:
    """Yield the storage of a journal file. None: yield a storage in memory.

    A lock permits only one search per file. A search runs the unfinished trials in its file again,
    and these must not belong to a search that still runs.

    Raises:
        Error: The file is not a journal, or another search uses it.
        OSError: The file cannot be opened.
    """
    logging.getLogger("optuna").setLevel(logging.ERROR)
    if path is None:
        yield InMemoryStorage()
        return
    with Path(path).open("ab") as handle:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Error(f"store '{path}': another search uses it; choose another --store") from None
        yield _open_journal(path)


def _open_journal(path: str) -> BaseStorage:
    _repair_last_line(Path(path))
    Path(f"{path}.lock").unlink(missing_ok=True)  # lock of a search that was killed
    try:
        storage = JournalStorage(JournalFileBackend(path, lock_obj=JournalFileOpenLock(path)))
    except (AssertionError, KeyError, TypeError, ValueError) as problem:
        raise Error(f"store '{path}': not a journal of trials ({problem})") from None
    return storage


def _repair_last_line(path: Path) -> None:
    """Complete or remove the last line of a killed search; raise Error if a line is invalid."""
    content = path.read_bytes()
    whole, _, end = content.rpartition(b"\n")
    for number, line in enumerate(whole.splitlines(), 1):
        if not _is_entry(line):
            raise Error(
                f"store '{path}': line {number} is not a journal entry; corrupt, or another file? "
                "choose another --store"
            )
    if not end:
        return
    if not whole and not _is_entry(end):
        raise Error(
            f"store '{path}': line 1 is not a journal entry; corrupt, or another file? "
            "choose another --store"
        )
    with path.open("r+b") as handle:
        if _is_entry(end):
            handle.seek(0, 2)
            handle.write(b"\n")
        else:
            handle.truncate(len(whole) + 1)


def _is_entry(line: bytes) -> bool:
    try:
        entry = json.loads(line)
    except ValueError:
        return False
    return isinstance(entry, dict) and "op_code" in entry


def open_or_create_study(storage: BaseStorage, settings: SearchSettings) -> optuna.Study:
    """Load the study of a store, or create it if the store is empty.

    Raises:
        Error: The store does not belong to a search, or to a search with other settings.
    """
    path, search = settings.store, settings.identity()
    stored = storage.get_all_studies()
    if not stored:
        _check_empty(path)
        directions = [optuna.study.StudyDirection.MINIMIZE] * len(settings.objectives)
        study = optuna.create_study(storage=storage, study_name=STUDY, directions=directions)
        study.set_user_attr(SEARCH, search)
        return study
    if [one.study_name for one in stored] != [STUDY] or SEARCH not in stored[0].user_attrs:
        names = ", ".join(one.study_name for one in stored)
        raise Error(f"store '{path}': holds {names}, expected a search of surefoot tune search")
    _check_same_search(path, stored[0].user_attrs[SEARCH], search)
    study = optuna.load_study(study_name=STUDY, storage=storage)
    for trial in study.get_trials(deepcopy=False, states=(TrialState.COMPLETE,)):
        values = trial.values or [math.nan]
        if not all(isinstance(v, float | int) and math.isfinite(v) for v in values):
            raise Error(
                f"store '{path}': trial {trial.number}: got costs {values}, expected numbers"
            )
    return study


def _check_empty(path: str | None) -> None:
    if path is not None and Path(path).stat().st_size > 0:
        raise Error(
            f"store '{path}': its beginning is missing; corrupt, or another file? "
            "choose another --store"
        )


def _check_same_search(path: str | None, stored: dict[str, Any], search: dict[str, Any]) -> None:
    if stored != search:
        names = [name for name in search if stored.get(name) != search[name]]
        raise Error(
            f"store '{path}': holds another search, which differs in {', '.join(names) or 'all'}; "
            "use another file, or the arguments that the store was begun with"
        )


def requeue_interrupted_trials(study: optuna.Study) -> None:
    """Mark the unfinished trials of a killed search as failed, and queue them again."""
    for trial in study.get_trials(deepcopy=False, states=(TrialState.RUNNING,)):
        # A queued trial has all its values in fixed_params, but possibly not yet in params.
        values = trial.system_attrs.get("fixed_params", trial.params)
        study.enqueue_trial(values, user_attrs=trial.user_attrs)
        study.tell(trial.number, state=TrialState.FAIL)
