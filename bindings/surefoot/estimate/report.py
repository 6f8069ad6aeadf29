"""Report of an estimate: a folder with plots, the summary and an HTML page."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from surefoot.estimate.estimate_result import Estimate
from surefoot.estimate.plots import PLOTS
from surefoot.estimate.report_html import render_page
from surefoot.reports.plots import draw_plots
from surefoot.reports.report_folder import write_figures


def write_report(
    estimate: Estimate,
    summary: dict[str, Any],
    folder: str | Path,
    command: Sequence[str] = (),
) -> Path:
    """Write index.html, the plots and summary.json; return the path of index.html.

    Args:
        estimate: Result of run_estimator().
        summary: Result of summarise(estimate).
        folder: Folder of the report; made if it does not exist.
        command: Arguments of the command that made the report, shown on the page.

    Raises:
        OSError: The folder or a file cannot be written.
    """
    folder = Path(folder)
    write_figures(summary, folder)
    draw_plots(PLOTS, estimate, folder)
    page = folder / "index.html"
    page.write_text(render_page(summary, shlex.join(command)), encoding="utf-8")
    return page
