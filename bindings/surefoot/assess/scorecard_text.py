"""Filled scorecard as text."""

from __future__ import annotations

from typing import Any

from surefoot.assess.sweep import percent_text

_WIDTH = 36  # [characters] width of the first column; the longest name in full.toml has 35


def assess_text(card: dict[str, Any]) -> str:
    """Return a filled scorecard as tables of text."""
    lines = [f"{card['robot']}, controller {card['controller']}, {card['card']} scorecard", ""]
    for table in card["push"]["tables"]:
        lines += _push_table(table)
    lines += [f"  broken: {why}" for why in card["push"]["broken"]]
    lines += _condition_lines(card["conditions"])
    if card["foreign_plant"] is not None:
        lines += _foreign_lines(card["foreign_plant"])
    for name, push in card["references"].items():
        lines.append(f"reference {name}, {push['statistic']}, {_worst_line(push)}")
        lines += [f"  broken: {why}" for why in push["broken"]]
    faults = card["faults"]
    if faults is not None:
        lines.append(f"faults: {faults['passed']} of {faults['passed'] + faults['failed']} passed")
        lines += [f"  {cell}: {why}" for cell, why in faults["failures"].items()]
    return "\n".join(lines)


def foreign_title(section: dict[str, Any]) -> str:
    """Return the title of the section "foreign plant": the file and what differs most."""
    return (
        f"foreign plant {section['mjcf']}: {section['mass_kg']:.3f} kg, friction "
        f"{section['friction']:g}"
    )


def _foreign_lines(section: dict[str, Any]) -> list[str]:
    lines = [foreign_title(section)]
    for table in section["push"]["tables"]:
        lines += _push_table(table)
    lines += [f"  broken: {why}" for why in section["push"]["broken"]]
    return lines + _condition_lines(
        []
        if section["stand"] is None
        else [{"name": "MJCF", "stand": section["stand"], "push": section["push"]}]
    )


def _push_table(table: dict[str, Any]) -> list[str]:
    line_of_action = f"{table['height_m']:+g} m from" if table["height_m"] else "through"
    title = f"pushes of {table['length_s']:g} s {line_of_action} the centre of mass"
    lines = [
        f"{title}, {table['statistic']}, in steps of {table['step_percent']:g} %",
        f"  {'deg':>6}{'limit':>9}{'survive':>20}{'strict':>20}",
    ]
    for row in table["directions"]:
        cells = "".join(
            f"{row[kind]['ns']:8.2f} N.s {percent_text(row[kind]['percent_of_limit']):>6}%"
            for kind in ("survive", "strict")
        )
        lines.append(f"  {row['degrees']:6.1f}{row['limit_ns']:9.2f}{cells}")
    return [*lines, f"  {_worst_line(table)}", ""]


def _worst_line(push: dict[str, Any]) -> str:
    shares = ", ".join(
        f"{kind} {percent_text(push[f'{kind}_percent_of_limit_p5'])} %"
        for kind in ("survive", "strict")
    )
    return f"worst direction, of the push limit: {shares}"


def _condition_lines(conditions: list[dict[str, Any]]) -> list[str]:
    if not conditions:
        return []
    names = ("passed", "tilt deg", "height mm", "feet mm", "survive", "strict")
    lines = [f"{'condition':<{_WIDTH}}" + "".join(f"{name:>10}" for name in names)]
    for condition in conditions:
        stand, push = condition["stand"], condition["push"]
        cells = [f"{stand['passed']} of {stand['runs']}"]
        for name in ("tilt_deg", "height_mm", "foot_mm"):
            cells.append("-" if stand[name] is None else f"{stand[name]:.2f}")
        for kind in ("survive", "strict"):
            share = None if push is None else push[f"{kind}_percent_of_limit_p5"]
            cells.append("-" if share is None else f"{percent_text(share)} %")
        lines.append(f"{condition['name']:<{_WIDTH}}" + "".join(f"{cell:>10}" for cell in cells))
        reasons = stand["broken"] + ([] if push is None else push["broken"])
        lines += [f"  broken: {why}" for why in sorted(set(reasons))]
    return [*lines, ""]
