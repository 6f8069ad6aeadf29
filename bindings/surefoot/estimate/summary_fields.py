"""Meaning of each field of a summary, for the report, the documentation and the tests."""

from __future__ import annotations

from surefoot.reports.summary_field import Field

_GROUPS: dict[str, tuple[tuple[str, str, str], ...]] = {
    "Log": (
        ("version", "", "version of Surefoot"),
        ("robot", "", "name of the robot"),
        ("file", "", "name of the log"),
        ("rows", "", "rows in the log"),
        ("duration", "s", "time from the first row to the last"),
        ("rate", "Hz", "inverse of the median step of the clock"),
        ("clock", "", "column that gives the time: tick or time"),
        ("columns_used", "", "columns that the estimator received"),
        ("columns_derived", "", "columns computed from others, and how"),
        ("columns_missing", "", "columns that the estimator received as zeros"),
        (
            "truth_columns",
            "",
            "ground truth, compared with the estimate; never reaches the estimator",
        ),
        ("ignored_columns", "", "names in the file that were not used"),
        ("warnings", "", "findings that make the log doubtful"),
        ("notes", "", "what the reader of the file converted or left out"),
        ("non_finite_rows", "", "rows with NaN or infinity, by column; the estimator rejects them"),
        ("duplicate_rows", "", "rows whose clock repeats the row before; skipped"),
        ("gaps", "", "steps longer than 0.1 s; the estimator receives 0.1 s instead"),
        ("longest_gap_s", "s", "longest step of the clock"),
        ("statuses", "", "number of rows by surefoot.Status of the estimator"),
        ("update_us", "us", "time of StateEstimator.update(): p50, p90, p99, max"),
    ),
    "End": (
        (
            "position",
            "m",
            "position of the base, world; the origin is below its first position, feet at 0",
        ),
        ("position_std", "m", "standard deviation of position"),
        ("velocity", "m/s", "velocity of the base, world axes"),
        ("velocity_std", "m/s", "standard deviation of velocity"),
        ("rpy_deg", "deg", "roll, pitch, yaw"),
        ("rpy_std_deg", "deg", "standard deviations of rpy_deg, to first order"),
        ("path_length", "m", "path length of the base, sampled every 0.1 s"),
        ("height_range", "m", "lowest and highest z of the base"),
        ("payload_kg", "kg", "mass beyond the model"),
        ("com_shift", "m", "centre of mass, loaded minus model, base axes"),
        (
            "friction",
            "",
            "friction coefficient of the ground, learnt from feet that slide and hold",
        ),
    ),
    "Sensors": (
        ("gyroscope_bias", "rad/s", "at the end, base axes"),
        ("gyroscope_bias_std", "rad/s", "standard deviation of gyroscope_bias"),
        ("accelerometer_bias", "m/s^2", "at the end, base axes"),
        ("accelerometer_bias_std", "m/s^2", "standard deviation of accelerometer_bias"),
        (
            "nis_per_dimension",
            "",
            "normalised innovation squared of all rows over its dimension: 1 where the noise is as "
            "large as modelled; null if no measurement was used",
        ),
        (
            "verdicts",
            "",
            "surefoot.SensorVerdict of each sensor: now (at the end) and share of time per verdict",
        ),
    ),
    "Contact": (
        (
            "contact",
            "",
            "per foot: transitions, and share of time with contact confidence above 0.5",
        ),
        ("contact_transitions", "", "time [s], foot, contact: true touch-down, false lift-off"),
        ("slip_events", "", "slips with confidence above 0.5: time [s], foot, duration [s]"),
        (
            "strides",
            "",
            "per foot, from touch-down to touch-down within 2 s: number, and medians of the stride "
            "time [s], the duty factor and the step length [m] in the plane; null without strides",
        ),
    ),
    "Truth": (
        (
            "velocity_rmse",
            "m/s",
            "norm of the velocity error, world axes, true heading used at the start; null, like "
            "all fields of this group, if the log has no truth_ columns for it",
        ),
        ("roll_pitch_rmse_deg", "deg", "roll error and pitch error"),
        ("height_error_range", "m", "lowest and highest error of z, relative to the start"),
        (
            "vertical_force_rmse",
            "",
            "per foot: vertical force from joint torques, as a share of the model weight",
        ),
        (
            "contact_delays",
            "",
            "per foot: true transitions, missed (not estimated from 0.1 s before to 0.3 s after), "
            "false (estimated without a true one), mean and max delay [s]",
        ),
    ),
    "Baselines": (
        (
            "baselines",
            "",
            "null without --baseline. For Surefoot (surefoot), a linear Kalman filter and leg "
            "odometry, both with the attitude of VQF: closure (horizontal distance from start to "
            "end) [m], height_drift (end minus start) [m], yaw_deg (end minus start), RMS "
            "differences to Surefoot of velocity [m/s] and tilt [deg], and RMS of velocity_error "
            "[m/s] against truth_v; velocities in the axes of the heading",
        ),
    ),
}

FIELDS: tuple[Field, ...] = tuple(
    Field(name, unit, meaning, group)
    for group, rows in _GROUPS.items()
    for name, unit, meaning in rows
)
"""Every field of surefoot.estimate.summarise(), in its order."""
