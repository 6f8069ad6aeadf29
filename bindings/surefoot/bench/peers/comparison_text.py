"""Text of the results of the comparison with the peers."""

from __future__ import annotations

from typing import Any

NOTE = (
    "Wall time [us] on one processor; implementations take turns by blocks of ticks. A ratio is "
    "the median\nof ours / theirs over all ticks."
)


def peers_text(result: dict[str, Any]) -> str:
    """Return the result of run_peers() as a table of text."""
    lines = [NOTE]
    for row in result["rows"]:
        head = f"{row['peer']} ({row['language']}): "
        if row["reason"] is not None:
            lines.append(f"{head}did not run: {row['reason']}")
            continue
        lines.append(f"{head}{_versions(row)}, {row['pairs']} pairs, {row['answers']['verdict']}")
        sides = {"their tick": row["theirs"], **_ours(row)}
        for name, side in sides.items():
            wall, cpu, failed = side["wall_us"], side["cpu_us"], side["failures"]
            ratio = row.get(f"ratio_{name.removeprefix('our ').replace(' ', '_')}")
            share = "" if ratio is None else f"  {ratio:.3f} of theirs"
            unsolved = f"  {failed} FAILED" if failed else ""
            lines.append(
                f"  {name:<20} p50 {wall['p50']:6.1f}  p99 {wall['p99']:7.1f}  "
                f"p99 cpu {cpu['p99']:7.1f}{share}{unsolved}"
            )
    return "\n".join(lines)


def _ours(row: dict[str, Any]) -> dict[str, Any]:
    return {f"our {name.replace('_', ' ')}": row[f"our_{name}"] for name in _names(row)}


def _names(row: dict[str, Any]) -> list[str]:
    return [key.removeprefix("our_") for key in row if key.startswith("our_")]


def _versions(row: dict[str, Any]) -> str:
    return " ".join(f"{name} {version}" for name, version in (row["versions"] or {}).items())
