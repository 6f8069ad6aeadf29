"""What people and programs do to a supervisor: stops, jumps, requests out of order, bad options."""

from __future__ import annotations

import threading

import numpy as np

from surefoot._core import (
    BodyReference,
    LowState,
    Mode,
    RequestStatus,
    Supervisor,
    SupervisorOptions,
)
from surefoot.faults.clock_faults import Operator
from surefoot.faults.fault import Fault

BUTTON_B = 2  # of the remote's byte 3


def stop(supervisor: Supervisor, k: int) -> None:
    """Stop once."""
    if k == 0:
        supervisor.stop()


def stop_from_a_thread(supervisor: Supervisor, k: int) -> None:
    """Stop once, from a thread of its own."""
    if k == 0:
        thread = threading.Thread(target=supervisor.stop)
        thread.start()
        thread.join()


def low(supervisor: Supervisor, k: int) -> None:
    """Ask for 20 cm less height."""
    supervisor.set_body_reference(BodyReference(height=-0.2))


def nowhere(supervisor: Supervisor, k: int) -> None:
    """Ask for what is no number."""
    supervisor.set_body_reference(BodyReference(height=float("nan")))


def to_and_fro(supervisor: Supervisor, k: int) -> None:
    """Ask for 3 cm left and right by turns."""
    supervisor.set_body_reference(BodyReference(y=0.03 if k // 50 % 2 else -0.03))


def restless() -> Operator:
    """Return who asks for another pose in every tick."""
    rng = np.random.default_rng(17)

    def ask(supervisor: Supervisor, k: int) -> None:
        supervisor.set_body_reference(BodyReference(*rng.uniform(-0.05, 0.05, 3)))

    return Operator(ask)


class Pressed(Fault):
    """Button B of the remote is pressed for 0.1 s."""

    def state(self, state: LowState, k: int) -> None:
        """Press it."""
        if k < 50:
            state.wirelessRemote[3] = BUTTON_B


class Gone(Fault):
    """The operator, there until now, sends no heartbeat any more.

    Args:
        timeout: That the supervisor waits [s].
    """

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout

    def options(self, options: SupervisorOptions) -> None:
        """Have it wait."""
        options.operator_timeout = self._timeout

    def before(self, supervisor: Supervisor) -> None:
        """Be there."""
        supervisor.heartbeat()


class Misuse(Fault):
    """Every mode that is not next is asked for in every tick."""

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Ask."""
        here = supervisor.mode
        allowed = {Mode.PASSIVE: Mode.RISE, Mode.RISE: Mode.SIT, Mode.STAND: Mode.SIT}
        for mode in (Mode.PASSIVE, Mode.RISE, Mode.STAND, Mode.SIT, Mode.DAMPING):
            if mode == allowed.get(here):
                continue
            if supervisor.request(mode) == RequestStatus.ACCEPTED:
                self._taken.add(f"{mode.name} taken from {here.name}")

    def complaints(self) -> list[str]:
        """Return which were taken."""
        return sorted(self._taken)


class Crowd(Misuse):
    """The same from four threads at once, now and then."""

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Ask from all."""
        if k % 50:
            return
        ask = super().operate
        threads = [threading.Thread(target=ask, args=(supervisor, k)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
