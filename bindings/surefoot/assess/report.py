"""HTML report of an assessment: polar plots, tables, films of failures, and summary.json."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

from surefoot.assess.plots import plots_of
from surefoot.assess.report_tables import conditions_html, faults_html, push_table_html
from surefoot.assess.scorecard_text import foreign_title
from surefoot.assess.sweep import percent_text
from surefoot.reports.page import page_html, plots_html, tiles_html
from surefoot.reports.plots import draw_plots
from surefoot.reports.report_folder import write_figures

_STYLE = """<style>
.rows td:nth-child(n) { text-align: right; color: var(--ink); white-space: nowrap; }
.rows td:first-child { text-align: left; } .rows td.fail { color: #d1342f; font-weight: 600; }
.films { display: grid; grid-template-columns: 1fr 1fr; gap: 20px; }
</style>"""


def write_assess_report(card: dict[str, Any], folder: Path, command: str) -> Path:
    """Write the report into a folder and return the path of its page.

    Args:
        card: Scorecard that run_assess() returned. run_assess() must have written its films into
            `folder`.
        folder: Target folder; created if missing.
        command: Command line that started the run; the page shows it.

    Raises:
        OSError: A file cannot be written.
    """
    write_figures(card, folder)
    plots = plots_of(card)
    draw_plots(plots, card, folder)
    parts = [
        _STYLE,
        f"<h1>{escape(card['robot'])}, {escape(card['controller'])}</h1>",
        f'<p class="soft">{escape(card["card"])} scorecard, '
        f"{escape(card['push']['statistic'])}</p>",
        f"<pre>{escape(command)}</pre>",
        f'<div class="tiles" style="margin-top: 20px">{tiles_html(_tiles(card))}</div>',
        _failures_html(card),
        plots_html(plots),
        *(push_table_html(table, name) for name, table in _tables(card)),
        conditions_html(card),
        faults_html(card),
        _films_html(card["films"]),
    ]
    page = folder / "index.html"
    page.write_text(page_html(f"{card['robot']} assessed", "\n".join(parts)), encoding="utf-8")
    return page


def _tables(card: dict[str, Any]) -> list[tuple[str, dict[str, Any]]]:
    pushes = {card["controller"]: card["push"], **card["references"]}
    foreign = card["foreign_plant"]
    if foreign is not None:
        pushes[foreign_title(foreign)] = foreign["push"]
    return [(name, table) for name, push in pushes.items() for table in push["tables"]]


def _tiles(card: dict[str, Any]) -> list[tuple[str, str]]:
    push, conditions, faults = card["push"], card["conditions"], card["faults"]
    tiles = [
        (
            f"of the push limit {words}, worst direction",
            f"{percent_text(push[f'{kind}_percent_of_limit_p5'])} %",
        )
        for kind, words in (("survive", "survived"), ("strict", "passed in place"))
    ]
    stands = [condition["stand"] for condition in conditions]
    passed = sum(stand["passed"] == stand["runs"] for stand in stands)
    tiles += [("conditions passed", f"{passed} of {len(stands)}")] if stands else []
    if faults is not None:
        tiles.append(
            ("faults passed", f"{faults['passed']} of {faults['passed'] + faults['failed']}")
        )
    return tiles


def _failures_html(card: dict[str, Any]) -> str:
    found = list(card["push"]["broken"])
    for condition in card["conditions"]:
        for section in (condition["stand"], condition["push"]):
            reasons = [] if section is None else section["broken"]
            found += [f"{condition['name']}: {why}" for why in reasons]
    for name, push in card["references"].items():
        found += [f"{name}: {why}" for why in push["broken"]]
    if not found:
        return ""
    lines = "".join(f"<p>{escape(why)}</p>" for why in dict.fromkeys(found))
    return f'<section class="card"><h2>Controller failures</h2>{lines}</section>'


def _films_html(films: Sequence[dict[str, str]]) -> str:
    if not films:
        return ""
    parts = []
    for film in films:
        caption = escape(film["caption"])
        content = (
            f'<img src="{escape(film["film"])}" alt="{caption}">'
            if "film" in film
            else f"<p>{escape(film['broken'])}</p>"
        )
        parts.append(f'<div><p class="soft">{caption}</p>{content}</div>')
    return (
        '<section class="card"><h2>Films of the failures</h2>'
        f'<div class="films">{"".join(parts)}</div></section>'
    )
