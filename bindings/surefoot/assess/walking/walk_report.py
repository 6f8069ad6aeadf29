"""HTML report of an assessment of walking: tables and summary.json."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any

from surefoot.assess.report_tables import table_html
from surefoot.assess.walking.walk_tables import walk_tables
from surefoot.reports.page import page_html
from surefoot.reports.report_folder import write_figures


def write_walk_report(card: dict[str, Any], folder: Path, command: str) -> Path:
    """Write the report into a folder and return the path of its page.

    Args:
        card: Scorecard that run_assess() returned.
        folder: Target folder; created if missing.
        command: Command line that started the run; the page shows it.

    Raises:
        OSError: A file cannot be written.
    """
    write_figures(card, folder)
    parts = [
        f"<h1>{escape(card['robot'])}, {escape(card['controller'])}</h1>",
        f'<p class="soft">{escape(card["card"])} walking scorecard</p>',
        f"<pre>{escape(command)}</pre>",
    ]
    for table in walk_tables(card):
        broken = "; ".join(f"broken: {why}" for why in table.broken)
        rows = [[(cell, "") for cell in row] for row in table.rows]
        parts.append(table_html(table.title, broken, list(table.header), rows))
    page = folder / "index.html"
    page.write_text(page_html(f"{card['robot']} assessed", "\n".join(parts)), encoding="utf-8")
    return page
