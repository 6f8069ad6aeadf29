"""Setup of the paired runs: the implementations of each language, and how each is started."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path

from surefoot.bench.peers.options import PeerError, PeerOptions
from surefoot.bench.peers.paired_run import PairedRun
from surefoot.bench.peers.peer import OUR_PROGRAM, OUR_TICKS, Peer
from surefoot.bench.peers.problem import Problem
from surefoot.bench.peers.surefoot_implementations import StateToTorque, WholeTick, tick_width
from surefoot.bench.peers.worker import worker_factory
from surefoot.bench.recording import Recording

PACKAGE_FOLDER = Path(__file__).parents[2]
VERSION_PACKAGES = ("tsid", "libtsid", "libpinocchio", "eiquadprog")


Interpreters = Mapping[Peer, Path | PeerError]
"""Interpreter of each peer, or the reason why the peer has none."""


def prepare_peers(peers: Sequence[Peer], options: PeerOptions) -> Interpreters:
    """Set up the environment of each peer. Call this once, because even a failure may take long."""
    interpreters: dict[Peer, Path | PeerError] = {}
    for peer in peers:
        try:
            interpreters[peer] = peer.environment.prepare(options)
        except (PeerError, OSError) as problem:
            interpreters[peer] = PeerError(str(problem))
    return interpreters


def make_paired_runs(
    problem: Problem,
    recording: Recording,
    options: PeerOptions,
    interpreters: Interpreters,
    file: Path,
) -> list[PairedRun]:
    """Return one paired run per language, with all C++ workers compiled."""
    found = [_python_paired_run(problem, recording, options, interpreters, file)]
    if options.cpp and any(peer.cpp_program for peer in interpreters):
        found.append(_cpp_paired_run(problem, options, interpreters, file))
    return found


def _interpreter(peer: Peer, interpreters: Interpreters) -> Path:
    python = interpreters[peer]
    if isinstance(python, PeerError):
        raise python
    return python


def _python_paired_run(
    problem: Problem,
    recording: Recording,
    options: PeerOptions,
    interpreters: Interpreters,
    file: Path,
) -> PairedRun:
    """Return the paired run in Python: Surefoot in this process, each peer in its interpreter."""

    def command(peer: Peer) -> list[str]:
        python = _interpreter(peer, interpreters)
        script = Path(__file__).parent / "workers" / peer.script
        return [str(python), "-B", "-W", "ignore", str(script), str(file)]

    width = tick_width(problem)
    return PairedRun(
        "python",
        {
            "state_to_torque": lambda: StateToTorque(problem),
            "tick": lambda: WholeTick(problem, recording.low_states),
        },
        {
            peer: worker_factory(partial(command, peer), width, options.timeout)
            for peer in interpreters
        },
    )


def _cpp_paired_run(
    problem: Problem, options: PeerOptions, interpreters: Interpreters, file: Path
) -> PairedRun:
    """Return the paired run in C++, with a process per implementation.

    Peers without a C++ worker do not take part.
    """

    def command(peer: Peer) -> list[str]:
        assert peer.cpp_program is not None
        _interpreter(peer, interpreters)
        prefix = peer.environment.site_packages(options) / "cmeel.prefix"
        versions = json.dumps(peer.environment.versions(VERSION_PACKAGES))
        return [str(peer.cpp_program.build([prefix], options)), str(file), versions]

    def our_command(tick: str) -> list[str]:
        # Pinocchio's prefix is beside the package, as in surefootConfig.cmake.
        prefixes = [PACKAGE_FOLDER, PACKAGE_FOLDER.parent / "cmeel.prefix"]
        return [str(OUR_PROGRAM.build(prefixes, options)), str(file), tick]

    width, timeout = tick_width(problem), options.timeout
    return PairedRun(
        "c++",
        {tick: worker_factory(partial(our_command, tick), width, timeout) for tick in OUR_TICKS},
        {
            peer: worker_factory(partial(command, peer), width, timeout)
            for peer in interpreters
            if peer.cpp_program is not None
        },
    )
