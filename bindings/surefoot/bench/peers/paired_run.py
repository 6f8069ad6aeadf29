"""One language's comparison: everybody is started and plays in turns."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from surefoot.bench.peers.implementation import Implementation, Ticks
from surefoot.bench.peers.interleave import interleave
from surefoot.bench.peers.options import PeerError
from surefoot.bench.peers.peer import Peer

ImplementationFactory = Callable[[], Implementation]


@dataclass(frozen=True)
class PairedResult:
    """What came of a bout, or of several, one after the other.

    Attributes:
        language: Of every side.
        peers: That were to play.
        versions: Of what is behind them, by their names.
        ticks: By contestant, of those that played to the end.
        reasons: By contestant, of those that did not.
    """

    language: str
    peers: list[Peer]
    versions: dict[str, Any]
    ticks: dict[str, Ticks]
    reasons: dict[str, str]

    def append(self, other: PairedResult) -> PairedResult:
        """Return both; who failed in one has failed in both."""
        reasons = {**other.reasons, **self.reasons}
        shared = [name for name in self.ticks if name in other.ticks and name not in reasons]
        ticks = {name: np.vstack([self.ticks[name], other.ticks[name]]) for name in shared}
        return PairedResult(self.language, self.peers, self.versions, ticks, reasons)


class PairedRun:
    """Ours and the peers', in one language.

    Args:
        language: Of every side.
        ours: Factories of "state_to_torque" and "tick".
        theirs: A factory for every peer.
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
        """Play one recording.

        Args:
            ticks: Of it.
            block: Ticks until it is the next one's turn.
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
