"""A filled card for people to read."""

from __future__ import annotations

from typing import Any


def assess_text(card: dict[str, Any]) -> str:
    """Return a filled card as tables."""
    push = card["push"]
    lines = [f"{card['robot']}, controller {card['controller']}, {card['card']} card", ""]
    for table in push["tables"]:
        lines += _push_table(table)
    lines += [f"  {text}" for text in push["broken"]]
    return "\n".join(lines)


def _push_table(table: dict[str, Any]) -> list[str]:
    place = f"{table['height_m']:+g} m from" if table["height_m"] else "through"
    title = f"pushes of {table['length_s']:g} s {place} the centre of mass"
    lines = [
        f"{title}, {table['statistic']}",
        f"  {'deg':>6}{'limit':>9}{'survive':>17}{'strict':>17}",
    ]
    for row in table["directions"]:
        cells = "".join(
            f"{row[kind]['ns']:7.2f} N.s {row[kind]['percent_of_limit']:3.0f} %"
            for kind in ("survive", "strict")
        )
        lines.append(f"  {row['degrees']:6.1f}{row['limit_ns']:9.2f}{cells}")
    worst = ", ".join(
        f"{kind} {table[f'{kind}_percent_of_limit_p5']:.1f} %" for kind in ("survive", "strict")
    )
    return [*lines, f"  worst direction, of the robot's own limit: {worst}", ""]
