"""Report of a run: a folder with a film, plots, summary.json, and an HTML page that shows them."""

from __future__ import annotations

import json
import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from surefoot.reports.plots import draw_plots
from surefoot.stand.film import write_film
from surefoot.stand.plots import PLOTS
from surefoot.stand.report_html import render_page
from surefoot.stand.simulation_loop import Progress
from surefoot.stand.stand_log import StandLog

FILM = "film.webp"


def write_report(
    log: StandLog,
    summary: dict[str, Any],
    folder: Path,
    command: Sequence[str],
    progress: Progress | None = None,
) -> Path:
    """Write the report and return the path of its page.

    Writes index.html, film.webp, the plots and summary.json. If rendering the film fails, the page
    shows the reason instead of the film.

    Args:
        log: Log of the run.
        summary: Result of summarise() for this run.
        folder: Target folder; created if missing.
        command: Words of the command line that started the run; the page shows them.
        progress: Function that is called after every frame of the film.
    """
    folder.mkdir(parents=True, exist_ok=True)
    text = json.dumps(summary, indent=2, allow_nan=False)
    (folder / "summary.json").write_text(text + "\n", encoding="utf-8")
    draw_plots(PLOTS, log, folder)
    film_error = _try_film(log, folder / FILM, progress)
    page = folder / "index.html"
    film = FILM if film_error is None else None
    page.write_text(render_page(summary, shlex.join(command), film, film_error), encoding="utf-8")
    return page


def _try_film(log: StandLog, path: Path, progress: Progress | None) -> str | None:
    """Write the film; return None, or the reason of the failure as text."""
    try:
        write_film(log, path, progress)
    except Exception as problem:
        # Graphics drivers raise errors of many types; the rest of the report must not fail.
        path.unlink(missing_ok=True)
        return f"No film: {type(problem).__name__}: {problem}"
    return None
