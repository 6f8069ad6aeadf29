"""Report of a design: plots, summary.json and an HTML page."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

from surefoot.reports.page import page_html, plots_html
from surefoot.reports.plots import draw_plots
from surefoot.reports.report_folder import write_figures
from surefoot.tune.design.gain_design import Design
from surefoot.tune.design.plots import PLOTS
from surefoot.tune.design.text import design_text


def write_report(
    design: Design, summary: dict[str, Any], folder: Path, words: Sequence[str]
) -> Path:
    """Write index.html, its plots and summary.json; return the path of index.html.

    Args:
        design: The design.
        summary: Result of design_summary().
        folder: Folder of the report, created if missing.
        words: Arguments of the command surefoot, shown on the page.
    """
    write_figures(summary, folder)
    draw_plots(PLOTS, design, folder)
    page = folder / "index.html"
    page.write_text(_page(design, shlex.join(["surefoot", *words])), encoding="utf-8")
    return page


def _page(design: Design, command: str) -> str:
    title = f"{design.body.robot.name}: gains by design"
    kind = "fair" if design.warnings else "good"
    body = f"""<h1><span class="mark {kind}"></span>{escape(title)}</h1>
<pre>{escape(command)}</pre>
<section class="card"><h2>Gains and margins</h2>
<p class="soft">Factors on kp and kd, and additional delay, up to which the loop is stable: at rest
without joint friction, and after a push with it. Same values as in
<a href="summary.json">summary.json</a>.</p><pre>{escape(design_text(design))}</pre></section>
{plots_html(PLOTS)}"""
    return page_html(title, body)
