"""HTML page of a walk's report: one file without scripts; the pictures are files beside it."""

from __future__ import annotations

from html import escape
from typing import Any

from surefoot.reports.page import page_html, plots_html, summary_table_html, tiles_html
from surefoot.stand.report_html import film_html
from surefoot.stand.summary_text import push_line
from surefoot.walk.plots import PLOTS
from surefoot.walk.summary_fields import FIELDS
from surefoot.walk.summary_text import command_line, outcome_sentence, walk_conditions_line


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
    lines = [f"Velocity: {command_line(entry)}" for entry in summary["commands"]]
    lines += [f"Push: {push_line(push)}" for push in summary["pushes"]]
    events = "".join(f"<p>{escape(line)}</p>" for line in lines)
    mark = "bad" if summary["fell"] else "good"
    # The top of the page has the full lines of pushes and commands, so the table has short ones.
    short = {
        "pushes": [
            f"{push['direction']} {push['impulse_ns']:.2f} N.s" for push in summary["pushes"]
        ],
        "commands": [
            f"{entry['velocity']} at {entry['time']:g} s" for entry in summary["commands"]
        ],
    }
    body = f"""<h1><span class="mark {mark}"></span>{escape(title)}</h1>
<p class="soft">{escape(walk_conditions_line(summary))}</p>
{events}
<pre>{escape(command)}</pre>
<div class="top">
{film_html(film, film_error)}
<div class="tiles">{_tiles(summary)}</div>
</div>
{plots_html(PLOTS)}
{summary_table_html(FIELDS, {**summary, **short})}"""
    return page_html(title, body)


def _tiles(s: dict[str, Any]) -> str:
    tiles = (
        ("mean velocity error: vx, vy, yaw rate", _numbers(s["velocity_mean_error"], 3)),
        ("RMS velocity error", _numbers(s["velocity_rmse"], 3)),
        ("roll, pitch, RMS", _numbers(s["roll_pitch_rms_deg"], 2, "&deg;")),
        ("cost of transport", _number(s["cost_of_transport"], 2)),
        ("slip per step", _number(s["slip_mm_per_step"], 1, " mm")),
        ("largest touchdown force", _number(s["touchdown_force_mg"], 2, " m g")),
        ("peak torque / limit", f"{100 * s['peak_torque_ratio']:.0f} %"),
        ("peak power", f"{s['peak_power_w']:.0f} W"),
        ("leg contacts", str(s["leg_contacts"])),
        ("failed ticks", f"{s['failed_ticks']} of {s['ticks']}"),
    )
    return tiles_html(tiles)


def _number(value: float | None, digits: int, unit: str = "") -> str:
    return "-" if value is None else f"{value:.{digits}f}{unit}"


def _numbers(values: list[float] | None, digits: int, unit: str = "") -> str:
    return "-" if values is None else ", ".join(f"{v:.{digits}f}{unit}" for v in values)
