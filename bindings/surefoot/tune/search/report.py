"""The report of a search: pictures, films, numbers, the gains as TOML, a page that shows them."""

from __future__ import annotations

import json
from html import escape
from pathlib import Path
from typing import Any

from PIL import Image

from surefoot._core import Gains, StandController
from surefoot.gain_files import gains_text
from surefoot.report_axes import draw_plots
from surefoot.report_page import page_html, pictures_html, tiles_html
from surefoot.sim.render import Renderer
from surefoot.tune.search.episodes import LENGTH, Episode
from surefoot.tune.search.plots import Drawn, plots_of
from surefoot.tune.search.run import SearchResult
from surefoot.tune.search.summary import origin, summary_text, term_lines
from surefoot.tune.trace import Trace

GAINS = "gains.toml"
WIDTH, HEIGHT = 400, 300
PICTURE = 0.08  # [s] between pictures


def write_report(result: SearchResult, summary: dict[str, Any], folder: Path, command: str) -> Path:
    """Write a report into a folder and return the page to open; raises OSError.

    Args:
        result: The search.
        summary: What summarise() made of it.
        folder: Made if it is not there.
        command: What started the search.
    """
    folder.mkdir(parents=True, exist_ok=True)
    text = json.dumps(summary, indent=2, allow_nan=False)
    (folder / "summary.json").write_text(text + "\n", encoding="utf-8")
    name = summary["robot"] if isinstance(summary["robot"], str) else None
    gains = gains_text(result.best.gains, name, origin(summary, command))
    (folder / GAINS).write_text(gains, encoding="utf-8")
    episode = result.settings.held_out_episodes[0]
    traces, films = {}, []
    for who, candidate in (("start", result.start), ("own", result.own), ("best", result.best)):
        filmed = folder / f"{who}.webp" if who != "own" else None
        traces[who], trouble = _play(episode, candidate.gains, filmed)
        if filmed is not None and trouble is None:
            films.append((who, filmed.name))
    plots = plots_of(result)
    draw_plots(plots, Drawn(result, traces), folder)
    page = folder / "index.html"
    page.write_text(_page(result, summary, command, films, plots), encoding="utf-8")
    return page


def _play(episode: Episode, gains: Gains, film: Path | None) -> tuple[Trace, str | None]:
    """Run an episode, and film it; return its trace, and why there is no film."""
    plant = episode.plant()
    ticks = round(LENGTH * plant.settings.control_rate)
    trace = Trace(plant, ticks)
    controller = StandController(plant.robot, gains)
    state = plant.reset()
    every = max(1, round(PICTURE * plant.settings.control_rate))
    renderer, trouble, pictures = None, None, []
    for k in range(ticks):
        state = plant.step(controller.update(state))
        trace.record()
        if film is not None and trouble is None and k % every == 0:
            try:
                renderer = renderer or Renderer(plant, WIDTH, HEIGHT)
                pictures.append(Image.fromarray(renderer.frame()))
            except Exception as problem:  # graphics fail in as many ways as there are drivers
                trouble = f"{type(problem).__name__}: {problem}"
        if trace.fell and k > 0 and film is None:
            break
    if renderer is not None:
        renderer.close()
    if film is not None and pictures and trouble is None:
        first, *rest = pictures
        milliseconds = round(1000.0 * PICTURE)
        first.save(
            film, save_all=True, append_images=rest, duration=milliseconds, loop=0, quality=70
        )
    return trace, trouble


def _page(
    result: SearchResult,
    summary: dict[str, Any],
    command: str,
    films: list[tuple[str, str]],
    plots: list[Any],
) -> str:
    held = "_on_held_seeds"
    shown = {who: summary[who + held] for who in ("start", "own", "best")}
    tiles = [
        (f"cost on other seeds, {who}", escape(str(_rounded(cost)))) for who, cost in shown.items()
    ]
    tiles += [("trials", str(summary["trials"])), ("with a fall", str(summary["failures"]))]
    pictures = "".join(
        f'<div class="tile"><img src="{file}" alt="{who}" width="{WIDTH}"><span>{who}</span></div>'
        for who, file in films
    )
    terms = "".join(f"<p><code>{escape(line)}</code></p>" for line in term_lines(result.best))
    body = f"""<h1>Search for gains: {escape(str(summary["robot"]))}</h1>
<pre>{escape(command)}</pre>
<pre>{escape(summary_text(summary))}</pre>
<div class="tiles" style="margin-top: 20px">{tiles_html(tiles)}</div>
<div class="tiles" style="margin-top: 20px">{pictures}</div>
{pictures_html(plots)}
<section class="card"><h2>What the best costs on other seeds, term by term</h2>{terms}</section>
<section class="card"><h2>Gains</h2><p><a href="{GAINS}">{GAINS}</a>, for --gains;
numbers in <a href="summary.json">summary.json</a>.</p></section>"""
    return page_html("search for gains", body)


def _rounded(cost: float | list[float]) -> float | list[float]:
    return [round(c, 2) for c in cost] if isinstance(cost, list) else round(cost, 2)
