"""Report of a benchmark: a folder with plots, bench.json and an HTML page."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from html import escape
from pathlib import Path

import numpy as np
from matplotlib import style
from matplotlib.figure import Figure

from surefoot.bench.result_text import bench_text
from surefoot.bench.run import WHOLE_CALLS, Bench
from surefoot.reports.plots import BLUE, GREY, ORANGE, STYLE
from surefoot.reports.report_folder import write_figures

_COLOURS = dict(zip(WHOLE_CALLS, (BLUE, ORANGE, GREY), strict=True))
_PAGE = """<!doctype html><meta charset="utf-8"><title>{title}</title>
<style>body {{ font: 15px/1.5 system-ui, sans-serif; max-width: 1100px; margin: 24px auto;
padding: 0 16px; color: #1f252b }} img {{ width: 100% }} pre {{ overflow-x: auto; 
background: #f4f6f8; padding: 12px; font-size: 12px }}</style>
<h1>{title}</h1><p><code>{command}</code></p><pre>{text}</pre>{pictures}
"""


def write_bench_report(bench: Bench, folder: Path, command: Sequence[str]) -> Path:
    """Write index.html, one plot per scenario and bench.json; return the path of index.html."""
    write_figures(bench.figures, folder, "bench.json")
    pictures = []
    for scenario in bench.series:
        name = f"{scenario}.png"
        _draw(bench, scenario).savefig(folder / name, dpi=110)
        pictures.append(f'<h2>{escape(scenario)}</h2><img src="{escape(name)}" alt="">')
    page = folder / "index.html"
    html = _PAGE.format(
        title=escape(f"{bench.figures['robot']}: tick time"),
        command=escape(shlex.join(command)),
        text=escape(bench_text(bench.figures)),
        pictures="".join(pictures),
    )
    page.write_text(html, encoding="utf-8")
    return page


def _draw(bench: Bench, scenario: str) -> Figure:
    with style.context(STYLE):
        figure = Figure(figsize=(11, 3.6), layout="constrained")
        counts, tail, parts = figure.subplots(1, 3)
        series = bench.series[scenario]
        longest = max(float(np.percentile(series[name].wall, 99.0)) for name in WHOLE_CALLS)
        for name in WHOLE_CALLS:
            wall = np.sort(series[name].wall)
            counts.hist(wall, bins=100, range=(0, longest), histtype="step", color=_COLOURS[name])
            above = 1.0 - np.arange(len(wall)) / len(wall)
            tail.plot(wall, above, color=_COLOURS[name], label=name)
        counts.set(
            xlabel="wall time [us]", ylabel="calls", title="histogram, to the 99th percentile"
        )
        tail.set(xscale="log", yscale="log", xlabel="wall time [us]", title="share of calls above")
        tail.legend()
        stages = bench.figures["scenarios"][scenario]["stages_wall_us"]
        names = list(stages)[::-1]
        parts.barh(names, [stages[name]["p50"] for name in names], color=BLUE)
        parts.set(xlabel="median [us]", title="stages")
    return figure
