"""Filled scorecard of walks as text."""

from __future__ import annotations

from typing import Any

from surefoot.assess.walking.walk_tables import walk_tables


def walk_text(card: dict[str, Any]) -> str:
    """Return a filled scorecard as tables of text."""
    lines = [f"{card['robot']}, controller {card['controller']}, {card['card']} walking scorecard"]
    for table in walk_tables(card):
        columns = list(zip(table.header, *table.rows, strict=True))
        widths = [max(len(cell) for cell in column) for column in columns]
        lines += ["", table.title]
        for row in (table.header, *table.rows):
            cells = (f"{cell:>{width}}" for cell, width in zip(row[1:], widths[1:], strict=True))
            lines.append(f"  {row[0]:<{widths[0]}}  " + "  ".join(cells))
        lines += [f"  broken: {why}" for why in table.broken]
    return "\n".join(lines)
