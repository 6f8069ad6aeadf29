"""Mutations of the file of a sensor log, for mutate_logs.py: dialects of CSV, NPZ, damage."""

from __future__ import annotations

import codecs
import io
from collections.abc import Callable
from pathlib import Path

import numpy as np
from log_mutations import MutantLog

Random = np.random.Generator


def write_mutant(folder: Path, log: MutantLog, suffix: str, rng: Random) -> Path:
    """Write a log with a mutated file; add the changes to `log`. Return the path."""
    path = folder / f"log.{suffix}"
    data = _csv(log, rng) if suffix == "csv" else _npz(log, rng)
    if rng.random() < 0.2:
        damage = DAMAGES[int(rng.integers(len(DAMAGES)))]
        data = damage(data, rng)
        log.changes.append(f"file {damage.__name__.strip('_')}")
        log.harmless = False
    path.write_bytes(data)
    return path


def csv_lines(log: MutantLog) -> list[str]:
    """Return header and rows of a log as CSV lines."""
    header, parts = [], []
    for name in [*log.columns, *_duplicates(log)]:
        values = log.columns[name]
        width = values.shape[1]
        header += [name] if width == 1 else [f"{name}_{k}" for k in range(width)]
        parts.append(values)
    rows = [[f"{x:.17g}" for x in row] for row in np.hstack(parts)] if parts else []
    for row, place, text in log.cells:
        if row < len(rows) and place < len(rows[row]):
            rows[row][place] = text
    return [",".join(header), *(",".join(row) for row in rows)]


def _duplicates(log: MutantLog) -> list[str]:
    return [name for name in log.duplicates if name in log.columns]


def _csv(log: MutantLog, rng: Random) -> bytes:
    lines = csv_lines(log)
    names = list(DIALECTS)
    for name in rng.choice(names, size=int(rng.integers(0, 3)), replace=False).tolist():
        lines = DIALECTS[name](lines, rng)
        log.changes.append(name)
    separator = str(rng.choice([",", ";", "\t", ";,"]))
    if separator != ",":
        # A cell that holds a comma would become another number of cells.
        log.harmless &= not any("," in text for *_, text in log.cells)
        lines = [line.replace(",", separator[0]) for line in lines]
        if separator == ";,":
            lines = [lines[0], *(line.replace(".", ",") for line in lines[1:])]
        log.changes.append(f"separator '{separator}'")
    return _encoded(lines, log, rng)


def _encoded(lines: list[str], log: MutantLog, rng: Random) -> bytes:
    end = str(rng.choice(["\n", "\r\n", "\r", "mixed"]))
    ends = ["\n", "\r\n", "\r"] if end == "mixed" else [end]
    text = "".join(line + ends[int(rng.integers(len(ends)))] for line in lines)
    encoding = str(rng.choice(["utf-8", "utf-8-sig", "utf-16", "utf-16-be", "latin-1", "utf-32"]))
    log.changes.append(f"{encoding}, line ends {end!r}")
    mark = codecs.BOM_UTF16_BE if encoding == "utf-16-be" else b""
    return mark + text.encode(encoding, "replace")


def _insert(lines: list[str], rng: Random, text: str) -> list[str]:
    place = int(rng.integers(1, len(lines) + 1))
    return [*lines[:place], text, *lines[place:]]


def _quoted(lines: list[str], rng: Random) -> list[str]:
    return ['"' + line.replace(",", '","') + '"' for line in lines]


DIALECTS: dict[str, Callable[[list[str], Random], list[str]]] = {
    "blank second line": lambda lines, rng: [lines[0], "", *lines[1:]],
    "blank line": lambda lines, rng: _insert(lines, rng, " "),
    "repeated header": lambda lines, rng: _insert(lines, rng, lines[0]),
    "comment before the header": lambda lines, rng: ["# recorded by a robot", *lines],
    "commented header": lambda lines, rng: ["#" + lines[0], *lines[1:]],
    "quotes": _quoted,
    "delimiter at the end": lambda lines, rng: [lines[0], *(line + "," for line in lines[1:])],
    "blanks in cells": lambda lines, rng: [line.replace(",", " , ") for line in lines],
}


def _npz(log: MutantLog, rng: Random) -> bytes:
    arrays: dict[str, np.ndarray] = {}
    split, kind = rng.random() < 0.3, str(rng.choice(["f8", ">f8", "g", "fortran"]))
    for name, values in log.columns.items():
        if split and values.shape[1] > 1:
            arrays |= {f"{name}_{k}": values[:, k] for k in range(values.shape[1])}
        else:
            arrays[name] = values if rng.random() < 0.5 or values.shape[1] > 1 else values[:, 0]
    arrays |= {f"{name}[0]": log.columns[name][:, :1] for name in _duplicates(log)}
    log.changes.append(f"arrays {kind}{' split' * split}")
    packed = io.BytesIO()
    for name, values in arrays.items():
        arrays[name] = np.asfortranarray(values) if kind == "fortran" else values.astype(kind)
    if rng.random() < 0.1 and arrays:
        _spoil_array(arrays, log, rng)
    save = np.savez if rng.random() < 0.5 else np.savez_compressed
    save(packed, **arrays)
    return packed.getvalue()


def _spoil_array(arrays: dict[str, np.ndarray], log: MutantLog, rng: Random) -> None:
    name = str(rng.choice(list(arrays)))
    values = arrays[name]
    changed = {
        "transposed": values.T,
        "shortened": values[:-1],
        "of text": values.astype(str),
        "complex": values.astype(complex),
        "0-d": np.array(1.0),
        "3-d": values[..., None, None],
        "structured": np.zeros(len(values), dtype=[("a", "f4")]),
    }
    how = str(rng.choice(list(changed)))
    arrays[name] = changed[how]
    log.changes.append(f"array {name} {how}")
    log.harmless = False


def _cut(data: bytes, rng: Random) -> bytes:
    return data[: int(rng.integers(0, len(data) + 1))]


def _cut_near_end(data: bytes, rng: Random) -> bytes:
    return data[: max(0, len(data) - int(rng.integers(1, 300)))]


def _with_random_bytes(data: bytes, rng: Random) -> bytes:
    changed = bytearray(data)
    for place in rng.integers(0, max(len(data), 1), 3).tolist():
        if place < len(changed):
            changed[place] = int(rng.integers(256))
    return bytes(changed)


def _with_zeros(data: bytes, rng: Random) -> bytes:
    place = int(rng.integers(0, len(data) + 1))
    return data[:place] + bytes(100) + data[place + 100 :]


def _without_a_part(data: bytes, rng: Random) -> bytes:
    start = int(rng.integers(0, len(data) + 1))
    return data[:start] + data[start + int(rng.integers(1, 2000)) :]


DAMAGES = (_cut, _cut_near_end, _with_random_bytes, _with_zeros, _without_a_part)
