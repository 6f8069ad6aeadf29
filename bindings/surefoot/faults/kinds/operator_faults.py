"""Faults of operators and calling programs: stops, jumping references, invalid requests."""

from __future__ import annotations

import threading
from collections.abc import Callable

import numpy as np

from surefoot._core import (
    BodyReference,
    LowState,
    Mode,
    RequestStatus,
    Supervisor,
    SupervisorOptions,
    WalkVelocity,
)
from surefoot.faults.kinds.clock_faults import OperatorAction
from surefoot.faults.kinds.fault import Fault

BUTTON_B = 2  # bit mask of button B in byte 3 of wirelessRemote; bit 9 in joystick.h of the SDK


def stop(supervisor: Supervisor, k: int) -> None:
    """Stop the robot once."""
    if k == 0:
        supervisor.stop()


def stop_from_a_thread(supervisor: Supervisor, k: int) -> None:
    """Stop the robot once from another thread."""
    if k == 0:
        thread = threading.Thread(target=supervisor.stop)
        thread.start()
        thread.join()


def lower_by_20_cm(supervisor: Supervisor, k: int) -> None:
    """Request a body height that is 20 cm lower."""
    supervisor.set_body_reference(BodyReference(height=-0.2))


def nan_reference(supervisor: Supervisor, k: int) -> None:
    """Request a body height of NaN."""
    supervisor.set_body_reference(BodyReference(height=float("nan")))


def alternating_pose(supervisor: Supervisor, k: int) -> None:
    """Request a body position 3 cm to the right or to the left; change sides every 50 periods."""
    supervisor.set_body_reference(BodyReference(y=0.03 if k // 50 % 2 else -0.03))


def random_poses() -> OperatorAction:
    """Return an operator action that requests another random pose in every tick."""
    rng = np.random.default_rng(17)  # any fixed seed, so that runs repeat

    def request_pose(supervisor: Supervisor, k: int) -> None:
        supervisor.set_body_reference(BodyReference(*rng.uniform(-0.05, 0.05, 3)))

    return OperatorAction(request_pose)


class VelocityFault(Fault):
    """The velocity of a walking robot changes.

    Args:
        change: Function of the velocity and of the number of periods since the onset; it returns
            the new velocity, or None for no velocity.
    """

    def __init__(self, change: Callable[[WalkVelocity, int], WalkVelocity | None]) -> None:
        self._change = change

    def change_velocity(self, velocity: WalkVelocity, k: int) -> WalkVelocity | None:
        """Return the changed velocity."""
        return self._change(velocity, k)


def random_velocities() -> VelocityFault:
    """Return a fault that sends another random velocity in every tick."""
    rng = np.random.default_rng(17)  # any fixed seed, so that runs repeat
    return VelocityFault(lambda velocity, k: WalkVelocity(*rng.uniform(-1.0, 1.0, 3)))


class RemoteStopPressed(Fault):
    """Button B of the remote is pressed for 0.1 s."""

    def change_state(self, state: LowState, k: int) -> None:
        """Set the button in a sample."""
        if k < 50:
            state.wirelessRemote[3] = BUTTON_B


class HeartbeatLost(Fault):
    """The operator's heartbeats end at the onset.

    Args:
        timeout: SupervisorOptions.operator_timeout [s].
    """

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout

    def set_options(self, options: SupervisorOptions) -> None:
        """Set the operator timeout."""
        options.operator_timeout = self._timeout

    def operate_before_onset(self, supervisor: Supervisor) -> None:
        """Send a heartbeat."""
        supervisor.heartbeat()


class OutOfOrderRequests(Fault):
    """An operator requests, in every tick, all modes that the present mode does not allow next."""

    def __init__(self) -> None:
        self._accepted: set[str] = set()

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Request all modes that the present mode does not allow next."""
        current = supervisor.mode
        allowed = {
            Mode.PASSIVE: (Mode.RISE,),
            Mode.RISE: (Mode.SIT,),
            Mode.STAND: (Mode.SIT, Mode.WALK),
            Mode.WALK: (Mode.SIT, Mode.STAND),
        }
        for mode in Mode:
            if mode in allowed.get(current, ()):
                continue
            if supervisor.request(mode) == RequestStatus.ACCEPTED:
                self._accepted.add(f"{mode.name} accepted in {current.name}")

    def problems(self) -> list[str]:
        """Return the requests that the supervisor accepted, as text."""
        return sorted(self._accepted)


class ConcurrentRequests(OutOfOrderRequests):
    """Four threads send the requests of OutOfOrderRequests at the same time, in 1 tick of 50."""

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Send the requests from four threads at the same time."""
        if k % 50:
            return
        request = super().operate
        threads = [threading.Thread(target=request, args=(supervisor, k)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
