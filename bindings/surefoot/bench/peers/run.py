"""All comparisons with peers."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from surefoot._core import Error
from surefoot.bench.peers.files import write_problem
from surefoot.bench.peers.interleave import one_processor
from surefoot.bench.peers.languages import cpp_bout, python_bout
from surefoot.bench.peers.motion import quiet_ticks
from surefoot.bench.peers.options import PeerOptions
from surefoot.bench.peers.peer import PEERS, Peer
from surefoot.bench.peers.problem import (
    GRAVITY,
    POSTURE,
    STIFFNESS,
    WEIGHTS,
    Problem,
    make_problem,
)
from surefoot.bench.recording import Recording
from surefoot.robot_files import describe_robot

# Ours over theirs, of which of our ticks, and of which peer.
RATIOS = {
    "ratio_state_to_torque_over_tsid": ("state_to_torque", "tsid"),
    "ratio_tick_over_tsid": ("tick", "tsid"),
    "ratio_state_to_torque_over_placo": ("state_to_torque", "placo"),
}


# What every side is asked for; docs/peers.md says it at length.
TASKS = {
    "what": "centre of mass, base orientation, posture, even forces; four feet down, friction, "
    "bounds of normal force and torque",
    "motion": "a quarter standing still, a quarter asked to bow, half a push and what follows",
    "stiffness_and_damping": {k: list(v) for k, v in {**STIFFNESS, "posture": POSTURE}.items()},
    "weights_of_peers": WEIGHTS,
}


def add_peers(
    result: dict[str, Any], recording: Recording, options: PeerOptions | None = None
) -> None:
    """Run the comparison and put it under "peers" of a bench's result, its ratios beside."""
    result["peers"] = run_peers(recording, options)
    result.update({name: result["peers"][name] for name in RATIOS})


def run_peers(
    recording: Recording, options: PeerOptions | None = None, peers: Sequence[Peer] = PEERS
) -> dict[str, Any]:
    """Compare our ticks with the peers' on a recorded run.

    Args:
        recording: What bench.record() returned.
        options: Defaults if None. The first run installs the peers.
        peers: To compare with.

    Returns:
        Plain JSON types. The ratios of RATIOS, medians over pairs of ticks, beside each its
        "_language", its "_python" where that is another, and its "_reason" where it is None; in
        "rows" all figures, a row per peer and language. A peer that does not run is a row that
        says why, never an exception.
    """
    options = options or PeerOptions()
    rows: list[dict[str, Any]]
    processor = None
    try:
        urdf = options.urdf or describe_robot(recording.robot.name).urdf
    except Error as problem:
        reason = f"a peer needs the robot's URDF: {problem}"
        rows = [{"peer": peer.name, "language": "python", "reason": reason} for peer in peers]
    else:
        problem_ = make_problem(recording, urdf)
        with tempfile.TemporaryDirectory(prefix="surefoot-peers-") as folder:
            rows, processor = _play(problem_, recording, options, peers, Path(folder))
    return {
        **_ratios(rows),
        "rows": rows,
        "tasks": TASKS,
        "ticks": len(recording.reports),
        "block": options.block,
        "processor": processor,
    }


def _play(
    problem: Problem,
    recording: Recording,
    options: PeerOptions,
    peers: Sequence[Peer],
    folder: Path,
) -> tuple[list[dict[str, Any]], int | None]:
    file = write_problem(problem, recording.reports, folder)
    weight = problem.robot.mass * GRAVITY
    bouts = [python_bout(problem, recording, options, peers, file)]
    if options.cpp:
        bouts.append(cpp_bout(problem, options, peers, file))
    rows = []
    for bout in bouts:
        options.say("peers: playing")
        with one_processor() as processor:
            rows += bout.play(len(problem), options.block, weight, quiet_ticks(recording))
    return rows, processor


def _ratios(rows: list[dict[str, Any]]) -> dict[str, Any]:
    ratios: dict[str, Any] = {}
    for name, (ours, peer) in RATIOS.items():
        its = {row["language"]: row for row in rows if row["peer"] == peer}
        ran = {language: row for language, row in its.items() if row["reason"] is None}
        language = next((name for name in ("c++", "python") if name in ran), None)
        key = f"ratio_{ours}"
        ratios[name] = ran[language][key] if language else None
        ratios[f"{name}_language"] = language
        if language == "c++" and "python" in ran:
            ratios[f"{name}_python"] = ran["python"][key]
        if language is None:
            reasons = [row["reason"] for row in its.values()]
            ratios[f"{name}_reason"] = "; ".join(reasons) or "not asked for"
    return ratios
