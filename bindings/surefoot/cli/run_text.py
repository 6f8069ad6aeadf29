"""Text of surefoot run: status lines, warnings and the summary."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from surefoot._core import RiseStage, Robot, RunSnapshot, WalkLimit, fault_table
from surefoot.messages.low_state_layout import LEGS

_GROUND_STAGE_TEXT = {
    RiseStage.HOLD_LEGS: "holding the legs",
    RiseStage.FOLD: "folding the legs",
    RiseStage.WEIGH: "weighing the legs",
    RiseStage.PRESS: "pressing with the rear legs",
}
_FAULTS_OF_TIME = {"clock", "frozen", "link", "stale_tick"}  # a slow simulator causes them
MOTOR_NAMES = [f"{leg}_{joint}" for leg in LEGS for joint in range(3)]


class LinkWarnings:
    """Printer of a warning for each kind of unexpected datagram; each kind is printed once."""

    def __init__(self, print_line: Callable[[str], None]) -> None:
        self._print_line, self._printed = print_line, set[str]()

    def update(self, snapshot: RunSnapshot) -> None:
        """Print the kinds of link errors that `snapshot` counts for the first time."""
        link = snapshot.link
        warnings = {
            "another sender uses this port; its datagrams are ignored": link.strangers,
            "more datagrams arrive than a tick reads: the peer sends too fast": link.floods,
            f"a datagram was rejected: {snapshot.last_reject}": (
                link.corrupt + link.wrong_length + link.wrong_generation
            ),
            "sending failed: check the network route": link.send_failed,
        }
        for text, count in warnings.items():
            kind = text.split(":")[0]
            if count and kind not in self._printed:
                self._printed.add(kind)
                self._print_line(f"{snapshot.time:7.2f} s {text}")


class FaultMonitor:
    """Printer of faults that the supervisor detects, each time a fault begins."""

    def __init__(self, print_line: Callable[[str], None]) -> None:
        self._print_line, self._counts = print_line, dict[str, int]()

    def update(self, snapshot: RunSnapshot) -> None:
        """Print the faults that began since the last call."""
        for info in fault_table():
            count = snapshot.faults.count(info.id)
            if count > self._counts.get(info.name, 0):
                motor = snapshot.faults.motor(info.id)
                where = f" at {MOTOR_NAMES[motor]}" if motor >= 0 else ""
                self._print_line(f"{snapshot.time:7.2f} s fault {info.name}{where}: {info.meaning}")
            self._counts[info.name] = count


def status_line(snapshot: RunSnapshot) -> str:
    """Return the state of the robot and the link in one line."""
    link = snapshot.link
    detail = ""  # height and tilt exist only while the stand controller estimates them
    if snapshot.phase in ("standing", "walking"):
        detail = walk_text(snapshot) if snapshot.phase == "walking" else ""
        detail += f"height {snapshot.height:.3f} m, tilt {math.degrees(snapshot.tilt):.1f} deg, "
    elif snapshot.phase in ("rising", "sitting"):
        progress = f"{100 * snapshot.rise_progress:.0f} % of the way up, "
        detail = (
            progress
            if snapshot.rise_stage == RiseStage.UP
            else f"{_GROUND_STAGE_TEXT[snapshot.rise_stage]}, "
        )
    elif snapshot.phase == "passive":
        detail = "armed, " if snapshot.armed else "not armed, "
    return (
        f"{snapshot.time:7.2f} s {snapshot.phase:8} {detail}power "
        f"{snapshot.measured_power:.0f} W; states {link.valid}, lost "
        f"{link.lost}, bad {link.corrupt + link.wrong_length + link.wrong_generation}, age "
        f"{1000 * snapshot.state_age:.0f} ms; tick {snapshot.tick_p50:.0f} us, "
        f"{snapshot.tick_p999:.0f} p99.9"
    )


def walk_text(snapshot: RunSnapshot) -> str:
    """Return the velocity of a walking robot, and the limit to which it was clamped."""
    actual, limit = snapshot.reference_velocity, snapshot.velocity_limit
    text = f"{actual.vx:.2f} {actual.vy:.2f} m/s {actual.yaw_rate:.2f} rad/s, "
    text += f"gait {snapshot.gait.name.lower()}, "
    text += f"limited ({limit.name.lower()}), " if limit != WalkLimit.NONE else ""
    return text + ("stopping, " if snapshot.stopping else "")


def run_summary(end: RunSnapshot, robot: Robot, generation: str, real_time: str) -> dict[str, Any]:
    """Return the summary of the run that --json writes, as JSON values."""
    names = [name for name in dir(end.link) if not name.startswith("_")]
    times = [name for name in dir(end) if name.startswith(("tick_", "wake_"))]
    return {
        "generation": generation,
        "phase": end.phase,
        "reason": end.reason,
        "mode": end.mode.name,
        "damping": end.damping_fault.name,
        "faults": {
            info.name: end.faults.count(info.id)
            for info in fault_table()
            if end.faults.count(info.id)
        },
        "armed": end.armed,
        "stood": end.stood,
        "stood_to_end": end.stood_to_end,
        "not_ready": end.arming.failures(robot).splitlines(),
        "stuck": end.rise_failed,
        "fault": end.controller_fault.name,
        "reject": end.last_reject,
        "rejected_frame": end.rejected_frame,
        "time_s": end.time,
        "ticks": end.ticks,
        "usable_ticks": end.usable_ticks,
        "bridged_ticks": end.ticks_without_state,
        "saturated_ticks": end.saturated_ticks,
        "missed_periods": end.missed_periods,
        "dampings": end.dampings,
        "pauses": end.resumed_dampings,
        "rearms": end.rearms,
        "refused_rearms": end.refused_rearms,
        "greatest_power_w": end.greatest_power,
        "height_m": end.height,
        "tilt_deg": math.degrees(end.tilt),
        "age_s": end.state_age if math.isfinite(end.state_age) else None,
        "link": {name: getattr(end.link, name) for name in names},
        "us": {name: getattr(end, name) for name in times},
        "real_time": real_time,
    }


def closing_text(result: dict[str, Any]) -> str:
    """Return the result of run_summary() as text for the operator."""
    us, link = result["us"], result["link"]
    faults = ", ".join(f"{name} {count}" for name, count in result["faults"].items()) or "none"
    return (
        f"ended after {result['time_s']:.2f} s: {result['reason']}; {result['ticks']} ticks, "
        f"{result['bridged_ticks']} without a new state, "
        f"{result['ticks'] - result['usable_ticks'] - result['bridged_ticks']} failed, "
        f"{result['missed_periods']} periods missed\n"
        f"  robot {'stood to the end' if result['stood_to_end'] else 'did not stand to the end'}, "
        f"power up to {result['greatest_power_w']:.0f} W, faults {faults}\n"
        f"  link  {link['valid']} states, {link['lost']} lost, {link['late']} late, "
        f"{link['duplicate']} duplicate, {link['reordered']} reordered, {link['corrupt']} corrupt, "
        f"{link['wrong_generation']} of another generation, "
        f"{link['strangers']} from other senders, {link['floods']} floods\n"
        f"  tick  {us['tick_p50']:.0f} us median, {us['tick_p90']:.0f} p90, {us['tick_p99']:.0f} "
        f"p99, {us['tick_p999']:.0f} p99.9, {us['tick_max']:.0f} max; woken {us['wake_p50']:.0f} "
        f"us late, {us['wake_p99']:.0f} p99, {us['wake_max']:.0f} max\n"
        f"  {result['real_time']}"
    )


def slow_simulator_text(result: dict[str, Any]) -> str:
    """Return a hint if a run with the tick from arrival ended by a fault of time, else ""."""
    if result["stood_to_end"] or not _FAULTS_OF_TIME & set(result["faults"]):
        return ""
    return (
        "--tick arrival takes the time from this computer: the faults above may mean that the "
        "simulator stalls or does not run in real time"
    )


def lying_text(end: RunSnapshot) -> str:
    """Return the reason why a lying robot was not taken over, as text for the operator."""
    return (
        f"--rise: got none and a robot that lies (base {end.height:.3f} m above its feet), "
        "expected a standing robot; use --rise"
    )


def no_robot_text(where: str, end: RunSnapshot, generation: str) -> str:
    """Return the reason why no robot was controlled, as text for the operator."""
    if end.reason == "wrong_generation":
        frame = end.rejected_frame
        remedy = f"use --sdk {frame['generation']}" if frame else "see --sdk"
        return f"the robot at {where} does not use {generation}: {end.last_reject}; {remedy}"
    if end.link.received:
        return f"no valid LowState from {where}: {end.last_reject}"
    if where.startswith("rt/"):
        return (
            f"no answer from {where}: check --domain and --interface, and that the robot is on; "
            f"for a simulation use: surefoot robot --sdk {generation}"
        )
    if where.startswith("127."):
        return f"no answer from {where}; start a virtual robot with surefoot robot"
    return (
        f"no answer from {where}: check cable, address and port, low-level mode of the robot, and "
        f"--local-port if the robot answers to a fixed port"
    )
