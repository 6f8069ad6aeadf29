"""Why the robot damps, in words for an operator."""

from __future__ import annotations

from surefoot._core import RunSnapshot


def damping_reason(snapshot: RunSnapshot) -> str:
    """Return what the damping is for."""
    if snapshot.reason == "stale":
        return f"stale: no LowState for {1000 * snapshot.silence_time:.0f} ms"
    if snapshot.reason == "away":
        return f"away: this program stood still for {1000 * snapshot.silence_time:.0f} ms"
    if snapshot.reason == "controller":
        return f"the controller found {snapshot.controller_fault.name}"
    if snapshot.reason == "power_protect":
        return f"power protection: {snapshot.power_at_damping:.0f} W"
    if snapshot.reason == "fault":
        return f"the supervisor found {snapshot.damping_fault.name.lower()}"
    return snapshot.reason
