"""Summary of a walk as a few lines of text."""

from __future__ import annotations

from typing import Any

from surefoot.stand.summary_text import conditions_line, push_line, reference_line


def outcome_sentence(s: dict[str, Any]) -> str:
    """Return the outcome of a walk in one sentence, from its summary."""
    if s["fell"]:
        return f"{s['robot']} fell after {s['fall_time_s']:g} s"
    end = "stands at the end" if s["stands_at_end"] else "walks at the end"
    return f"{s['robot']} walked {s['duration']:g} s and {end}"


def walk_conditions_line(s: dict[str, Any]) -> str:
    """Return the conditions of a walk as one line."""
    soles = "soft soles" if s["soft_soles"] else "rigid soles"
    parts = [f"gait {s['gait']}", soles, *_terrain_words(s)]
    if s["lost_frames"]:
        parts.append(f"{s['lost_frames']:g} % of frames lost")
    return ", ".join([*parts, conditions_line(s)])


def _terrain_words(s: dict[str, Any]) -> list[str]:
    if s["step_height"]:
        heading = s["step_heading_deg"]
        turned = f", edges turned by {heading:g} deg" if heading else ""
        return [f"platform of {100.0 * s['step_height']:g} cm{turned}"]
    if s["stairs_height"]:
        tread = 100.0 * s["stairs_tread"]
        return [f"stairs of {100.0 * s['stairs_height']:g} cm with treads of {tread:g} cm"]
    if s["block_height"]:
        return [f"blocks up to {100.0 * s['block_height']:g} cm"]
    return []


def command_line(command: dict[str, Any]) -> str:
    """Return a command of a summary as text, with the limit to which it was clamped."""
    vx, vy, yaw_rate = command["velocity"]
    text = f"{vx:g}, {vy:g} m/s, {yaw_rate:g} rad/s at {command['time']:g} s"
    if command["limit"] != "none":
        vx, vy, yaw_rate = command["commanded_velocity"]
        text += f", limited ({command['limit']}) to {vx:.3g}, {vy:.3g} m/s, {yaw_rate:.3g} rad/s"
    if command["velocity_rmse"] is None:
        return f"{text}: too short for figures"
    return f"{text}: {_error_text(command)}"


def summary_text(s: dict[str, Any]) -> str:
    """Return a summary as text."""
    lines = [("run", walk_conditions_line(s))]
    lines += [("push", push_line(push)) for push in s["pushes"]]
    lines += [("requested", reference_line(reference)) for reference in s["references"]]
    lines += [("velocity", command_line(command)) for command in s["commands"]]
    lines += [("body", text) for text in _body_text(s)]
    lines += [("end", _end_text(s)), ("feet", _feet_text(s)), ("effort", _effort_text(s))]
    lines += [("estimate", _estimate_text(s)), *_loop_lines(s)]
    return "\n".join([f"{outcome_sentence(s)}.", *(f"  {name:<9} {text}" for name, text in lines)])


def _error_text(s: dict[str, Any]) -> str:
    mean, rmse = (
        "{:.3f}, {:.3f}, {:.3f}".format(*s[k]) for k in ("velocity_mean_error", "velocity_rmse")
    )
    return f"mean error {mean}, RMSE {rmse}"


def _body_text(s: dict[str, Any]) -> list[str]:
    if s["roll_pitch_rms_deg"] is None:
        return []
    roll, pitch = s["roll_pitch_rms_deg"]
    torque = "unknown" if s["torque_hf_rms"] is None else f"{s['torque_hf_rms']:.2f} N.m"
    text = f"RMS: roll {roll:.2f} deg, pitch {pitch:.2f} deg, torque above 30 Hz {torque}"
    limit = s["reference_limit"]
    return [text] if limit == "none" else [text, f"reference limited by {limit}"]


def _end_text(s: dict[str, Any]) -> str:
    return (
        f"{s['path_error_m']:.2f} m and {s['heading_error_deg']:.1f} deg from the integrated "
        f"command, feet within {s['stance_error_mm']:.1f} mm of the standing pose"
    )


def _feet_text(s: dict[str, Any]) -> str:
    contacts = f"{s['leg_contacts']} leg contacts"
    if s["slip_mm_per_step"] is None:
        return f"no steps, {contacts}"
    return (
        f"{s['steps']} steps, slip {s['slip_mm_per_step']:.2f} mm per step, touchdown up to "
        f"{s['touchdown_force_mg']:.2f} m g, {_loaded_text(s)}{contacts}"
    )


def _loaded_text(s: dict[str, Any]) -> str:
    share = s["three_or_more_loaded"]
    return "" if share is None else f"three feet loaded in {100 * share:.1f} % of ticks, "


def _effort_text(s: dict[str, Any]) -> str:
    transport = s["cost_of_transport"]
    text = "" if transport is None else f", cost of transport {transport:.2f}"
    return (
        f"peak torque {100 * s['peak_torque_ratio']:.0f} % of its limit, "
        f"peak power {s['peak_power_w']:.0f} W{text}"
    )


def _estimate_text(s: dict[str, Any]) -> str:
    return (
        f"RMSE: velocity {s['estimator_velocity_rmse']:.4f} m/s, "
        f"tilt {s['estimator_tilt_rmse_deg']:.3f} deg"
    )


def _loop_lines(s: dict[str, Any]) -> list[tuple[str, str]]:
    tick = s["tick_us"]
    mode = "torque mode only" if s["torque_mode_only"] else "NOT torque mode only"
    return [
        (
            "loop",
            f"{s['ticks']} ticks, {s['failed_ticks']} failed, {s['saturated_ticks']} saturated, "
            f"{mode}",
        ),
        (
            "tick",
            f"{tick['p50']:.0f} us median of CPU time, {tick['p99']:.0f} p99, "
            f"{tick['p99.9']:.0f} p99.9, {tick['max']:.0f} max",
        ),
    ]
