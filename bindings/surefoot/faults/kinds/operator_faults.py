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
from surefoot.faults.kinds.clock_faults import OperatorAction
from surefoot.faults.kinds.fault import Fault

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


def lower_by_20_cm(supervisor: Supervisor, k: int) -> None:
    """Ask for 20 cm less height."""
    supervisor.set_body_reference(BodyReference(height=-0.2))


def nan_reference(supervisor: Supervisor, k: int) -> None:
    """Ask for what is no number."""
    supervisor.set_body_reference(BodyReference(height=float("nan")))


def alternating_pose(supervisor: Supervisor, k: int) -> None:
    """Ask for 3 cm left and right by turns."""
    supervisor.set_body_reference(BodyReference(y=0.03 if k // 50 % 2 else -0.03))


def random_poses() -> OperatorAction:
    """Return who asks for another pose in every tick."""
    rng = np.random.default_rng(17)

    def request_pose(supervisor: Supervisor, k: int) -> None:
        supervisor.set_body_reference(BodyReference(*rng.uniform(-0.05, 0.05, 3)))

    return OperatorAction(request_pose)


class RemoteStopPressed(Fault):
    """Button B of the remote is pressed for 0.1 s."""

    def change_state(self, state: LowState, k: int) -> None:
        """Press it."""
        if k < 50:
            state.wirelessRemote[3] = BUTTON_B


class HeartbeatLost(Fault):
    """The operator, there until now, sends no heartbeat any more.

    Args:
        timeout: That the supervisor waits [s].
    """

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout

    def set_options(self, options: SupervisorOptions) -> None:
        """Have it wait."""
        options.operator_timeout = self._timeout

    def update_before(self, supervisor: Supervisor) -> None:
        """Be there."""
        supervisor.heartbeat()


class OutOfOrderRequests(Fault):
    """Every mode that is not next is asked for in every tick."""

    def __init__(self) -> None:
        self._accepted: set[str] = set()

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Ask."""
        current = supervisor.mode
        allowed = {Mode.PASSIVE: Mode.RISE, Mode.RISE: Mode.SIT, Mode.STAND: Mode.SIT}
        for mode in (Mode.PASSIVE, Mode.RISE, Mode.STAND, Mode.SIT, Mode.DAMPING):
            if mode == allowed.get(current):
                continue
            if supervisor.request(mode) == RequestStatus.ACCEPTED:
                self._accepted.add(f"{mode.name} taken from {current.name}")

    def problems(self) -> list[str]:
        """Return which were taken."""
        return sorted(self._accepted)


class ConcurrentRequests(OutOfOrderRequests):
    """The same from four threads at once, now and then."""

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Ask from all."""
        if k % 50:
            return
        request = super().operate
        threads = [threading.Thread(target=request, args=(supervisor, k)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
