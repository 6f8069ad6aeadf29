"""The report: a folder with a film, plots, the numbers, and a page that shows them."""

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
    """Write a report and return the page to open.

    Writes index.html, film.webp, the plots and summary.json.

    Args:
        log: The run.
        summary: What summarise() made of it.
        folder: Made if it is not there.
        command: The words that started the run, shown on the page.
        progress: Told how the film is coming on.
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
    """Make the film; return why not, if it cannot be made."""
    try:
        write_film(log, path, progress)
    except Exception as problem:
        # Graphics stacks fail in as many ways as there are drivers; the rest of the report stands.
        path.unlink(missing_ok=True)
        return f"No film: {type(problem).__name__}: {problem}"
    return None
