"""Text for the terminal about the summary of an estimate."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from surefoot.sensor_log.column_definitions import CLOCK_COLUMNS

# Chosen for a line that a person reads; a dump of a whole LowState has 200 other names.
MAX_IGNORED_NAMES = 12  # largest number of ignored columns in a line; the summary has all


def headline(s: dict[str, Any]) -> str:
    """Return one sentence with robot, rows and duration."""
    accepted = s["statuses"].get("OK", 0)
    return f"{s['robot']}: {accepted} of {s['rows']} rows estimated over {s['duration']:.3g} s"


def log_line(s: dict[str, Any]) -> str:
    """Return one line with rate, missing columns and gaps of the log."""
    parts = [f"{s['file']}", f"{s['rate']:.4g} Hz by {s['clock']}"]
    if s["columns_missing"]:
        parts.append(f"without {', '.join(s['columns_missing'])}")
    parts += [f"{name} derived" for name in s["columns_derived"]]
    if s["duplicate_rows"]:
        parts.append(f"{s['duplicate_rows']} repeated rows")
    if s["gaps"]:
        parts.append(f"{s['gaps']} gaps, up to {s['longest_gap_s']:.3g} s")
    return ", ".join(parts)


def warning_lines(s: dict[str, Any]) -> list[str]:
    """Return one line for each warning, and for ignored columns, rejected rows and bad rows."""
    lines = list(s["warnings"])
    ignored = [
        name for name in s["ignored_columns"] if name not in CLOCK_COLUMNS
    ]  # no warning about a second clock
    if ignored:
        more = len(ignored) - MAX_IGNORED_NAMES
        names = [*ignored[:MAX_IGNORED_NAMES], *[f"and {more} more"] * (more > 0)]
        lines.append(f"ignored columns: {', '.join(names)}")
    refused = {name: count for name, count in s["statuses"].items() if name != "OK"}
    lines += [f"{count} rows {name}" for name, count in refused.items()]
    lines += [f"{n} rows of {name} not finite" for name, n in s["non_finite_rows"].items()]
    return lines


def bad_sensors(s: dict[str, Any]) -> list[str]:
    """Return the sensors whose last verdict is neither GOOD nor UNJUDGED, with the verdict."""
    verdicts = {name: verdict["now"] for name, verdict in s["verdicts"].items()}
    bad = {name: word for name, word in verdicts.items() if word not in ("GOOD", "UNJUDGED")}
    return [f"{name} {word}" for name, word in bad.items()]


def summary_text(s: dict[str, Any]) -> str:
    """Return the summary as a few lines of text."""
    lines = [("log", log_line(s)), *(("warning", text) for text in warning_lines(s))]
    lines += [
        ("end", f"position {values_with_std(s['position'], s['position_std'], 'm', 3)}"),
        ("", f"velocity {values_with_std(s['velocity'], s['velocity_std'], 'm/s', 3)}"),
        ("", f"roll pitch yaw {values_with_std(s['rpy_deg'], s['rpy_std_deg'], 'deg', 2)}"),
    ]
    bad = bad_sensors(s)
    lines.append(("sensors", ", ".join(bad) if bad else "no bad ones found"))
    changes = len(s["contact_transitions"])
    lines.append(("contact", f"{changes} transitions, {len(s['slip_events'])} slips"))
    lines += [("strides" if k == 0 else "", text) for k, text in enumerate(stride_lines(s))]
    lines += [("baselines" if k == 0 else "", text) for k, text in enumerate(baseline_lines(s))]
    if s["velocity_rmse"] is not None:
        lines.append(("truth", f"RMSE: velocity {s['velocity_rmse']:.4f} m/s"))
    if s["update_us"] is not None:
        lines.append(("update", f"{s['update_us']['p50']:.1f} us median"))
    return "\n".join([f"{headline(s)}.", *(f"  {name:<9} {text}" for name, text in lines)])


def stride_lines(s: dict[str, Any]) -> list[str]:
    """Return one line for each foot that made strides."""
    return [
        f"{foot} {v['strides']} of {v['stride_time_s']:.3f} s, duty {v['duty']:.2f}, "
        f"step {v['step_length_m']:.3f} m"
        for foot, v in s["strides"].items()
        if v["strides"]
    ]


def baseline_lines(s: dict[str, Any]) -> list[str]:
    """Return one line for the estimator and for each baseline; none without baselines."""
    return [
        f"{name.replace('_', ' ')}: closure {v['closure']:.3f} m, "
        f"height {v['height_drift']:+.3f} m, yaw {v['yaw_deg']:+.1f} deg, "
        f"velocity differs by {v['velocity_difference']:.3f} m/s, "
        f"tilt by {v['tilt_difference_deg']:.2f} deg"
        for name, v in (s["baselines"] or {}).items()
    ]


def values_with_std(
    values: Sequence[float | None], std: Sequence[float | None], unit: str, n: int
) -> str:
    """Return values with their standard deviations as text."""
    if any(value is None for value in [*values, *std]):
        return "unknown"
    value_texts = ", ".join(f"{v:.{n}f} +- {s:.{n}f}" for v, s in zip(values, std, strict=True))
    return f"{value_texts} {unit}"
