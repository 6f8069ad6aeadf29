"""What each number of a summary means, said once: for the report, the documentation, the tests."""

from __future__ import annotations

from surefoot.reports.summary_field import Field

_GROUPS: dict[str, tuple[tuple[str, str, str], ...]] = {
    "Log": (
        ("version", "", "of Surefoot"),
        ("robot", "", "name of the robot"),
        ("file", "", "the log"),
        ("rows", "", "rows in it"),
        ("duration", "s", "from its first row to its last"),
        ("rate", "Hz", "one over the median step of its clock"),
        ("clock", "", "the column that time is from: tick or time"),
        ("columns_used", "", "columns that the estimator got"),
        ("columns_derived", "", "columns made from others, and how"),
        ("columns_missing", "", "columns that the estimator got as zeros"),
        ("truth_columns", "", "columns that judge the estimate and never reach the estimator"),
        ("ignored_columns", "", "names in the file that nothing was made of"),
        ("warnings", "", "what is doubtful about the log"),
        ("non_finite_rows", "", "rows with NaN or infinity, by column; the estimator refuses them"),
        ("duplicate_rows", "", "rows whose clock repeats the row before; skipped"),
        ("gaps", "", "steps longer than 0.1 s, of which the estimator is told 0.1 s"),
        ("longest_gap_s", "s", "longest step of the clock"),
        ("statuses", "", "rows by what the estimator said of them: surefoot.Status"),
        ("update_us", "us", "time of StateEstimator.update(): p50, p90, p99, max"),
    ),
    "End": (
        ("position", "m", "of the base in the world, which begins below it, feet at height 0"),
        ("position_std", "m", "its standard deviation"),
        ("velocity", "m/s", "of the base, world axes"),
        ("velocity_std", "m/s", "its standard deviation"),
        ("rpy_deg", "deg", "roll, pitch, yaw"),
        ("rpy_std_deg", "deg", "their standard deviations, to first order"),
        ("path_length", "m", "of the base, corners every 0.1 s"),
        ("height_range", "m", "lowest and highest z of the base"),
        ("payload_kg", "kg", "more than the model has"),
        ("com_shift", "m", "from the model's centre of mass to the loaded one, base axes"),
    ),
    "Sensors": (
        ("gyroscope_bias", "rad/s", "at the end, base axes"),
        ("gyroscope_bias_std", "rad/s", "its standard deviation"),
        ("accelerometer_bias", "m/s^2", "at the end, base axes"),
        ("accelerometer_bias_std", "m/s^2", "its standard deviation"),
        (
            "nis_per_dimension",
            "",
            "normalised innovation squared, all rows together, over its dimension: 1 where noise "
            "is as large as believed; null if nothing was innovated",
        ),
        (
            "verdicts",
            "",
            "surefoot.SensorVerdict on each sensor: now (at the end) and the share of time in each",
        ),
    ),
    "Contact": (
        ("contact", "", "per foot: transitions, and share of time with a probability above 0.5"),
        ("contact_transitions", "", "time [s], foot, contact: true came down, false lifted off"),
        ("slip_events", "", "time [s], foot, duration [s] of slips above 0.5"),
    ),
    "Truth": (
        (
            "velocity_rmse",
            "m/s",
            "world axes, length of the error, true heading at the start taken over; null, like all "
            "here, if the log has no truth_ columns for it",
        ),
        ("roll_pitch_rmse_deg", "deg", "of roll and of pitch"),
        ("height_error_range", "m", "lowest and highest error of z, which is 0 at the start"),
        (
            "vertical_force_rmse",
            "",
            "per foot, vertical force from joint torques, as a share of the model's weight",
        ),
        (
            "contact_delays",
            "",
            "per foot: true transitions, missed (not told from 0.1 s before to 0.3 s after), false "
            "(told without a true one), mean and max delay [s]",
        ),
    ),
}

FIELDS: tuple[Field, ...] = tuple(
    Field(name, unit, meaning, group)
    for group, rows in _GROUPS.items()
    for name, unit, meaning in rows
)
"""Every entry of surefoot.estimate.summarise(), in its order."""
