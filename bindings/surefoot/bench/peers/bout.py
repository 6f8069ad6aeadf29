"""One language's comparison: everybody is started and plays in turns."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from surefoot.bench.peers.contestant import Contestant, Ticks
from surefoot.bench.peers.interleave import interleave
from surefoot.bench.peers.options import PeerProblem
from surefoot.bench.peers.peer import Peer

Maker = Callable[[], Contestant]


@dataclass(frozen=True)
class Played:
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

    def then(self, other: Played) -> Played:
        """Return both; who failed in one has failed in both."""
        reasons = {**other.reasons, **self.reasons}
        shared = [name for name in self.ticks if name in other.ticks and name not in reasons]
        ticks = {name: np.vstack([self.ticks[name], other.ticks[name]]) for name in shared}
        return Played(self.language, self.peers, self.versions, ticks, reasons)


class Bout:
    """Ours and the peers', in one language.

    Args:
        language: Of every side.
        ours: Makers of "state_to_torque" and "tick".
        theirs: A maker for every peer.
    """

    def __init__(
        self, language: str, ours: Mapping[str, Maker], theirs: Mapping[Peer, Maker]
    ) -> None:
        self._language = language
        self._makers: dict[str, Maker] = {
            "state_to_torque": ours["state_to_torque"],
            **{peer.name: maker for peer, maker in theirs.items()},
            "tick": ours["tick"],
        }
        self._peers = list(theirs)
        self._versions: dict[str, Any] = {}

    def play(self, ticks: int, block: int) -> Played:
        """Play one recording.

        Args:
            ticks: Of it.
            block: Ticks until it is the next one's turn.
        """
        contestants, reasons = self._start()
        played: dict[str, Ticks] = {}
        try:
            if any(peer.name in contestants for peer in self._peers):
                played, ended = interleave(contestants, ticks, block)
                reasons.update(ended)
        finally:
            for contestant in contestants.values():
                contestant.close()
        return Played(self._language, self._peers, self._versions, played, reasons)

    def _start(self) -> tuple[dict[str, Contestant], dict[str, str]]:
        contestants: dict[str, Contestant] = {}
        reasons: dict[str, str] = {}
        for name, make in self._makers.items():
            try:
                contestants[name] = make()
                self._versions[name] = getattr(contestants[name], "versions", None)
            except (PeerProblem, OSError) as problem:
                reasons[name] = str(problem)
        return contestants, reasons
