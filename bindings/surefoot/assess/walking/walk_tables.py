"""Tables of a filled scorecard of walks, for text and HTML: titles, headers and rows of cells."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from surefoot.assess.scorecard_text import foreign_title
from surefoot.assess.sweep import percent_text


@dataclass(frozen=True)
class Table:
    """A table of text.

    Attributes:
        title: What it shows.
        header: Names of the columns.
        rows: Cells, one tuple per row, as many as columns.
        broken: Reasons for which the controller failed.
    """

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    broken: tuple[str, ...] = ()


_COLUMNS = (
    ("mean error", "velocity_mean_error", 3),
    ("RMSE m/s, rad/s", "velocity_rmse", 3),
    ("roll, pitch deg", "roll_pitch_rms_deg", 2),
    ("slip mm", "slip_mm_per_step", 1),
    ("CoT", "cost_of_transport", 2),
    ("land m g", "touchdown_force_mg", 2),
    ("sat %", "saturated_percent", 1),
)


def walk_tables(card: dict[str, Any]) -> list[Table]:
    """Return the tables: velocities and pushes of each controller, then conditions."""
    tables = []
    sections = {card["controller"]: card["walk"], **card["references"]}
    if card["foreign_plant"] is not None:
        sections[foreign_title(card["foreign_plant"])] = card["foreign_plant"]["walk"]
    for name, section in sections.items():
        rows = [(_velocity(row["velocity"]), row) for row in section["velocities"]]
        tables.append(_walks(f"{name}: worst of the seeds", "velocity", rows))
        tables += [_pushes(name, table) for table in section["pushes"]]
    if card["conditions"]:
        rows = [(row["name"], row) for row in card["conditions"]]
        tables.append(_walks(f"{card['controller']}: conditions", "condition", rows))
    return tables


def _walks(title: str, first: str, rows: list[tuple[str, dict[str, Any]]]) -> Table:
    header = (first, "walked", "stood", *(name for name, _, _ in _COLUMNS))
    cells = tuple(
        (
            name,
            f"{row['walked']} of {row['runs']}",
            str(row["stood_at_end"]),
            *(_number(row[key], digits) for _, key, digits in _COLUMNS),
        )
        for name, row in rows
    )
    return Table(title, header, cells, tuple(sorted({w for _, r in rows for w in r["broken"]})))


def _pushes(name: str, table: dict[str, Any]) -> Table:
    title = (
        f"{name}: pushes of 0.1 s at {_velocity(table['velocity'])}, {table['statistic']}, worst "
        f"direction {percent_text(table['survive_percent_of_lip_p5'])} % of the LIP push limit"
    )
    rows = tuple(
        (
            f"{row['degrees']:.0f}",
            f"{row['lip_ns']:.2f}",
            f"{row['ns']:.2f}",
            percent_text(row["percent_of_lip"]),
        )
        for row in table["directions"]
    )
    broken = tuple(sorted({why for row in table["directions"] for why in row["broken"]}))
    return Table(title, ("deg", "LIP limit N.s", "survived N.s", "% of LIP"), rows, broken)


def _velocity(velocity: list[float]) -> str:
    return ", ".join(f"{v:g}" for v in velocity)


def _number(value: Any, digits: int) -> str:
    if value is None:
        return "-"
    values = value if isinstance(value, list) else [value]
    return " ".join(f"{v:.{digits}f}" for v in values)
