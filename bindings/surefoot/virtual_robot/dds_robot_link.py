"""Robot's end of a DDS link: a go2 or b2 with its motion switcher."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import DdsNetwork, DdsRobotPort, LowCmd, LowState
from surefoot.motion_switcher import MotionSwitcherServer
from surefoot.virtual_robot.channel import Channel
from surefoot.virtual_robot.settings import VirtualRobotSettings

_RNG_STREAM = 10  # number of the first of two random streams; the plant uses 0 .. 3


class DdsRobotLink:
    """Link that reads rt/lowcmd, writes rt/lowstate and serves the motion switcher.

    Args:
        network: Network and domain of the robot.
        settings: Settings of the robot and its link; settings.sdk is "go2" or "b2".
        sport_mode: Mode of the motion switcher at the start; None: there is no motion switcher.

    Raises:
        Error: Another robot writes rt/lowstate, or a program writes rt/lowcmd with another type.
    """

    def __init__(
        self, network: DdsNetwork, settings: VirtualRobotSettings, sport_mode: str | None
    ) -> None:
        self._port = DdsRobotPort(network, settings.generation)
        impairments = settings.drop, settings.delay, settings.jitter
        rngs = [np.random.default_rng([settings.seed, _RNG_STREAM + k]) for k in range(2)]
        self._incoming: Channel[LowCmd] = Channel(*impairments, rngs[0])
        self._outgoing: Channel[LowState] = Channel(*impairments, rngs[1])
        self._news: list[str] = []
        self._switcher = (
            None
            if sport_mode is None
            else MotionSwitcherServer(network, sport_mode, self._set_sport_mode)
        )

    @property
    def lost(self) -> tuple[int, int]:
        """Numbers of lost messages: incoming, outgoing."""
        return self._incoming.lost, self._outgoing.lost

    @property
    def received(self) -> int:
        """Number of commands that arrived, valid or not."""
        return self._port.counts.received

    @property
    def commands(self) -> int:
        """Number of valid commands."""
        return self._port.counts.commands

    @property
    def overtaken(self) -> int:
        """Number of commands that were replaced by a newer command in the same cycle."""
        return self._port.counts.overtaken

    @property
    def repeated(self) -> int:
        """Number of commands that equal the command before in every byte."""
        return self._port.counts.repeated

    @property
    def sent(self) -> int:
        """Number of LowStates sent."""
        return self._port.counts.sent

    @property
    def unsent(self) -> int:
        """Number of LowStates that could not be sent."""
        return self._port.counts.unsent

    def receive(self, time: float) -> LowCmd | None:
        """Answer requests; return the newest valid command that arrived by a time [s], or None."""
        if self._switcher is not None:
            self._switcher.poll()
        cmd = self._port.receive()
        if cmd is not None:
            self._incoming.put(cmd, time)
        arrived = self._incoming.take(time)
        return arrived[-1] if arrived else None

    def send_state(self, state: LowState, time: float) -> None:
        """Send a LowState at a time [s], and earlier ones whose delay is over."""
        self._outgoing.put(state, time)
        for due in self._outgoing.take(time):
            self._port.send(due)

    def take_news(self) -> list[str]:
        """Return what has changed since the last call: programs, the mode of the switcher."""
        news, self._news = self._news, []
        return [*news, *self._port.take_news()]

    def rejected_text(self) -> str:
        """Return the number of rejected commands and of each reason as text."""
        reasons = {name: count for name, count in self.rejected_counts().items() if count}
        if not reasons:
            return "0"
        text = ", ".join(f"{name} {count}" for name, count in reasons.items())
        return f"{sum(reasons.values())} ({text})"

    def rejected_counts(self) -> dict[str, int]:
        """Return the number of rejected commands by reason."""
        counts = self._port.counts
        return {
            "blank": counts.blank,
            "wrong crc": counts.wrong_crc,
            "not finite": counts.not_finite,
        }

    def rejected_lengths(self) -> list[dict[str, Any]]:
        """Return the wrong lengths of messages: none, because DDS checks them."""
        return []

    def _set_sport_mode(self, mode: str) -> None:
        self._port.set_sport_service(bool(mode))
        text = f"mode '{mode}'" if mode else "no mode, the low level is free"
        self._news.append(f"motion switcher: {text}")
