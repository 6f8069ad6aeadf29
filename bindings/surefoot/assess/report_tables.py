"""HTML tables of an assessment's report."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from surefoot.assess.sweep import percent_text


def push_table_html(table: dict[str, Any], name: str) -> str:
    """Return the push table of one duration and height as HTML."""
    kinds = ("survive", "strict")
    header = ["direction [deg]", "push limit [N.s]", "LIP limit [N.s]", "quasi-static [N]"]
    units = ("N.s", "N.s/kg", "% of LIP limit", "% of push limit")
    header += [f"{kind} [{unit}]" for kind in kinds for unit in units]
    rows = []
    for row in table["directions"]:
        cells = [f"{row['degrees']:g}", f"{row['limit_ns']:.2f}", f"{row['lip_ns']:.2f}"]
        cells.append(f"{row['quasi_static_force_n']:.0f}")
        for kind in ("survive", "strict"):
            result = row[kind]
            cells += [
                f"{result['ns']:.2f}",
                f"{result['ns_per_kg']:.3f}",
                f"{result['percent_of_lip']:.0f}",
                percent_text(result["percent_of_limit"]),
            ]
        rows.append([(cell, "") for cell in cells])
    where = f"{table['height_m']:+g} m from the centre of mass"
    title = f"{name}: pushes of {table['length_s']:g} s, {where}"
    text = f"{table['statistic']}, in steps of {table['step_percent']:g} % of the push limit"
    return table_html(title, text, header, rows)


def conditions_html(card: dict[str, Any]) -> str:
    """Return the table of conditions as HTML; "" if the scorecard has no conditions."""
    if not card["conditions"]:
        return ""
    header = ["condition", "stood", "passed", "tilt [deg]", "height [mm]", "feet [mm]"]
    header += ["survive [%]", "strict [%]"]
    rows = []
    for condition in card["conditions"]:
        stand, push = condition["stand"], condition["push"]
        css_class = "" if stand["passed"] == stand["runs"] else "fail"
        cells = [(condition["name"], ""), (f"{stand['stood']} of {stand['runs']}", css_class)]
        cells.append((f"{stand['passed']} of {stand['runs']}", css_class))
        cells += [(_number_text(stand[name]), "") for name in ("tilt_deg", "height_mm", "foot_mm")]
        for kind in ("survive", "strict"):
            share = None if push is None else push[f"{kind}_percent_of_limit_p5"]
            cells.append(("-" if share is None else percent_text(share), ""))
        rows.append(cells)
    text = (
        "Quiet stands: the worst of all seeds and headings, relative to the initial pose. "
        "Pushes: 0.1 s through the centre of mass, the worst direction, in percent of the push "
        "limit with the friction and mass of the condition."
    )
    return table_html("Conditions", text, header, rows)


def faults_html(card: dict[str, Any]) -> str:
    """Return the table of faults as HTML; "" if no faults were injected."""
    faults = card["faults"]
    if faults is None:
        return ""
    rows = []
    for row, count in faults["rows"].items():
        css_class = "fail" if count["failed"] else ""
        rows.append([(row, ""), (str(count["cells"]), ""), (str(count["failed"]), css_class)])
    text = "; ".join(f"{cell}: {why}" for cell, why in faults["failures"].items()) or "All passed."
    return table_html("Faults", text, ("row", "cells", "failed"), rows)


def table_html(
    title: str, text: str, header: Sequence[str], rows: Sequence[Sequence[tuple[str, str]]]
) -> str:
    """Return a page section with a table as HTML; each cell of `rows` is (text, CSS class)."""
    header_cells = "".join(f"<td><b>{escape(word)}</b></td>" for word in header)
    body = "".join(
        "<tr>" + "".join(f'<td class="{kind}">{escape(cell)}</td>' for cell, kind in row) + "</tr>"
        for row in rows
    )
    return (
        f'<section class="card"><h2>{escape(title)}</h2><p class="soft">{escape(text)}</p>'
        f'<div class="scroll"><table class="rows"><tr>{header_cells}</tr>{body}</table></div>'
        "</section>"
    )


def _number_text(value: float | None) -> str:
    return "-" if value is None else f"{value:.2f}"
