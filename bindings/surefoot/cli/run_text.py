"""What surefoot run says: lines for people, a summary for programs."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from surefoot._core import RiseStage, Robot, RunSnapshot, fault_table
from surefoot.low_state_layout import LEGS

_ON_THE_GROUND = {
    RiseStage.HOLD_LEGS: "legs hold themselves",
    RiseStage.FOLD: "legs fold",
    RiseStage.WEIGH: "legs are weighed",
    RiseStage.PRESS: "rear legs press",
}
MOTORS = [f"{leg}_{joint}" for leg in LEGS for joint in range(3)]


class Notices:
    """Says once, when it is seen first, what should not be on the wire."""

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say, self._said = say, set[str]()

    def look(self, now: RunSnapshot) -> None:
        """Look at the counts."""
        link = now.link
        odd = {
            "someone else sends to our port; not listened to": link.strangers,
            "more datagrams wait than are read in a tick: the peer floods": link.floods,
            f"a datagram was not taken: {now.reject}": link.corrupt + link.wrong_length,
            "the system does not send: is there a route?": link.send_failed,
        }
        for text, count in odd.items():
            kind = text.split(":")[0]
            if count and kind not in self._said:
                self._said.add(kind)
                self._say(f"{now.time:7.2f} s {text}")


class Faults:
    """Says what the supervisor finds wrong, as often as it begins."""

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say, self._counts = say, dict[str, int]()

    def look(self, now: RunSnapshot) -> None:
        """Look at the faults."""
        for info in fault_table():
            count = now.faults.count(info.id)
            if count > self._counts.get(info.name, 0):
                motor = now.faults.motor(info.id)
                where = f" at {MOTORS[motor]}" if motor >= 0 else ""
                self._say(f"{now.time:7.2f} s fault {info.name}{where}: {info.meaning}")
            self._counts[info.name] = count


def why_damped(now: RunSnapshot) -> str:
    """Return what the damping is for."""
    if now.reason == "stale":
        return f"stale: no LowState for {1000 * now.gap:.0f} ms"
    if now.reason == "away":
        return f"away: this program stood still for {1000 * now.gap:.0f} ms"
    if now.reason == "controller":
        return f"the controller found {now.fault.name}"
    if now.reason == "power_protect":
        return f"power protection: {now.damped_power:.0f} W"
    if now.reason == "fault":
        return f"the supervisor found {now.damping.name.lower()}"
    return now.reason


def status_line(now: RunSnapshot) -> str:
    """Return how it is, on one line."""
    link = now.link
    how = ""  # height and tilt are the controller's, which knows them while it stands
    if now.phase == "standing":
        how = f"height {now.height:.3f} m, tilt {math.degrees(now.tilt):.1f} deg, "
    elif now.phase in ("rising", "sitting"):
        way = f"{100 * now.way_up:.0f} % of the way up, "
        how = way if now.stage == RiseStage.UP else f"{_ON_THE_GROUND[now.stage]}, "
    elif now.phase == "passive":
        how = "armed, " if now.armed else "not armed, "
    return (
        f"{now.time:7.2f} s {now.phase:8} {how}power {now.power:.0f} W; states {link.valid}, lost "
        f"{link.lost}, bad {link.corrupt + link.wrong_length + link.wrong_generation}, age "
        f"{1000 * now.age:.0f} ms; tick {now.tick_p50:.0f} us, {now.tick_p999:.0f} p99.9"
    )


def run_summary(end: RunSnapshot, robot: Robot, generation: str, real_time: str) -> dict[str, Any]:
    """Return what --json writes."""
    names = [name for name in dir(end.link) if not name.startswith("_")]
    times = [name for name in dir(end) if name.startswith(("tick_", "wake_"))]
    return {
        "generation": generation,
        "phase": end.phase,
        "reason": end.reason,
        "mode": end.mode.name,
        "damping": end.damping.name,
        "faults": {
            info.name: end.faults.count(info.id)
            for info in fault_table()
            if end.faults.count(info.id)
        },
        "armed": end.armed,
        "stood": end.stood,
        "stood_to_end": end.stood_to_end,
        "not_ready": end.arming.failures(robot).splitlines(),
        "stuck": end.stuck,
        "fault": end.fault.name,
        "reject": end.reject,
        "time_s": end.time,
        "ticks": end.ticks,
        "usable_ticks": end.usable,
        "bridged_ticks": end.bridged,
        "saturated_ticks": end.saturated,
        "missed_periods": end.missed,
        "dampings": end.dampings,
        "pauses": end.pauses,
        "rearms": end.rearms,
        "refused_rearms": end.refused_rearms,
        "greatest_power_w": end.greatest_power,
        "height_m": end.height,
        "tilt_deg": math.degrees(end.tilt),
        "age_s": end.age if math.isfinite(end.age) else None,
        "link": {name: getattr(end.link, name) for name in names},
        "us": {name: getattr(end, name) for name in times},
        "real_time": real_time,
    }


def closing_text(result: dict[str, Any]) -> str:
    """Return the summary for people."""
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
        f"{link['strangers']} from strangers, {link['floods']} floods\n"
        f"  tick  {us['tick_p50']:.0f} us median, {us['tick_p90']:.0f} p90, {us['tick_p99']:.0f} "
        f"p99, {us['tick_p999']:.0f} p99.9, {us['tick_max']:.0f} max; woken {us['wake_p50']:.0f} "
        f"us late, {us['wake_p99']:.0f} p99, {us['wake_max']:.0f} max\n"
        f"  {result['real_time']}"
    )


def no_robot_text(where: str, end: RunSnapshot, generation: str) -> str:
    """Return why no robot was controlled."""
    if end.reason == "wrong_generation":
        return f"the robot at {where} does not speak {generation}: {end.reject}; see --sdk"
    if end.link.received:
        return f"no valid LowState from {where}: {end.reject}"
    if where.startswith("127."):
        return f"nobody answers at {where}; a virtual robot is started with surefoot robot"
    return (
        f"nobody answers at {where}: cable, address and port, low level on the robot, --local-port "
        f"if it answers to a port of its own choice"
    )
