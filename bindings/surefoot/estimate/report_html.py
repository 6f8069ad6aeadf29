"""Page of the report: one HTML file without scripts, with its plots as separate files."""

from __future__ import annotations

from html import escape
from typing import Any

from surefoot.estimate.plots import PLOTS
from surefoot.estimate.summary_fields import FIELDS
from surefoot.estimate.summary_text import (
    bad_sensors,
    headline,
    log_line,
    values_with_std,
    warning_lines,
)
from surefoot.reports.page import page_html, plots_html, summary_table_html, tiles_html

# Chosen for a page that a person reads.
MAX_LIST_LINES = 20  # largest number of lines of a list on the page; summary.json has all entries


def render_page(summary: dict[str, Any], command: str) -> str:
    """Return the page as HTML.

    Args:
        summary: Result of summarise().
        command: Command line that made the report; "" if there was none.
    """
    title = headline(summary)
    mark = (
        "bad" if not summary["statuses"].get("OK") else "fair" if warning_lines(summary) else "good"
    )
    notes = "".join(f"<p>Warning: {escape(text)}</p>" for text in warning_lines(summary))
    notes += "".join(f"<p>Note: {escape(text)}</p>" for text in summary["notes"])
    body = f"""<h1><span class="mark {mark}"></span>{escape(title)}</h1>
<p class="soft">{escape(log_line(summary))}</p>
{notes}
{f"<pre>{escape(command)}</pre>" if command else ""}
<div class="tiles card">{_tiles(summary)}</div>
{plots_html(PLOTS)}
{summary_table_html(FIELDS, _page_summary(summary))}"""
    return page_html(title, body)


def _tiles(s: dict[str, Any]) -> str:
    rmse = s["velocity_rmse"]
    us = s["update_us"]
    bad = bad_sensors(s)
    nis = s["nis_per_dimension"]
    tiles = (
        ("position at the end", values_with_std(s["position"], s["position_std"], "m", 2)),
        ("roll, pitch, yaw at the end", values_with_std(s["rpy_deg"], s["rpy_std_deg"], "deg", 1)),
        ("path", f"{s['path_length']:.2f} m"),
        ("bad sensors", str(len(bad))),
        ("contact transitions", str(len(s["contact_transitions"]))),
        ("NIS over its dimension", "-" if nis is None else f"{nis:.2f}"),
        ("velocity error, RMS", "-" if rmse is None else f"{1000 * rmse:.1f} mm/s"),
        ("update, median and p99", f"{us['p50']:.1f} / {us['p99']:.1f} &micro;s" if us else "-"),
    )
    return tiles_html(tiles)


def _page_summary(summary: dict[str, Any]) -> dict[str, Any]:
    """Return the summary with long lists cut and nested entries as text."""
    shown = dict(summary)
    verdicts = summary["verdicts"].items()
    shown["verdicts"] = {name: f"{v['now']} now, {_shares(v['share'])}" for name, v in verdicts}
    shown["contact"] = {
        foot: f"{c['transitions']} transitions, {_percent(c['share'])} of the time"
        for foot, c in summary["contact"].items()
    }
    for name in ("contact_transitions", "slip_events"):
        entries = [", ".join(f"{k} {v}" for k, v in entry.items()) for entry in summary[name]]
        more = (
            [f"... and {len(entries) - MAX_LIST_LINES} more"]
            if len(entries) > MAX_LIST_LINES
            else []
        )
        shown[name] = entries[:MAX_LIST_LINES] + more
    for name in ("contact_delays", "strides", "baselines"):
        if summary[name] is not None:
            shown[name] = {key: _entries(entry) for key, entry in summary[name].items()}
    return shown


def _entries(values: dict[str, Any]) -> str:
    """Return named numbers as text, rounded to four digits."""
    texts = {k: f"{v:.4g}" if isinstance(v, float) else str(v) for k, v in values.items()}
    return ", ".join(f"{k} {text}" for k, text in texts.items())


def _shares(shares: dict[str, float]) -> str:
    return ", ".join(f"{name} {_percent(share)}" for name, share in shares.items())


def _percent(share: float | None) -> str:
    return "-" if share is None else f"{100.0 * share:.3g} %"
