"""Name, unit, meaning and group of each summary field, for report, documentation and tests."""

from __future__ import annotations

from dataclasses import replace

from surefoot.reports.summary_field import Field
from surefoot.stand.summary_fields import FIELDS as STAND_FIELDS

_WALK_CONDITIONS = (
    (
        "gait",
        "",
        "auto: stand at velocity 0, trot otherwise; trot; walk: like auto, one foot at a time",
    ),
    ("walking_sensors", "", "true: real sensors with the errors that walking adds"),
    ("soft_soles", "", "true: soft soles, false: rigid ones"),
    ("leg_collisions", "", "true: legs collide even where the SRDF disables it"),
    ("step_height", "m", "height of the platform ahead of the robot; 0: none"),
    ("step_heading_deg", "deg", "angle by which the edges of the platform are turned to the left"),
    ("stairs_height", "m", "height of each step of the stairs ahead, up and down; 0: none"),
    ("stairs_tread", "m", "length of each step of the stairs"),
    ("block_height", "m", "largest height of the blocks ahead; 0: none"),
    ("lost_frames", "%", "share of LowStates and of LowCmds lost"),
)
Row = tuple[str, str, str] | str
"""Name, unit and meaning of a field; or the name of a field of a stand, with the same meaning."""

_GROUPS: dict[str, tuple[Row, ...]] = {
    "Outcome": (
        "fell",
        "fall_time_s",
        (
            "stands_at_end",
            "",
            "last 0.5 s: no steps, four loaded feet, base slower than 0.05 m/s",
        ),
        "reference_limit",
        (
            "stance_error_mm",
            "mm",
            "at the end: largest distance of a foot from its place in the standing pose, relative "
            "to mean and heading of the feet",
        ),
        (
            "path_error_m",
            "m",
            "at the end: distance of the centre of mass from the integrated command, which has "
            "neither acceleration nor pushes",
        ),
        ("heading_error_deg", "deg", "at the end: difference from the integrated command"),
    ),
    "Velocity, worst command": (
        (
            "velocity_mean_error",
            "m/s, m/s, rad/s",
            "vx, vy of the centre of mass and yaw rate in the heading frame: absolute value of the "
            "mean error against the clamped command, from 1 s after a command to the next one; "
            "each axis has its worst command",
        ),
        ("velocity_rmse", "m/s, m/s, rad/s", "RMS of the same error"),
        (
            "roll_pitch_rms_deg",
            "deg",
            "RMS of roll and of pitch relative to the ground plane and the body reference",
        ),
        (
            "three_or_more_loaded",
            "",
            "share of the ticks with at least three feet that carry 5 % of the weight each; the "
            "smallest of all commands",
        ),
        (
            "cost_of_transport",
            "",
            "sum of the positive joint powers / (weight x speed); null below 0.1 m/s",
        ),
        "torque_hf_rms",
        (
            "commands",
            "",
            "the same figures for each command, with its time [s], the velocity as requested and "
            "as clamped, and the limit, a WalkLimit in lower case",
        ),
    ),
    "Feet": (
        ("steps", "", "touchdowns of all feet"),
        (
            "slip_mm_per_step",
            "mm",
            "mean path of a foot's contact point along the ground while its load exceeds 5 % of "
            "the weight; rolling of the foot does not count; null without steps",
        ),
        (
            "touchdown_force_mg",
            "m g",
            "largest normal force of a foot within 30 ms after its touchdown, at the ends of ticks",
        ),
        (
            "leg_contacts",
            "",
            "how often a leg began to touch another leg or the trunk, at the ends of ticks",
        ),
    ),
}
_LOOP: tuple[Row, ...] = (
    "ticks",
    ("failed_ticks", "", "ticks that ended at a fallback level: not solved at the first attempt"),
    ("fallback_levels", "", "number of ticks that ended at each FallbackLevel"),
    "saturated_ticks",
    "torque_mode_only",
    "iterations",
    (
        "tick_us",
        "us",
        "CPU time of update() as called from Python: p50, p90, p99, p99.9, max",
    ),
)


def _fields(group: str, rows: tuple[Row, ...]) -> tuple[Field, ...]:
    stand = {field.name: field for field in STAND_FIELDS}
    return tuple(
        replace(stand[row], group=group) if isinstance(row, str) else Field(*row, group)
        for row in rows
    )


def _stand_fields(group: str) -> tuple[Field, ...]:
    """Return the fields of a group that a stand has too."""
    return tuple(f for f in STAND_FIELDS if f.group == group)


FIELDS: tuple[Field, ...] = (
    *_stand_fields("Conditions"),
    *_fields("Conditions", _WALK_CONDITIONS),
    *(field for group, rows in _GROUPS.items() for field in _fields(group, rows)),
    *_stand_fields("Effort"),
    *_stand_fields("Estimator"),
    *_fields("Loop", _LOOP),
)
"""All fields that surefoot.walk.summarise() returns, in the same order."""
