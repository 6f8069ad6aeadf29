"""Tapes as arrays of an NPZ file, by themselves or beside a sensor log's columns."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from surefoot._core import Error, LowCmd, LowState
from surefoot.estimate.columns import REPLAY
from surefoot.estimate.tables import write_npz
from surefoot.npz_damage import DAMAGED_NPZ
from surefoot.replay.tape import Call, Tape

_REPORTS, _COMMANDS, _HEAD = (f"{REPLAY}{name}" for name in ("reports", "commands", "head"))
_FORMAT = 1
_KEYS = {"kind": str, "robot": str, "gains": dict, "options": dict, "build": str, "calls": list}


def tape_columns(tape: Tape) -> dict[str, np.ndarray]:
    """Return a tape as arrays by name: bytes of reports and commands, the rest as JSON."""
    rest = {name: value for name, value in vars(tape).items() if name in _KEYS}
    rest["calls"] = [asdict(call) for call in tape.calls]
    return {
        _REPORTS: tape.reports,
        _COMMANDS: tape.commands,
        _HEAD: np.array(json.dumps({"format": _FORMAT, **rest})),
    }


def write_tape(path: str | Path, tape: Tape) -> None:
    """Write a tape by itself; raises OSError."""
    write_npz(Path(path), tape_columns(tape))


def read_tape(path: str | Path) -> Tape:
    """Read a tape from an NPZ file; raises Error where there is none that is whole."""
    path = Path(path)
    if path.suffix.lower() != ".npz":
        raise Error(f"log: got '{path}', expected a .npz: a CSV has not all that commands need")
    try:
        with np.load(path, allow_pickle=False) as file:
            missing = [name for name in (_REPORTS, _COMMANDS, _HEAD) if name not in file.files]
            if missing:
                raise Error(
                    f"{path}: got no {missing[0]}, expected what surefoot stand --log writes"
                )
            reports, commands, head = file[_REPORTS], file[_COMMANDS], json.loads(str(file[_HEAD]))
    except OSError as problem:
        raise Error(f"log: cannot read '{path}': {problem.strerror or problem}") from None
    except DAMAGED_NPZ as problem:
        raise Error(f"{path}: got no NPZ file of a replay ({problem}), expected one") from None
    return _check(path, reports, commands, head)


def _check(path: Path, reports: np.ndarray, commands: np.ndarray, head: Any) -> Tape:
    """Return the tape of a file's arrays; raises Error."""
    for name, rows, width in (
        (_REPORTS, reports, len(LowState().raw)),
        (_COMMANDS, commands, len(LowCmd().raw)),
    ):
        if rows.dtype != np.uint8 or rows.ndim != 2 or rows.shape[1] != width or not len(rows):
            got = f"{rows.dtype} {rows.shape}"
            raise Error(f"{path}: {name}: got {got}, expected uint8 (rows, {width})")
    if len(reports) != len(commands):
        raise Error(f"{path}: got {len(reports)} reports and {len(commands)} commands")
    if not isinstance(head, dict) or head.pop("format", None) != _FORMAT:
        raise Error(f"{path}: {_HEAD}: got another format, expected {_FORMAT}")
    if {name: type(value) for name, value in head.items()} != _KEYS:
        raise Error(f"{path}: {_HEAD}: got {sorted(head)}, expected {sorted(_KEYS)}")
    try:
        calls = tuple(Call(**call) for call in head.pop("calls"))
    except TypeError as problem:
        raise Error(f"{path}: {_HEAD}: a call is none: {problem}") from None
    return Tape(**head, reports=reports, commands=commands, calls=calls)
