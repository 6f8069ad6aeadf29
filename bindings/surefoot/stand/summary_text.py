"""Summary of a run as a few lines of text."""

from __future__ import annotations

from typing import Any

from surefoot.sim import PlantSettings
from surefoot.stand.reference_request import AXES


def outcome_sentence(s: dict[str, Any]) -> str:
    """Return the outcome of a run in one sentence, from its summary."""
    if s["fell"]:
        return f"{s['robot']} fell after {s['fall_time_s']:g} s"
    end = "and settled" if s["settled"] else "but did not settle"
    return f"{s['robot']} stood {s['duration']:g} s {end}"


def conditions_line(s: dict[str, Any]) -> str:
    """Return the conditions of a run as one line."""
    parts = [
        f"{s['rate']:g} Hz",
        f"{s['sensors']} sensors",
        f"foot force {s['foot_force']}",
        f"friction {s['friction']:g}",
    ]
    if s["mjcf"] is not None:
        parts.append(f"robot and ground of '{s['mjcf']}'")
    if s["slope_deg"]:
        parts.append(f"slope {s['slope_deg']:g} deg towards {s['slope_heading_deg']:g} deg")
    if s["payload_kg"]:
        parts.append(f"payload {s['payload_kg']:g} kg")
    parts += _plant_deviations(s)
    if s["form"] != "auto":
        parts.append(f"{s['form']} form")
    if s["predict_ms"]:
        parts.append(f"{s['predict_ms']:g} ms predicted")
    if s["motor_damping"]:
        parts.append(f"motor damping {s['motor_damping']:g} N.m.s/rad")
    return ", ".join([*parts, f"seed {s['seed']}"])


def _plant_deviations(s: dict[str, Any]) -> list[str]:
    """Return the settings of motors and ground that differ from their defaults, as text."""
    usual_lag = 1000.0 * PlantSettings(sensors=s["sensors"]).lag
    flaws = (
        (s["soft_ground_sink"] > 0.0, f"ground soft by {1000.0 * s['soft_ground_sink']:g} mm"),
        (s["joint_friction_scale"] != 1.0, f"joint friction x {s['joint_friction_scale']:g}"),
        (s["armature_scale"] != 1.0, f"armature x {s['armature_scale']:g}"),
        (s["backlash_deg"] > 0.0, f"backlash {s['backlash_deg']:g} deg"),
        (s["motor_lag_ms"] != usual_lag, f"motor lag {s['motor_lag_ms']:g} ms"),
        (s["delay_ms"] > 0.0, f"delay {s['delay_ms']:g} ms"),
    )
    return [words for present, words in flaws if present]


def push_line(push: dict[str, Any]) -> str:
    """Return a push of a summary as text."""
    direction = push["direction"]
    name = direction if isinstance(direction, str) else f"at {direction:g} deg"
    share = push["lip_share"]
    of_limit = "" if share is None else f", {100 * share:.0f} % of the LIP push limit"
    height = f", {push['height_m']:+g} m above the centre of mass" if push["height_m"] else ""
    return (
        f"{name} {push['impulse_ns']:.2f} N.s in {push['duration_s']:g} s "
        f"at {push['time_s']:g} s{height}{of_limit}"
    )


def reference_line(reference: dict[str, Any]) -> str:
    """Return a reference of a summary as text."""
    offsets = []
    for axis, unit in AXES.items():
        if f"{axis}_{unit}" in reference:
            offsets.append(f"{axis} {reference[f'{axis}_{unit}']:+g} {unit}")
    return f"{', '.join(offsets)} at {reference['time_s']:g} s"


def summary_text(s: dict[str, Any]) -> str:
    """Return a summary as text."""
    lines = [("run", conditions_line(s)), *(("push", push_line(push)) for push in s["pushes"])]
    lines += [("requested", reference_line(reference)) for reference in s["references"]]
    if s["settle_time_s"] is not None:
        events = ("push" if s["pushes"] else "", "reference" if s["references"] else "")
        event = " or ".join(name for name in events if name)
        lines.append(("settled", f"{s['settle_time_s']:.2f} s after the last {event}"))
    if s["references"]:
        lines.append(("reached", reached_line(s)))
    lines += _motion_lines(s) + _loop_lines(s)
    return "\n".join([f"{outcome_sentence(s)}.", *(f"  {name:<9} {text}" for name, text in lines)])


def reached_line(s: dict[str, Any]) -> str:
    """Return the final distance from the requested pose, and any reach limit, as text."""
    error_text = (
        f"{s['reference_error_mm']:.2f} mm and {s['reference_error_deg']:.2f} deg from the request"
    )
    limit = s["reference_limit"]
    return error_text if limit == "none" else f"{error_text}, stopped by: {limit}"


def _motion_lines(s: dict[str, Any]) -> list[tuple[str, str]]:
    torque = "unknown" if s["torque_hf_rms"] is None else f"{s['torque_hf_rms']:.3f} N.m"
    return [
        (
            "pose",
            f"error {s['height_error_mm']:.2f} mm, {s['tilt_error_deg']:.2f} deg tilt, "
            f"{s['yaw_error_deg']:.2f} deg yaw; largest: {s['max_tilt_deg']:.1f} deg tilt, "
            f"feet {s['max_foot_travel_mm']:.1f} mm",
        ),
        (
            "still",
            f"last 2 s RMS: centre of mass {s['com_rms_mm']:.3f} mm, "
            f"joints {s['joint_velocity_rms']:.4f} rad/s, torque above 30 Hz {torque}",
        ),
        (
            "effort",
            f"peak torque {100 * s['peak_torque_ratio']:.0f} % of its limit, "
            f"peak power {s['peak_power_w']:.0f} W",
        ),
        (
            "estimate",
            f"RMSE: velocity {s['estimator_velocity_rmse']:.4f} m/s, "
            f"tilt {s['estimator_tilt_rmse_deg']:.3f} deg",
        ),
    ]


def _loop_lines(s: dict[str, Any]) -> list[tuple[str, str]]:
    tick = s["tick_us"]
    first = f" (first: {s['first_failure']})" if s["qp_failures"] else ""
    mode = "torque mode only" if s["torque_mode_only"] else "NOT torque mode only"
    saturated = f", {s['saturated_ticks']} saturated" if s["saturated_ticks"] else ""
    cold = f", {s['cold_solves']} cold solves" if s["cold_solves"] else ""
    return [
        ("loop", f"{s['ticks']} ticks, {s['qp_failures']} failed{first}{cold}{saturated}, {mode}"),
        (
            "tick",
            f"{tick['p50']:.0f} us median, {tick['p90']:.0f} p90, {tick['p99']:.0f} p99, "
            f"{tick['max']:.0f} max",
        ),
    ]
