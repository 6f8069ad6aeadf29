"""Recordings as arrays of an NPZ file, which may also contain the columns of a sensor log."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from surefoot._core import Error, LowCmd, LowState
from surefoot.files.tables import write_npz
from surefoot.replay.recording import Call, Recording
from surefoot.sensor_log.column_definitions import REPLAY_PREFIX
from surefoot.sensor_log.file_checks import check_npz_file, printable_path, refusing_corrupt_npz

_LOW_STATES, _COMMANDS, _HEADER = (
    f"{REPLAY_PREFIX}{name}" for name in ("reports", "commands", "head")
)
_FORMAT = 1
_KEYS = {"kind": str, "robot": str, "gains": dict, "options": dict, "build": str, "calls": list}


def recording_columns(recording: Recording) -> dict[str, np.ndarray]:
    """Return the arrays of a recording by name: samples and commands as bytes, the rest as JSON."""
    header = {name: value for name, value in vars(recording).items() if name in _KEYS}
    header["calls"] = [asdict(call) for call in recording.calls]
    return {
        _LOW_STATES: recording.samples,
        _COMMANDS: recording.commands,
        _HEADER: np.array(json.dumps({"format": _FORMAT, **header})),
    }


def write_recording(path: str | Path, recording: Recording) -> None:
    """Write a recording to an NPZ file without other columns.

    Raises:
        OSError: The file cannot be written.
    """
    write_npz(Path(path), recording_columns(recording))


def read_recording(path: str | Path) -> Recording:
    """Read a recording from an NPZ file.

    Raises:
        Error: The file cannot be read, contains no recording, or is corrupt.
    """
    path = Path(path)
    source = printable_path(path)
    if path.suffix.lower() != ".npz":
        raise Error(f"log: got '{source}', expected a .npz file: a CSV lacks the options and calls")
    check_npz_file(path)
    with refusing_corrupt_npz(path), np.load(path, allow_pickle=False) as file:
        missing = [name for name in (_LOW_STATES, _COMMANDS, _HEADER) if name not in file.files]
        if missing:
            raise Error(f"{source}: got no {missing[0]}, expected a log of surefoot stand --log")
        samples, commands, header = (
            file[_LOW_STATES],
            file[_COMMANDS],
            json.loads(str(file[_HEADER])),
        )
    return _check(source, samples, commands, header)


def _check(source: str, samples: np.ndarray, commands: np.ndarray, header: Any) -> Recording:
    """Return the recording that the arrays of a file contain.

    Raises:
        Error: An array or the header has a wrong type, shape or format.
    """
    for name, rows, width in (
        (_LOW_STATES, samples, len(LowState().raw)),
        (_COMMANDS, commands, len(LowCmd().raw)),
    ):
        if rows.dtype != np.uint8 or rows.ndim != 2 or rows.shape[1] != width or not len(rows):
            got = f"{rows.dtype} {rows.shape}"
            raise Error(f"{source}: {name}: got {got}, expected uint8 (rows, {width})")
    if len(samples) != len(commands):
        raise Error(
            f"{source}: got {len(samples)} samples and {len(commands)} commands, expected equal"
        )
    if not isinstance(header, dict) or header.pop("format", None) != _FORMAT:
        raise Error(f"{source}: {_HEADER}: got another format, expected {_FORMAT}")
    if {name: type(value) for name, value in header.items()} != _KEYS:
        raise Error(f"{source}: {_HEADER}: got {sorted(header)}, expected {sorted(_KEYS)}")
    try:
        calls = tuple(Call(**call) for call in header.pop("calls"))
    except TypeError as problem:
        raise Error(f"{source}: {_HEADER}: got an invalid call: {problem}") from None
    return Recording(**header, samples=samples, commands=commands, calls=calls)
