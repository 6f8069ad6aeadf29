"""Report of a run: a folder with a film, plots, summary.json, and an HTML page that shows them."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, TypeVar

from surefoot.reports.plots import Plot, draw_plots
from surefoot.reports.report_folder import write_figures
from surefoot.stand.film import write_film
from surefoot.stand.plots import PLOTS
from surefoot.stand.report_html import render_page
from surefoot.stand.simulation_log import SimulationLog
from surefoot.stand.simulation_loop import Progress
from surefoot.stand.stand_log import StandLog

FILM = "film.webp"

Log = TypeVar("Log", bound=SimulationLog)
Page = Callable[[str | None, str | None], str]
"""Function that returns a report's page from the film's file name and the reason for no film."""


def write_report(
    log: StandLog,
    summary: dict[str, Any],
    folder: Path,
    command: Sequence[str],
    progress: Progress | None = None,
) -> Path:
    """Write the report of a stand and return the path of its page.

    Args:
        log: Log of the run.
        summary: Result of summarise() for this run.
        folder: Target folder; created if missing.
        command: Words of the command line that started the run; the page shows them.
        progress: Function that is called after every frame of the film.
    """

    def page(film: str | None, film_error: str | None) -> str:
        return render_page(summary, shlex.join(command), film, film_error)

    return write_folder(log, summary, folder, PLOTS, page, progress)


def write_folder(
    log: Log,
    summary: dict[str, Any],
    folder: Path,
    plots: Iterable[Plot[Log]],
    page: Page,
    progress: Progress | None = None,
) -> Path:
    """Write index.html, film.webp, the plots and summary.json; return the path of the page.

    If rendering the film fails, the page shows the reason instead of the film.

    Args:
        log: Log of the run.
        summary: Summary of this run.
        folder: Target folder; created if missing.
        plots: The plots.
        page: Function that returns the page.
        progress: Function that is called after every frame of the film.
    """
    write_figures(summary, folder)
    draw_plots(plots, log, folder)
    film_error = _try_film(log, folder / FILM, progress)
    path = folder / "index.html"
    path.write_text(page(FILM if film_error is None else None, film_error), encoding="utf-8")
    return path


def _try_film(log: SimulationLog, path: Path, progress: Progress | None) -> str | None:
    """Write the film; return None, or the reason of the failure as text."""
    try:
        write_film(log, path, progress)
    except Exception as problem:
        # Graphics drivers raise errors of many types; the rest of the report must not fail.
        path.unlink(missing_ok=True)
        return f"No film: {type(problem).__name__}: {problem}"
    return None
