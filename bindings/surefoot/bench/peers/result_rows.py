"""Rows of figures, one per peer and language, and the ratios of the tick times."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from surefoot.bench.peers.paired_run import PairedResult
from surefoot.bench.peers.peer import OUR_TICKS, Peer
from surefoot.bench.peers.surefoot_implementations import CPU
from surefoot.bench.peers.tick_comparison import (
    SAME_ANSWER,
    compare_answers,
    median_time_ratio,
    tick_statistics,
)

# For each ratio of tick times: its key, our implementation (numerator), the peer (denominator).
RATIOS = {
    "ratio_state_to_torque_over_tsid": ("state_to_torque", "tsid"),
    "ratio_tick_over_tsid": ("tick", "tsid"),
    "ratio_state_to_torque_over_placo": ("state_to_torque", "placo"),
}


def make_rows(played: PairedResult, weight: float, calm: NDArray[np.bool_]) -> list[dict[str, Any]]:
    """Return a row per peer. Its "reason" is why the peer did not run; None if the peer ran.

    Args:
        played: Result of a paired run.
        weight: Weight of the robot [N].
        calm: (n,) true for the ticks before the first push.
    """
    return [_row(peer, played, weight, calm) for peer in played.peers]


def _row(
    peer: Peer, played: PairedResult, weight: float, calm: NDArray[np.bool_]
) -> dict[str, Any]:
    row: dict[str, Any] = {"peer": peer.name, "language": played.language}
    for name in (peer.name, *OUR_TICKS):
        if name in played.reasons:
            prefix = "" if name == peer.name else f"our {name.replace('_', ' ')}: "
            return {**row, "reason": prefix + played.reasons[name]}
    theirs, ours = played.ticks[peer.name], {name: played.ticks[name] for name in OUR_TICKS}
    return {
        **row,
        "reason": None,
        "versions": played.versions[peer.name],
        "pairs": len(theirs),
        **{f"ratio_{name}": median_time_ratio(side, theirs) for name, side in ours.items()},
        **{
            f"ratio_{name}_cpu": median_time_ratio(side, theirs, CPU) for name, side in ours.items()
        },
        "theirs": {
            "tick": peer.tick_description,
            "differs": peer.problem_differences,
            **tick_statistics(theirs),
        },
        **{
            f"our_{name}": {"tick": OUR_TICKS[name], **tick_statistics(s)}
            for name, s in ours.items()
        },
        "answers": compare_answers(ours["state_to_torque"], theirs, weight, calm),
    }


def exclusion_reason(row: dict[str, Any]) -> str | None:
    """Return why the times of a row do not count; None if they count.

    They do not count if the peer did not run or gave another answer, or if the peer or Surefoot had
    unsolved ticks.
    """
    if row["reason"] is not None:
        return str(row["reason"])
    if row["answers"]["verdict"] != SAME_ANSWER:
        return str(row["answers"]["verdict"])
    sides = {"theirs": row["theirs"], **{name: row[f"our_{name}"] for name in OUR_TICKS}}
    failed = {name: side["failures"] for name, side in sides.items() if side["failures"]}
    counts = ", ".join(f"{count} of {name}" for name, count in failed.items())
    return f"unsolved ticks: {counts}" if failed else None


def compute_ratios(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the RATIOS by key; each ratio is from C++ if the peer ran in C++, else from Python.

    A ratio is None, and its "_reason" is given, if the times of the peer do not count in one of
    the languages: see exclusion_reason().
    """
    ratios: dict[str, Any] = {}
    for name, (ours, peer) in RATIOS.items():
        peer_rows = {row["language"]: row for row in rows if row["peer"] == peer}
        compared = {language: row for language, row in peer_rows.items() if row["reason"] is None}
        exclusions = [
            reason for row in compared.values() if (reason := exclusion_reason(row)) is not None
        ]
        if exclusions:
            compared = {}
        language = next((name for name in ("c++", "python") if name in compared), None)
        key = f"ratio_{ours}"
        ratios[name] = compared[language][key] if language else None
        ratios[f"{name}_language"] = language
        if language == "c++" and "python" in compared:
            ratios[f"{name}_python"] = compared["python"][key]
        if language is None:
            reasons = dict.fromkeys(
                exclusions or [str(row["reason"]) for row in peer_rows.values()]
            )
            ratios[f"{name}_reason"] = "; ".join(reasons) or "not requested"
    return ratios
