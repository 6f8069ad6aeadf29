"""Text that explains to an operator why a request was refused."""

from __future__ import annotations

from surefoot._core import ArmingCheck, FaultReaction, Mode, RequestStatus, RunSnapshot, fault_table

_REASONS = {
    RequestStatus.NO_STATE: "no valid LowState arrives: check the robot and the network",
    RequestStatus.NOT_ARMED: "not armed",
    RequestStatus.LATCHED: "damping is latched",
    RequestStatus.BUSY: "busy: another request is pending, the robot stops walking, or torques "
    "fade; try again",
    RequestStatus.CANNOT_WALK: "the motors cannot carry this robot on two feet",
}


def refusal_reason(status: RequestStatus, snapshot: RunSnapshot) -> str:
    """Return why a request was refused; "" if it was accepted.

    Args:
        status: Answer to the request.
        snapshot: State of the runner at about the time of the request.
    """
    if status == RequestStatus.NOT_READY:
        return _not_ready(snapshot)
    if status == RequestStatus.OUT_OF_ORDER:
        return f"not while {snapshot.phase}"
    return _REASONS.get(status, "")


def is_failing(check: ArmingCheck) -> bool:
    """Return whether a check prevents arming."""
    return bool(check.applies and not check.passed)


def _not_ready(snapshot: RunSnapshot) -> str:
    stops = {
        info.id: info.name
        for info in fault_table()
        if info.stops_walking or info.reaction == FaultReaction.SIT
    }
    active = [stops[id] for id in snapshot.faults.active if id in stops]
    if snapshot.mode != Mode.PASSIVE and active:
        return f"fault {', '.join(active)}"
    failing = [name for name, check in snapshot.arming.checks.items() if is_failing(check)]
    if failing:
        return f"arming checks fail: {', '.join(failing)}"
    return f"arming checks have passed for {snapshot.arming.passed_for:.1f} s, expected 1 s"
