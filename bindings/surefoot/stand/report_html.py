"""HTML page of a run's report: one file without scripts; the pictures are files beside it."""

from __future__ import annotations

from html import escape
from typing import Any

from surefoot.reports.page import page_html, plots_html, summary_table_html, tiles_html
from surefoot.stand.plots import PLOTS
from surefoot.stand.summary_fields import FIELDS
from surefoot.stand.summary_text import (
    conditions_line,
    outcome_sentence,
    push_line,
    reached_line,
    reference_line,
)


def render_page(
    summary: dict[str, Any], command: str, film: str | None, film_error: str | None = None
) -> str:
    """Return the page as HTML.

    Args:
        summary: Result of summarise().
        command: Command line that started the run.
        film: File name of the film beside the page; None if there is none.
        film_error: Reason why there is no film.
    """
    title = outcome_sentence(summary)
    pushes = "".join(f"<p>Push: {escape(push_line(push))}</p>" for push in summary["pushes"])
    requested = "".join(
        f"<p>Requested: {escape(reference_line(r))}</p>" for r in summary["references"]
    )
    if requested:
        requested += f"<p>Reached: {escape(reached_line(summary))}</p>"
    # The top of the page has the full lines of the pushes, so the table shows short ones.
    push_texts = [f"{push['direction']} {push['impulse_ns']:.2f} N.s" for push in summary["pushes"]]
    body = f"""<h1>{_status_mark(summary)}{escape(title)}</h1>
<p class="soft">{escape(conditions_line(summary))}</p>
{pushes}{requested}
<pre>{escape(command)}</pre>
<div class="top">
{film_html(film, film_error)}
<div class="tiles">{_tiles(summary)}</div>
</div>
{plots_html(PLOTS)}
{summary_table_html(FIELDS, {**summary, "pushes": push_texts})}"""
    return page_html(title, body)


def _status_mark(s: dict[str, Any]) -> str:
    kind = "bad" if s["fell"] else "good" if s["settled"] else "fair"
    return f'<span class="mark {kind}"></span>'


def film_html(film: str | None, film_error: str | None) -> str:
    """Return the film as HTML, or the reason why there is none."""
    if film is None:
        return f'<div class="card">{escape(film_error or "No film.")}</div>'
    text = "Film of the run; green arrows: foot forces; red arrows: pushes"
    return f'<div><img src="{escape(film)}" alt="{text}" title="{text}"></div>'


def _tiles(s: dict[str, Any]) -> str:
    settle = s["settle_time_s"]
    failures = s["qp_failures"]
    tiles = (
        ("settled after the last event", "-" if settle is None else f"{settle:.2f} s"),
        ("greatest tilt", f"{s['max_tilt_deg']:.2f}&deg;"),
        ("height error at the end", f"{s['height_error_mm']:.2f} mm"),
        ("largest foot displacement", f"{s['max_foot_travel_mm']:.1f} mm"),
        ("peak torque / limit", f"{100 * s['peak_torque_ratio']:.0f} %"),
        ("peak power", f"{s['peak_power_w']:.0f} W"),
        ("velocity error, RMS", f"{1000 * s['estimator_velocity_rmse']:.1f} mm/s"),
        ("tick, median and p99", f"{s['tick_us']['p50']:.0f} / {s['tick_us']['p99']:.0f} &micro;s"),
        ("failed ticks", f"{failures} of {s['ticks']}"),
        ("torque mode only", "yes" if s["torque_mode_only"] else "no"),
    )
    return tiles_html(tiles)
