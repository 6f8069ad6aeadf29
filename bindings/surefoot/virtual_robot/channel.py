"""One direction of a link, with lost and delayed datagrams."""

from __future__ import annotations

from collections import deque
from typing import Generic, TypeVar

import numpy as np

Message = TypeVar("Message")


class Channel(Generic[Message]):
    """One direction of a link: loses some datagrams and delays the rest without changing the order.

    A datagram of UDP, or a message of DDS.

    Args:
        drop: Share of lost datagrams [%].
        delay: Delay of every datagram that is not lost [s].
        jitter: Upper limit of an additional random delay [s]; uniform from 0.
        rng: Random generator of losses and jitter.

    Attributes:
        lost: Number of lost datagrams.
    """

    def __init__(self, drop: float, delay: float, jitter: float, rng: np.random.Generator) -> None:
        self._drop, self._delay, self._jitter = drop / 100.0, delay, jitter
        self._rng = rng
        self._in_flight: deque[tuple[float, Message]] = deque()
        self._last_arrival = 0.0
        self.lost = 0

    def put(self, datagram: Message, time: float) -> None:
        """Send a datagram at a time [s]."""
        if self._drop > 0.0 and self._rng.random() < self._drop:
            self.lost += 1
            return
        due = time + self._delay
        if self._jitter > 0.0:
            due += self._jitter * self._rng.random()
        self._last_arrival = max(self._last_arrival, due)
        self._in_flight.append((self._last_arrival, datagram))

    def take(self, time: float) -> list[Message]:
        """Remove and return the datagrams that arrived by a time [s], oldest first."""
        arrived = []
        # 1e-9 s covers the rounding errors of times, which are sums of periods.
        while self._in_flight and self._in_flight[0][0] <= time + 1e-9:
            arrived.append(self._in_flight.popleft()[1])
        return arrived
