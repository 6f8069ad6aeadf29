"""Mutations of the columns of a sensor log, for mutate_logs.py."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

Columns = dict[str, np.ndarray]  # arrays (n, width) by name
DEG_PER_RAD = 180.0 / np.pi


@dataclass
class MutantLog:
    """A log that mutations change.

    Attributes:
        columns: Arrays (n, width) by name, in the order of the file.
        cells: Texts that replace numbers: (row, place among all components), text.
        duplicates: Names of columns that the file has twice.
        changes: What was changed, one entry for each mutation.
        harmless: Whether the estimate must be that of the recording.
    """

    columns: Columns
    cells: list[tuple[int, int, str]] = field(default_factory=list)
    duplicates: list[str] = field(default_factory=list)
    changes: list[str] = field(default_factory=list)
    harmless: bool = True

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(next(iter(self.columns.values())))


Mutation = Callable[[MutantLog, np.random.Generator], str]
"""Function that changes a log and returns what it changed."""


def in_leg_order(values: np.ndarray, order: np.ndarray | list[int]) -> np.ndarray:
    """Return columns (n, 12) with the legs in another order (4,)."""
    return values.reshape(-1, 4, 3)[:, order].reshape(-1, 12)


def _name(log: MutantLog, rng: np.random.Generator) -> str:
    return str(rng.choice(list(log.columns)))


def _reorder_columns(log: MutantLog, rng: np.random.Generator) -> str:
    names = list(log.columns)
    rng.shuffle(names)
    log.columns = {name: log.columns[name] for name in names}
    return "columns reordered"


def _add_column(log: MutantLog, rng: np.random.Generator) -> str:
    name = str(rng.choice(["phase", "temperature", "q_desired", "Zustand", "odom.orientation.x"]))
    log.columns[name] = rng.normal(size=(log.rows, 1))
    return f"column {name} added"


def _repeat_rows(log: MutantLog, rng: np.random.Generator) -> str:
    counts = 1 + (rng.random(log.rows) < rng.choice([0.02, 0.5, 1.0])).astype(int)
    log.columns = {name: np.repeat(v, counts, axis=0) for name, v in log.columns.items()}
    return "rows repeated"


def _clock_in_another_unit(log: MutantLog, rng: np.random.Generator) -> str:
    scale = float(rng.choice([1e-3, 1.0, 1e3, 1e6]))
    ticks = log.columns.pop("tick") + float(rng.choice([0.0, 12345.0, 2e8]))
    log.columns["time"] = ticks * scale
    return f"tick replaced by time in ms * {scale:g}"


HARMLESS = (_reorder_columns, _add_column, _repeat_rows, _clock_in_another_unit)


def _drop_column(log: MutantLog, rng: np.random.Generator) -> str:
    name = _name(log, rng)
    del log.columns[name]
    return f"column {name} dropped"


def _drop_component(log: MutantLog, rng: np.random.Generator) -> str:
    name = _name(log, rng)
    log.columns[name] = log.columns[name][:, :-1]
    if log.columns[name].shape[1] == 0:
        del log.columns[name]
    return f"last component of {name} dropped"


def _double_column(log: MutantLog, rng: np.random.Generator) -> str:
    log.duplicates.append(_name(log, rng))
    return f"column {log.duplicates[-1]} doubled"


def _rename_column(log: MutantLog, rng: np.random.Generator) -> str:
    name = _name(log, rng)
    new = str(rng.choice([name.upper(), name[:-1], f"{name}_raw", "x", "", name[::-1], f" {name}"]))
    log.columns = {new if key == name else key: v for key, v in log.columns.items()}
    return f"column {name} renamed to '{new}'"


def _swap_columns(log: MutantLog, rng: np.random.Generator) -> str:
    first, second = _name(log, rng), _name(log, rng)
    log.columns[first], log.columns[second] = log.columns[second], log.columns[first]
    return f"columns {first} and {second} exchanged"


def _reorder_components(log: MutantLog, rng: np.random.Generator) -> str:
    name = _name(log, rng)
    order = rng.permutation(log.columns[name].shape[1])
    log.columns[name] = log.columns[name][:, order]
    return f"components of {name} in the order {order.tolist()}"


def _swap_legs(log: MutantLog, rng: np.random.Generator) -> str:
    order = rng.permutation(4)
    names = [n for n in ("q", "dq", "tauEst") if n in log.columns and rng.random() < 0.8]
    for name in names:
        if log.columns[name].shape[1] == 12:
            log.columns[name] = in_leg_order(log.columns[name], order)
    return f"legs of {', '.join(names)} in the order {order.tolist()}"


def _change_sign(log: MutantLog, rng: np.random.Generator) -> str:
    name = _name(log, rng)
    signs = np.where(rng.random(log.columns[name].shape[1]) < rng.choice([0.3, 1.0]), -1.0, 1.0)
    log.columns[name] = log.columns[name] * signs
    return f"signs of {name} changed by {signs.tolist()}"


def _change_unit(log: MutantLog, rng: np.random.Generator) -> str:
    name = _name(log, rng)
    factor = float(rng.choice([DEG_PER_RAD, 1 / DEG_PER_RAD, 1 / 9.81, 1000.0, 1e-3, 10.0, 0.1]))
    log.columns[name] = log.columns[name] * factor
    return f"{name} multiplied by {factor:g}"


def _remove_gravity(log: MutantLog, rng: np.random.Generator) -> str:
    if "accelerometer" in log.columns and log.rows:
        force = log.columns["accelerometer"]
        log.columns["accelerometer"] = force - np.median(force, axis=0)
    return "gravity removed"


def _set_constant(log: MutantLog, rng: np.random.Generator) -> str:
    name = _name(log, rng)
    value = float(rng.choice([0.0, 1.0, -1.0, np.nan, np.inf, 1e30, 1e300]))
    log.columns[name] = np.full_like(log.columns[name], value)
    return f"{name} set to {value:g}"


def _spoil_cells(log: MutantLog, rng: np.random.Generator) -> str:
    name = _name(log, rng)
    value = float(rng.choice([np.nan, np.inf, -np.inf, 1e30, 1e5, 0.0]))
    values = log.columns[name] = log.columns[name].copy()
    values[rng.random(values.shape) < rng.choice([0.002, 0.1])] = value
    return f"cells of {name} set to {value:g}"


def _shuffle_rows(log: MutantLog, rng: np.random.Generator) -> str:
    rows = np.arange(log.rows)
    kind = str(rng.choice(["shuffled", "reversed", "two exchanged", "rotated"]))
    if kind == "shuffled":
        rng.shuffle(rows)
    elif kind == "reversed":
        rows = rows[::-1]
    elif kind == "rotated":
        rows = np.roll(rows, log.rows // 3)
    else:
        a, b = rng.integers(0, log.rows, 2)
        rows[[a, b]] = rows[[b, a]]
    log.columns = {name: v[rows] for name, v in log.columns.items()}
    return f"rows {kind}"


def _drop_rows(log: MutantLog, rng: np.random.Generator) -> str:
    kept = rng.random(log.rows) < rng.choice([0.0, 0.003, 0.1, 0.9])
    log.columns = {name: v[kept] for name, v in log.columns.items()}
    return f"{int(kept.sum())} rows kept"


def _spoil_clock(log: MutantLog, rng: np.random.Generator) -> str:
    name = "tick" if "tick" in log.columns else "time"
    factor = float(rng.choice([7.0, 0.5, 100.0, 1e-6, 1e9, -1.0]))
    if name in log.columns:
        log.columns[name] = log.columns[name] * factor
    return f"{name} multiplied by {factor:g}"


def _write_text(log: MutantLog, rng: np.random.Generator) -> str:
    texts = ["n/a", "1,5", "0x1F", "1e999", "--", "1_0", "True", "1.2.3", "", "\u00b5", "1 2", "#"]
    text = str(rng.choice(texts))
    width = sum(values.shape[1] for values in log.columns.values())
    log.cells.append((int(rng.integers(max(log.rows, 1))), int(rng.integers(max(width, 1))), text))
    return f"cell {log.cells[-1][:2]} set to '{text}'"


HARMFUL = (
    *(_drop_column, _drop_component, _double_column, _rename_column, _swap_columns),
    *(_reorder_components, _swap_legs, _change_sign, _change_unit, _remove_gravity),
    *(_set_constant, _spoil_cells, _shuffle_rows, _drop_rows, _spoil_clock, _write_text),
)
