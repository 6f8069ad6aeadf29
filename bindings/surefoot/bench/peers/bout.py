"""One language's comparison: everybody is started, plays in turns, and is told in rows."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from surefoot.bench.peers.contestant import CPU, Contestant, Ticks
from surefoot.bench.peers.figures import answers, median_ratio, times
from surefoot.bench.peers.interleave import interleave
from surefoot.bench.peers.options import PeerProblem
from surefoot.bench.peers.peer import OUR_TICKS, Peer

Maker = Callable[[], Contestant]


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

    def play(self, ticks: int, block: int, weight: float, quiet: int) -> list[dict[str, Any]]:
        """Play, and return a row per peer; what went wrong is its "reason".

        Args:
            ticks: Of the recording.
            block: Ticks until it is the next one's turn.
            weight: Of the robot [N].
            quiet: Ticks before anything is asked to move.
        """
        contestants, reasons = self._start()
        try:
            if any(peer.name in contestants for peer in self._peers):
                played, ended = interleave(contestants, ticks, block)
                reasons.update(ended)
            else:
                played = {}
        finally:
            for contestant in contestants.values():
                contestant.close()
        return [self._row(peer, played, reasons, weight, quiet) for peer in self._peers]

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

    def _row(
        self,
        peer: Peer,
        played: dict[str, Ticks],
        reasons: dict[str, str],
        weight: float,
        quiet: int,
    ) -> dict[str, Any]:
        row: dict[str, Any] = {"peer": peer.name, "language": self._language}
        for name in (peer.name, *OUR_TICKS):
            if name in reasons:
                whose = "" if name == peer.name else f"our {name.replace('_', ' ')}: "
                return {**row, "reason": whose + reasons[name]}
        theirs, ours = played[peer.name], {name: played[name] for name in OUR_TICKS}
        ratios = {f"ratio_{name}": median_ratio(side, theirs) for name, side in ours.items()}
        on_cpu = {f"ratio_{name}_cpu": median_ratio(s, theirs, CPU) for name, s in ours.items()}
        return {
            **row,
            "reason": None,
            "versions": self._versions[peer.name],
            "pairs": len(theirs),
            **ratios,
            **on_cpu,
            "theirs": {"tick": peer.tick, "differs": peer.problem, **times(theirs)},
            **{f"our_{name}": {"tick": OUR_TICKS[name], **times(s)} for name, s in ours.items()},
            "answers": answers(ours["state_to_torque"], theirs, weight, quiet),
        }
