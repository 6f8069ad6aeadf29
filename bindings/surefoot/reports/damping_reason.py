"""Text that explains to an operator why the robot damps."""

from __future__ import annotations

from surefoot._core import RunSnapshot


def damping_reason(snapshot: RunSnapshot) -> str:
    """Return why the robot last damped, with the fault, the power or the time as the cause."""
    if snapshot.reason == "stale":
        return f"stale: no LowState for {1000 * snapshot.silence_time:.0f} ms"
    if snapshot.reason == "away":
        return f"away: this process stalled for {1000 * snapshot.silence_time:.0f} ms"
    if snapshot.reason == "controller":
        return f"the controller detected {snapshot.controller_fault.name}"
    if snapshot.reason == "power_protect":
        return f"power protection: {snapshot.power_at_damping:.0f} W"
    if snapshot.reason == "fault":
        return f"the supervisor detected {snapshot.damping_fault.name.lower()}"
    if snapshot.reason == "conflict":
        return "conflict: another program commands the robot, or a second robot sends LowStates"
    return snapshot.reason
