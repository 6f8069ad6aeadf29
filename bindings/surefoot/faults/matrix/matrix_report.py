"""HTML report of a fault matrix: table of cells, failed cells, plots, and summary.json."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any

from surefoot.faults.case import MODES
from surefoot.faults.catalogue import ROWS
from surefoot.faults.matrix.matrix_text import by_injection
from surefoot.faults.matrix.plots import PLOTS
from surefoot.reports.page import page_html, plots_html, tiles_html
from surefoot.reports.plots import draw_plots
from surefoot.reports.report_folder import write_figures

_STYLE = """<style>
.matrix td:nth-child(n) { text-align: left; color: var(--ink); white-space: normal; }
.matrix td.pass { color: #2a9d5c; } .matrix td.fail { color: #d1342f; font-weight: 600; }
</style>"""
_HEADER = "".join(f"<td><b>{word}</b></td>" for word in ("injection", "what", "expected", *MODES))


def write_faults_report(result: dict[str, Any], folder: Path, command: str) -> Path:
    """Write the report into a folder and return the path of its page.

    Args:
        result: Result of run_faults().
        folder: Target folder; created if missing.
        command: Command line that started the run; the page shows it.

    Raises:
        OSError: A file cannot be written.
    """
    write_figures(result, folder)
    draw_plots(PLOTS, result, folder)
    page = folder / "index.html"
    page.write_text(_page(result, command), encoding="utf-8")
    return page


def _page(result: dict[str, Any], command: str) -> str:
    total = result["passed"] + result["failed"]
    mark = "bad" if result["failed"] else "good"
    tiles = [
        ("cells passed", f"{result['passed']} of {total}"),
        ("power protection level", str(result["power_level"])),
        ("commands not finite", str(_sum(result, "not_finite"))),
        ("commands that the power protection refused", str(_sum(result, "power_trips"))),
    ]
    failures = "".join(
        f"<p><code>{escape(failure['id'])}</code> {escape(failure['reason'])}</p>"
        for failure in result["failures"]
    )
    body = f"""{_STYLE}<h1><span class="mark {mark}"></span>Faults: {escape(result["robot"])}</h1>
<pre>{escape(command)}</pre>
<div class="tiles" style="margin-top: 20px">{tiles_html(tiles)}</div>
<section class="card"><h2>Failed cells</h2>{failures or "<p>None.</p>"}</section>
<section class="card"><h2>The matrix</h2>
<p class="soft">Each cell has the time of the expected reaction. The tooltip has more; all numbers
are in <a href="summary.json">summary.json</a>.</p>
<div class="scroll"><table class="matrix">{_rows(result)}</table></div></section>
{plots_html(PLOTS)}"""
    return page_html(f"faults of a {result['robot']}", body)


def _rows(result: dict[str, Any]) -> str:
    titles = {row.id: row.fault for row in ROWS}
    parts, row = [], ""
    for cells in by_injection(result["cells"]).values():
        first = next(iter(cells.values()))
        if first["row"] != row:
            row = first["row"]
            parts.append(f'<tr><th colspan="7">{escape(row)}: {escape(titles[row])}</th></tr>')
            parts.append(f"<tr>{_HEADER}</tr>")
        expected = "<br>".join(dict.fromkeys(escape(cell["expected"]) for cell in cells.values()))
        marks = "".join(_cell(cells[mode]) if mode in cells else "<td>-</td>" for mode in MODES)
        words = f"<td>{first['injection']}</td><td>{escape(first['what'])}</td>"
        parts.append(f"<tr>{words}<td>{expected}</td>{marks}</tr>")
    return "\n".join(parts)


def _cell(cell: dict[str, Any]) -> str:
    time = cell.get("reaction_s")
    text = "ok" if cell["verdict"] == "pass" else "FAIL"
    if time is not None:
        text += f"<br>{1e3 * time:.0f} ms"
    title = escape(cell["reason"] or f"ended {cell.get('ended')}", quote=True)
    return f'<td class="{cell["verdict"]}" title="{title}">{text}</td>'


def _sum(result: dict[str, Any], name: str) -> int:
    return sum(cell.get(name, 0) for cell in result["cells"])
