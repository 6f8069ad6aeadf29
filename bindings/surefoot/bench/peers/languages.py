"""Who plays in which language, and how each is started."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path

from surefoot.bench.peers.bout import Bout
from surefoot.bench.peers.contestant import StateToTorque, WholeTick, tick_width
from surefoot.bench.peers.options import PeerOptions, PeerProblem
from surefoot.bench.peers.peer import OUR_PROGRAM, OUR_TICKS, Peer
from surefoot.bench.peers.problem import Problem
from surefoot.bench.peers.worker import worker_maker
from surefoot.bench.recording import Recording

PACKAGE = Path(__file__).parents[2]
VERSIONS = ("tsid", "libtsid", "libpinocchio", "eiquadprog")


Pythons = Mapping[Peer, Path | PeerProblem]
"""A peer's interpreter, or why it has none."""


def prepare_peers(peers: Sequence[Peer], options: PeerOptions) -> Pythons:
    """Set up every peer's environment; once a run, for what fails takes its time to."""
    pythons: dict[Peer, Path | PeerProblem] = {}
    for peer in peers:
        try:
            pythons[peer] = peer.environment.prepare(options)
        except (PeerProblem, OSError) as problem:
            pythons[peer] = PeerProblem(str(problem))
    return pythons


def bouts(
    problem: Problem, recording: Recording, options: PeerOptions, pythons: Pythons, file: Path
) -> list[Bout]:
    """Return the bout of every language, everything compiled."""
    found = [_python_bout(problem, recording, options, pythons, file)]
    if options.cpp and any(peer.program for peer in pythons):
        found.append(_cpp_bout(problem, options, pythons, file))
    return found


def _python_of(peer: Peer, pythons: Pythons) -> Path:
    python = pythons[peer]
    if isinstance(python, PeerProblem):
        raise python
    return python


def _python_bout(
    problem: Problem, recording: Recording, options: PeerOptions, pythons: Pythons, file: Path
) -> Bout:
    """Ours in this process, the peers in interpreters of their own."""

    def command(peer: Peer) -> list[str]:
        python = _python_of(peer, pythons)
        script = Path(__file__).parent / "workers" / peer.script
        return [str(python), "-B", "-W", "ignore", str(script), str(file)]

    width = tick_width(problem)
    return Bout(
        "python",
        {
            "state_to_torque": lambda: StateToTorque(problem),
            "tick": lambda: WholeTick(problem, recording.reports),
        },
        {peer: worker_maker(partial(command, peer), width, options.patience) for peer in pythons},
    )


def _cpp_bout(problem: Problem, options: PeerOptions, pythons: Pythons, file: Path) -> Bout:
    """Every side a compiled process; peers without a C++ worker do not play."""

    def command(peer: Peer) -> list[str]:
        assert peer.program is not None
        _python_of(peer, pythons)
        prefix = peer.environment.site(options) / "cmeel.prefix"
        versions = json.dumps(peer.environment.versions(VERSIONS))
        return [str(peer.program.build([prefix], options)), str(file), versions]

    def our_command(tick: str) -> list[str]:
        # Pinocchio's prefix lies beside the package, as surefootConfig.cmake has it too.
        prefixes = [PACKAGE, PACKAGE.parent / "cmeel.prefix"]
        return [str(OUR_PROGRAM.build(prefixes, options)), str(file), tick]

    width, patience = tick_width(problem), options.patience
    return Bout(
        "c++",
        {tick: worker_maker(partial(our_command, tick), width, patience) for tick in OUR_TICKS},
        {
            peer: worker_maker(partial(command, peer), width, patience)
            for peer in pythons
            if peer.program is not None
        },
    )
