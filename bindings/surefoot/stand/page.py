"""The report's page: one HTML file, no script, pictures beside it."""

from __future__ import annotations

import itertools
from html import escape
from typing import Any

from surefoot.stand.fields import FIELDS, Field
from surefoot.stand.plots import PLOTS
from surefoot.stand.text import conditions, push_line, reached_line, reference_line, verdict

_CSS = """
:root { color-scheme: light; --ink: #1f252b; --soft: #5b6570; --line: #e1e5ea; --card: #fff; }
* { box-sizing: border-box; }
body { margin: 0; background: #f4f6f8; color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; }
main { max-width: 1040px; margin: 0 auto; padding: 32px 20px 64px; }
h1 { margin: 0; font-size: 30px; letter-spacing: -0.01em; }
h2 { margin: 0 0 4px; font-size: 18px; }
p { margin: 4px 0; } .soft { color: var(--soft); }
.mark { display: inline-block; width: 16px; height: 16px; margin-right: 12px; border-radius: 50%;
  vertical-align: 2px; }
.good { background: #2a9d5c; } .fair { background: #d28414; } .bad { background: #d1342f; }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 12px;
  padding: 20px; margin-top: 20px; }
.top { display: grid; grid-template-columns: 480px 1fr; gap: 20px; margin-top: 20px; }
.top img { width: 100%; border-radius: 12px; border: 1px solid var(--line); display: block; }
.tiles { display: grid; grid-template-columns: 1fr 1fr; gap: 12px; align-content: start; }
.tile { background: var(--card); border: 1px solid var(--line); border-radius: 12px;
  padding: 12px 16px; }
.tile b { display: block; font-size: 22px; font-weight: 600; } .tile span { color: var(--soft);
  font-size: 13px; }
.card img { width: 100%; display: block; margin-top: 8px; }
pre { background: #1f252b; color: #e8edf2; padding: 12px 16px; border-radius: 8px; margin: 12px 0 0;
  white-space: pre-wrap; overflow-wrap: anywhere; font-size: 13px; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 14px; }
th { text-align: left; padding: 18px 8px 6px 0; font-size: 13px; color: var(--soft); }
td { border-top: 1px solid var(--line); padding: 5px 12px 5px 0; vertical-align: top; }
td:nth-child(2) { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
td:nth-child(3) { white-space: nowrap; color: var(--soft); } td:nth-child(4) { color: var(--soft); }
code { font: 13px ui-monospace, "DejaVu Sans Mono", monospace; }
@media (max-width: 820px) { .top { grid-template-columns: 1fr; } }
"""


def render_page(
    summary: dict[str, Any], command: str, film: str | None, trouble: str | None = None
) -> str:
    """Return the page as HTML.

    Args:
        summary: What summarise() returned.
        command: What started the run.
        film: Name of the film beside the page; None if there is none.
        trouble: Why not.
    """
    title = escape(verdict(summary))
    pushes = "".join(f"<p>Push: {escape(push_line(push))}</p>" for push in summary["pushes"])
    asked = "".join(f"<p>Asked: {escape(reference_line(r))}</p>" for r in summary["references"])
    if asked:
        asked += f"<p>Reached: {escape(reached_line(summary))}</p>"
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Surefoot: {title}</title>
<style>{_CSS}</style>
</head>
<body><main>
<h1>{_mark(summary)}{title}</h1>
<p class="soft">{escape(conditions(summary))}</p>
{pushes}{asked}
<pre>{escape(command)}</pre>
<div class="top">
{_film(film, trouble)}
<div class="tiles">{_tiles(summary)}</div>
</div>
{_plots()}
<section class="card"><h2>Numbers</h2>
<p class="soft">The same as in <a href="summary.json">summary.json</a>.</p>
<div class="scroll"><table>{_table(summary)}</table></div></section>
</main></body>
</html>
"""


def _mark(s: dict[str, Any]) -> str:
    kind = "bad" if s["fell"] else "good" if s["settled"] else "fair"
    return f'<span class="mark {kind}"></span>'


def _film(film: str | None, trouble: str | None) -> str:
    if film is None:
        return f'<div class="card">{escape(trouble or "No film.")}</div>'
    text = "Film of the run; green arrows are foot forces, red ones pushes"
    return f'<div><img src="{escape(film)}" alt="{text}" title="{text}"></div>'


def _tiles(s: dict[str, Any]) -> str:
    settle = s["settle_time_s"]
    failures = s["qp_failures"]
    tiles = (
        ("settled after the last event", "-" if settle is None else f"{settle:.2f} s"),
        ("greatest tilt", f"{s['max_tilt_deg']:.2f}&deg;"),
        ("height off at the end", f"{s['height_error_mm']:.2f} mm"),
        ("farthest foot", f"{s['max_foot_travel_mm']:.1f} mm"),
        ("peak torque, of its limit", f"{100 * s['peak_torque_ratio']:.0f} %"),
        ("peak power", f"{s['peak_power_w']:.0f} W"),
        ("velocity error, RMS", f"{1000 * s['estimator_velocity_rmse']:.1f} mm/s"),
        ("tick, median and p99", f"{s['tick_us']['p50']:.0f} / {s['tick_us']['p99']:.0f} &micro;s"),
        ("failed ticks", f"{failures} of {s['ticks']}"),
        ("torque mode only", "yes" if s["torque_mode_only"] else "no"),
    )
    return "".join(
        f'<div class="tile"><b>{value}</b><span>{name}</span></div>' for name, value in tiles
    )


def _plots() -> str:
    return "\n".join(
        f'<section class="card"><h2>{escape(plot.title)}</h2>'
        f'<p class="soft">{escape(plot.caption)}</p>'
        f'<img src="{plot.file}" alt="{escape(plot.title)}"></section>'
        for plot in PLOTS
    )


def _table(summary: dict[str, Any]) -> str:
    parts = []
    for group, fields in itertools.groupby(FIELDS, key=lambda field: field.group):
        parts.append(f'<tr><th colspan="4">{escape(group)}</th></tr>')
        parts += [_row(field, summary[field.name]) for field in fields]
    return "\n".join(parts)


def _row(field: Field, value: Any) -> str:
    if field.name == "pushes":  # in full at the top of the page
        value = [f"{push['direction']} {push['impulse_ns']:.2f} N.s" for push in value]
    cells = (f"<code>{field.name}</code>", _shown(value), escape(field.unit), escape(field.meaning))
    return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"


def _shown(value: Any) -> str:
    """Return a value as text; what has parts gets a line for each."""
    if isinstance(value, dict):
        return "<br>".join(f"{escape(name)} {_shown(part)}" for name, part in value.items()) or "-"
    if isinstance(value, list):
        return "<br>".join(_shown(part) for part in value) or "-"
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.4g}" if isinstance(value, float) else escape(str(value))
