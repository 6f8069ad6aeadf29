"""Paired run: times all implementations of one language in turns, on the same ticks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from surefoot.bench.peers.interleave import interleave
from surefoot.bench.peers.options import PeerError
from surefoot.bench.peers.peer import Peer
from surefoot.bench.peers.surefoot_implementations import Implementation, Ticks

ImplementationFactory = Callable[[], Implementation]


@dataclass(frozen=True)
class PairedResult:
    """Result of one paired run, or of several in sequence.

    Attributes:
        language: Language of all implementations.
        peers: Peers that were requested.
        versions: Versions of the packages of each implementation, by its name.
        ticks: Ticks of each implementation that ran to the end.
        reasons: For each implementation that did not run to the end, the reason.
    """

    language: str
    peers: list[Peer]
    versions: dict[str, Any]
    ticks: dict[str, Ticks]
    reasons: dict[str, str]

    def append(self, other: PairedResult) -> PairedResult:
        """Return both results joined; an implementation has failed if it failed in one of them."""
        reasons = {**other.reasons, **self.reasons}
        shared = [name for name in self.ticks if name in other.ticks and name not in reasons]
        ticks = {name: np.vstack([self.ticks[name], other.ticks[name]]) for name in shared}
        return PairedResult(self.language, self.peers, self.versions, ticks, reasons)


class PairedRun:
    """Implementations of Surefoot and of the peers, in one language.

    Args:
        language: Language of all implementations.
        ours: Factories of Surefoot's implementations "state_to_torque" and "tick".
        theirs: Factory of the implementation of each peer.
    """

    def __init__(
        self,
        language: str,
        ours: Mapping[str, ImplementationFactory],
        theirs: Mapping[Peer, ImplementationFactory],
    ) -> None:
        self._language = language
        self._factories: dict[str, ImplementationFactory] = {
            "state_to_torque": ours["state_to_torque"],
            **{peer.name: factory for peer, factory in theirs.items()},
            "tick": ours["tick"],
        }
        self._peers = list(theirs)
        self._versions: dict[str, Any] = {}

    def run(self, ticks: int, block: int) -> PairedResult:
        """Time all implementations on one recording.

        Args:
            ticks: Number of ticks of the recording.
            block: Number of ticks that one implementation computes in its turn.
        """
        implementations, reasons = self._start()
        played: dict[str, Ticks] = {}
        try:
            if any(peer.name in implementations for peer in self._peers):
                played, ended = interleave(implementations, ticks, block)
                reasons.update(ended)
        finally:
            for implementation in implementations.values():
                implementation.close()
        return PairedResult(self._language, self._peers, self._versions, played, reasons)

    def _start(self) -> tuple[dict[str, Implementation], dict[str, str]]:
        implementations: dict[str, Implementation] = {}
        reasons: dict[str, str] = {}
        for name, make in self._factories.items():
            try:
                implementations[name] = make()
                self._versions[name] = getattr(implementations[name], "versions", None)
            except (PeerError, OSError) as problem:
                reasons[name] = str(problem)
        return implementations, reasons
