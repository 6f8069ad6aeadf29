"""Report of a walk: a folder with a film, plots, summary.json, and an HTML page."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from surefoot.stand.report import write_folder
from surefoot.stand.simulation_loop import Progress
from surefoot.walk.plots import PLOTS
from surefoot.walk.report_html import render_page
from surefoot.walk.walk_log import WalkLog


def write_report(
    log: WalkLog,
    summary: dict[str, Any],
    folder: Path,
    command: Sequence[str],
    progress: Progress | None = None,
) -> Path:
    """Write the report of a walk and return the path of its page.

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
