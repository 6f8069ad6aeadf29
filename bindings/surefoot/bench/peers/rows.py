"""Rows of figures, one per peer and language, and the ratios that sum them up."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from surefoot.bench.peers.bout import Played
from surefoot.bench.peers.contestant import CPU
from surefoot.bench.peers.figures import SAME, answers, median_ratio, times
from surefoot.bench.peers.peer import OUR_TICKS, Peer

# Ours over theirs, of which of our ticks, and of which peer.
RATIOS = {
    "ratio_state_to_torque_over_tsid": ("state_to_torque", "tsid"),
    "ratio_tick_over_tsid": ("tick", "tsid"),
    "ratio_state_to_torque_over_placo": ("state_to_torque", "placo"),
}


def rows_of(played: Played, weight: float, calm: NDArray[np.bool_]) -> list[dict[str, Any]]:
    """Return a row per peer; what went wrong is its "reason".

    Args:
        played: By everybody.
        weight: Of the robot [N].
        calm: Which ticks are before any push, shape (n,).
    """
    return [_row(peer, played, weight, calm) for peer in played.peers]


def _row(peer: Peer, played: Played, weight: float, calm: NDArray[np.bool_]) -> dict[str, Any]:
    row: dict[str, Any] = {"peer": peer.name, "language": played.language}
    for name in (peer.name, *OUR_TICKS):
        if name in played.reasons:
            whose = "" if name == peer.name else f"our {name.replace('_', ' ')}: "
            return {**row, "reason": whose + played.reasons[name]}
    theirs, ours = played.ticks[peer.name], {name: played.ticks[name] for name in OUR_TICKS}
    return {
        **row,
        "reason": None,
        "versions": played.versions[peer.name],
        "pairs": len(theirs),
        **{f"ratio_{name}": median_ratio(side, theirs) for name, side in ours.items()},
        **{f"ratio_{name}_cpu": median_ratio(side, theirs, CPU) for name, side in ours.items()},
        "theirs": {"tick": peer.tick, "differs": peer.problem, **times(theirs)},
        **{f"our_{name}": {"tick": OUR_TICKS[name], **times(s)} for name, s in ours.items()},
        "answers": answers(ours["state_to_torque"], theirs, weight, calm),
    }


def incomparable(row: dict[str, Any]) -> str | None:
    """Return why a row's times say nothing: it did not run, failed, or solved another problem."""
    if row["reason"] is not None:
        return str(row["reason"])
    if row["answers"]["verdict"] != SAME:
        return str(row["answers"]["verdict"])
    sides = {"theirs": row["theirs"], **{name: row[f"our_{name}"] for name in OUR_TICKS}}
    failed = {name: side["failures"] for name, side in sides.items() if side["failures"]}
    told = ", ".join(f"{count} of {name}" for name, count in failed.items())
    return f"ticks that were not solved: {told}" if failed else None


def ratios_of(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the RATIOS, in C++ where both sides ran in it; None has a "_reason" beside it.

    There is none of a peer that in any language has ticks that were not solved or another answer.
    """
    ratios: dict[str, Any] = {}
    for name, (ours, peer) in RATIOS.items():
        its = {row["language"]: row for row in rows if row["peer"] == peer}
        ran = {language: row for language, row in its.items() if row["reason"] is None}
        wrong = [why for row in ran.values() if (why := incomparable(row)) is not None]
        if wrong:
            ran = {}
        language = next((name for name in ("c++", "python") if name in ran), None)
        key = f"ratio_{ours}"
        ratios[name] = ran[language][key] if language else None
        ratios[f"{name}_language"] = language
        if language == "c++" and "python" in ran:
            ratios[f"{name}_python"] = ran["python"][key]
        if language is None:
            reasons = dict.fromkeys(wrong or [str(row["reason"]) for row in its.values()])
            ratios[f"{name}_reason"] = "; ".join(reasons) or "not asked for"
    return ratios
