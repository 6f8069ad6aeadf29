"""Parts of report pages: style sheet, tiles, plots and the table of numbers; no script."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping
from html import escape
from typing import Any, Protocol

_CSS = """
:root { color-scheme: light; --ink: #1f252b; --soft: #5b6570; --line: #e1e5ea; --card: #fff; }
* { box-sizing: border-box; }
body { margin: 0; background: #f4f6f8; color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; }
main { max-width: 1040px; margin: 0 auto; padding: 32px 20px 64px; }
h1 { margin: 0; font-size: 30px; letter-spacing: -0.01em; }
h2 { margin: 0 0 4px; font-size: 18px; }
p { margin: 4px 0; } .soft { color: var(--soft); }
.mark { display: inline-block; width: 16px; height: 16px; margin-right: 12px; border-radius: 50%;
  vertical-align: 2px; }
.good { background: #2a9d5c; } .fair { background: #d28414; } .bad { background: #d1342f; }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 12px;
  padding: 20px; margin-top: 20px; }
.top { display: grid; grid-template-columns: 480px 1fr; gap: 20px; margin-top: 20px; }
.top img { width: 100%; border-radius: 12px; border: 1px solid var(--line); display: block; }
.tiles { display: grid; grid-template-columns: 1fr 1fr; gap: 12px; align-content: start; }
.tile { background: var(--card); border: 1px solid var(--line); border-radius: 12px;
  padding: 12px 16px; }
.tile b { display: block; font-size: 22px; font-weight: 600; } .tile span { color: var(--soft);
  font-size: 13px; }
.card img { width: 100%; display: block; margin-top: 8px; }
pre { background: #1f252b; color: #e8edf2; padding: 12px 16px; border-radius: 8px; margin: 12px 0 0;
  white-space: pre-wrap; overflow-wrap: anywhere; font-size: 13px; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 14px; }
th { text-align: left; padding: 18px 8px 6px 0; font-size: 13px; color: var(--soft); }
td { border-top: 1px solid var(--line); padding: 5px 12px 5px 0; vertical-align: top; }
td:nth-child(2) { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
td:nth-child(3) { white-space: nowrap; color: var(--soft); } td:nth-child(4) { color: var(--soft); }
code { font: 13px ui-monospace, "DejaVu Sans Mono", monospace; }
@media (max-width: 820px) { .top { grid-template-columns: 1fr; } }
"""


class FieldEntry(Protocol):
    """One number of a summary."""

    @property
    def name(self) -> str:
        """Key in the summary."""

    @property
    def unit(self) -> str:
        """Unit; "" for words, counts and ratios."""

    @property
    def meaning(self) -> str:
        """Meaning of the number in at most one sentence."""

    @property
    def group(self) -> str:
        """Heading of the part of the table that shows the number."""


class PlotFile(Protocol):
    """One plot of a report."""

    @property
    def file(self) -> str:
        """File name, in the folder of the page."""

    @property
    def title(self) -> str:
        """Heading."""

    @property
    def caption(self) -> str:
        """Description of the plot."""


def page_html(title: str, body: str) -> str:
    """Return a complete HTML page; `title` is plain text, `body` is HTML."""
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Surefoot: {escape(title)}</title>
<style>{_CSS}</style>
</head>
<body><main>
{body}
</main></body>
</html>
"""


def tiles_html(tiles: Iterable[tuple[str, str]]) -> str:
    """Return one tile for each (name, value) as HTML; both texts are HTML."""
    return "".join(
        f'<div class="tile"><b>{value}</b><span>{name}</span></div>' for name, value in tiles
    )


def plots_html(pictures: Iterable[PlotFile]) -> str:
    """Return a section with title, caption and image for each plot."""
    return "\n".join(
        f'<section class="card"><h2>{escape(picture.title)}</h2>'
        f'<p class="soft">{escape(picture.caption)}</p>'
        f'<img src="{picture.file}" alt="{escape(picture.title)}"></section>'
        for picture in pictures
    )


def summary_table_html(fields: Iterable[FieldEntry], summary: Mapping[str, Any]) -> str:
    """Return a section with a table of all fields and a link to summary.json beside the page."""
    parts = []
    for group, entries in itertools.groupby(fields, key=lambda field: field.group):
        parts.append(f'<tr><th colspan="4">{escape(group)}</th></tr>')
        parts += [_row(field, summary[field.name]) for field in entries]
    rows = "\n".join(parts)
    return f"""<section class="card"><h2>Numbers</h2>
<p class="soft">Same values as in <a href="summary.json">summary.json</a>.</p>
<div class="scroll"><table>{rows}</table></div></section>"""


def _row(field: FieldEntry, value: Any) -> str:
    cells = (
        f"<code>{field.name}</code>",
        _value_html(value),
        escape(field.unit),
        escape(field.meaning),
    )
    return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"


def _value_html(value: Any) -> str:
    """Return a value as HTML; dicts and lists get one line per item."""
    if isinstance(value, dict):
        return (
            "<br>".join(f"{escape(name)} {_value_html(part)}" for name, part in value.items())
            or "-"
        )
    if isinstance(value, list):
        return "<br>".join(_value_html(part) for part in value) or "-"
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.4g}" if isinstance(value, float) else escape(str(value))
