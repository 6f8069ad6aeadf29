"""Run of the comparison with the peers."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from functools import reduce
from pathlib import Path
from typing import Any

import numpy as np

from surefoot._core import Error
from surefoot.bench.peers.interleave import chosen_processor, one_processor
from surefoot.bench.peers.options import PeerOptions
from surefoot.bench.peers.paired_run import PairedResult
from surefoot.bench.peers.paired_run_setup import Interpreters, make_paired_runs, prepare_peers
from surefoot.bench.peers.peer import PEERS, Peer
from surefoot.bench.peers.problem import (
    POSTURE_GAINS,
    TASK_GAINS,
    make_problem,
    ticks_before_push,
)
from surefoot.bench.peers.problem_files import write_problem
from surefoot.bench.peers.result_rows import RATIOS, compute_ratios, make_rows
from surefoot.bench.peers.weights import GRAVITY
from surefoot.bench.recording import Recording, record
from surefoot.bench.run import Bench
from surefoot.bench.settings import BenchSettings
from surefoot.robot.description import describe_robot

SCENARIOS = ("quiet", "motion", "push50")
# Tasks and constraints of every implementation; docs/benchmarks/peers.md has the details.
TASKS = {
    "what": "centre of mass, base orientation, posture, even forces; four stance feet, friction, "
    "bounds of normal force and torque",
    "stiffness_and_damping": {
        k: list(v) for k, v in {**TASK_GAINS, "posture": POSTURE_GAINS}.items()
    },
}


def add_peers(bench: Bench, settings: BenchSettings, options: PeerOptions | None = None) -> None:
    """Run the comparison; add its result ("peers") and its ratios to a benchmark's figures."""
    recordings = [bench.recordings.get(name) or record(settings, name) for name in SCENARIOS]
    result = run_peers(recordings, options)
    reasons = [result.get(f"{name}_reason") for name in RATIOS]
    bench.figures["peers"] = result
    bench.figures.update({name: result[name] for name in RATIOS})
    bench.figures["ratio_reason"] = "; ".join(r for r in dict.fromkeys(reasons) if r) or None


def run_peers(
    recordings: Recording | Sequence[Recording],
    options: PeerOptions | None = None,
    peers: Sequence[Peer] = PEERS,
) -> dict[str, Any]:
    """Compare the ticks of Surefoot and of the peers on recorded runs of one robot.

    Args:
        recordings: Results of bench.record().
        options: Options. None: the default options. The first run installs the peers.
        peers: Peers to compare with.

    Returns:
        JSON values. Each ratio of RATIOS is a median over pairs of ticks. Further keys begin with
        the key of a ratio: KEY_language is the language of the ratio. If this language is C++,
        KEY_python is the value in Python. If the ratio is None, KEY_reason is the reason. "rows"
        has all figures, one row per peer and language. A peer that does not run raises no
        exception; its row has the reason.
    """
    options = options or PeerOptions()
    recording_list = [recordings] if isinstance(recordings, Recording) else list(recordings)
    robot = recording_list[0].robot
    rows: list[dict[str, Any]]
    try:
        urdf = options.urdf or describe_robot(robot.name).urdf
    except Error as problem:
        reason = f"peers need the URDF of the robot: {problem}"
        rows = [{"peer": peer.name, "language": "python", "reason": reason} for peer in peers]
    else:
        interpreters = prepare_peers(peers, options)
        played = [
            _run_recording(recording, urdf, options, interpreters) for recording in recording_list
        ]
        calm = np.concatenate(
            [np.arange(len(r.low_states)) < ticks_before_push(r) for r in recording_list]
        )
        rows = []
        for same_language in zip(*played, strict=True):
            rows += make_rows(
                reduce(PairedResult.append, same_language), robot.mass * GRAVITY, calm
            )
    return {
        **compute_ratios(rows),
        "rows": rows,
        "tasks": TASKS,
        "scenarios": {r.scenario: len(r.low_states) for r in recording_list},
        "block": options.block,
        "processor": chosen_processor(),
    }


def _run_recording(
    recording: Recording, urdf: Path, options: PeerOptions, interpreters: Interpreters
) -> list[PairedResult]:
    """Time a recording in every language."""
    problem = make_problem(recording, urdf)
    with tempfile.TemporaryDirectory(prefix="surefoot-peers-") as folder:
        file = write_problem(problem, recording.low_states, Path(folder))
        options.report_progress(f"peers: timing {recording.scenario}")
        paired_runs = make_paired_runs(problem, recording, options, interpreters, file)
        with one_processor():
            return [paired_run.run(len(problem), options.block) for paired_run in paired_runs]
