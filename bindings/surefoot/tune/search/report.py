"""Report of a search: plots, films, summary.json, gains as TOML and an HTML page."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any

from PIL import Image

from surefoot._core import Gains
from surefoot.reports.page import page_html, plots_html, tiles_html
from surefoot.reports.plots import draw_plots
from surefoot.reports.report_folder import write_figures
from surefoot.robot.gain_files import save_gains
from surefoot.sim import Plant
from surefoot.sim.render import Renderer
from surefoot.tune.search.episodes import Episode
from surefoot.tune.search.plots import PlotData, search_plots
from surefoot.tune.search.run import SearchResult
from surefoot.tune.search.summary import gains_provenance, summary_text, term_lines

GAINS = "gains.toml"
# Chosen: several films on a page; 12 frames a second, to keep the file small.
WIDTH, HEIGHT = 400, 300  # [pixels] size of the films
FRAME_PERIOD = 0.08  # [s] time between two frames of a film


def write_report(result: SearchResult, summary: dict[str, Any], folder: Path, command: str) -> Path:
    """Write a report into a folder and return the path of its page; raise OSError on failure.

    Args:
        result: Result of the search.
        summary: Result of summarise().
        folder: Folder of the report, created if missing.
        command: Command that started the search.
    """
    write_figures(summary, folder)
    name = summary["robot"] if isinstance(summary["robot"], str) else None
    save_gains(folder / GAINS, result.best.gains, name, gains_provenance(summary, command))
    episode = result.settings.held_out_episodes[0]
    records, films, film_errors = {}, [], []
    for who, candidate in (("start", result.start), ("own", result.own), ("best", result.best)):
        filmed = folder / f"{who}.webp" if who != "own" else None
        records[who], film_error = _record_episode(episode, candidate.gains, filmed)
        if filmed is not None and film_error is None:
            films.append((who, filmed.name))
        elif film_error is not None:
            film_errors.append(f"No film of {who}: {film_error}")
    draw_plots(search_plots(result), PlotData(result, records), folder)
    page = folder / "index.html"
    page.write_text(_page(result, summary, command, films, film_errors), encoding="utf-8")
    return page


def _record_episode(episode: Episode, gains: Gains, film: Path | None) -> tuple[Any, str | None]:
    """Run an episode and film it if `film` is given.

    Return the record of the episode, and the error text of the film; None: no error.
    """
    plant = episode.plant()
    if film is None:
        return episode.simulate(plant, gains), None
    camera = _Camera(plant)
    record = episode.simulate(plant, gains, camera.on_tick)
    camera.write(film)
    return record, camera.film_error


class _Camera:
    """Camera that records frames of a run. A graphics error ends the film, not the run.

    Attributes:
        film_error: Text of the error that ended the film. None: no error.
    """

    def __init__(self, plant: Plant) -> None:
        self._plant = plant
        self._every = max(1, round(FRAME_PERIOD * plant.settings.control_rate))
        self._renderer: Renderer | None = None
        self._pictures: list[Image.Image] = []
        self.film_error: str | None = None

    def on_tick(self, tick: int) -> None:
        """Record a frame every FRAME_PERIOD."""
        if self.film_error is not None or tick % self._every:
            return
        try:
            self._renderer = self._renderer or Renderer(self._plant, WIDTH, HEIGHT)
            self._pictures.append(Image.fromarray(self._renderer.frame()))
        except Exception as problem:
            self.film_error = f"{type(problem).__name__}: {problem}"

    def write(self, film: Path) -> None:
        """Write the recorded frames as a film; raise OSError if writing fails."""
        if self._renderer is not None:
            self._renderer.close()
        if self._pictures and self.film_error is None:
            first, *rest = self._pictures
            period = round(1000.0 * FRAME_PERIOD)
            first.save(film, save_all=True, append_images=rest, duration=period, loop=0, quality=70)


def _page(
    result: SearchResult,
    summary: dict[str, Any],
    command: str,
    films: list[tuple[str, str]],
    film_errors: list[str],
) -> str:
    held = "_on_held_seeds"
    shown = {who: summary[who + held] for who in ("start", "own", "best")}
    tiles = [
        (f"cost on held-out seeds, {who}", escape(str(_rounded(cost))))
        for who, cost in shown.items()
    ]
    tiles += [("trials", str(summary["trials"])), ("trials with a fall", str(summary["failures"]))]
    pictures = "".join(
        f'<div class="tile"><img src="{file}" alt="{who}" width="{WIDTH}"><span>{who}</span></div>'
        for who, file in films
    )
    terms = "".join(f"<p><code>{escape(line)}</code></p>" for line in term_lines(result))
    body = f"""<h1>Search for gains: {escape(str(summary["robot"]))}</h1>
<pre>{escape(command)}</pre>
<pre>{escape(summary_text(summary))}</pre>
<div class="tiles" style="margin-top: 20px">{tiles_html(tiles)}</div>
<div class="tiles" style="margin-top: 20px">{pictures}</div>
{"".join(f"<p>{escape(film_error)}</p>" for film_error in film_errors)}
{plots_html(search_plots(result))}
<section class="card"><h2>Cost terms of the best gains on held-out seeds</h2>{terms}</section>
<section class="card"><h2>Gains</h2><p><a href="{GAINS}">{GAINS}</a>, for --gains;
numbers in <a href="summary.json">summary.json</a>.</p></section>"""
    return page_html("search for gains", body)


def _rounded(cost: float | list[float]) -> float | list[float]:
    return [round(c, 2) for c in cost] if isinstance(cost, list) else round(cost, 2)
