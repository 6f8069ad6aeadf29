"""What each number of a summary means, said once: for the report, the documentation, the tests."""

from __future__ import annotations

from surefoot.reports.summary_field import Field

_GROUPS: dict[str, tuple[tuple[str, str, str], ...]] = {
    "Conditions": (
        ("version", "", "of Surefoot"),
        ("robot", "", "name of the robot"),
        ("seed", "", "of every random number of the plant"),
        ("sensors", "", "real: noise, bias, delay, quantisation, motor lag; ideal: none of them"),
        ("foot_force", "", "which force field lives: est, raw or dead"),
        ("rate", "Hz", "LowStates and LowCmds per second"),
        ("duration", "s", "simulated time; shorter than asked for if the robot fell"),
        ("friction", "", "coefficient between foot and ground"),
        ("soft_ground_sink", "m", "of a foot under a quarter of the robot; 0 is rigid ground"),
        ("slope_deg", "deg", "steepness of the ground"),
        ("slope_heading_deg", "deg", "direction of steepest ascent, from forward towards left"),
        ("payload_kg", "kg", "mass on the trunk that the controller does not know of"),
        ("payload_position", "m", "its centre in the base frame"),
        ("joint_friction_scale", "", "factor on friction and damping of the true joints"),
        ("armature_scale", "", "factor on the inertia of the true rotors"),
        ("backlash_deg", "deg", "play of every gear at its joint, from end to end"),
        ("motor_lag_ms", "ms", "time constant of the motor torque"),
        ("delay_ms", "ms", "of commands, on top of what real sensors and wires take"),
        ("motor_damping", "N.m.s/rad", "motor-side damping in every command"),
        ("form", "", "of the controller's program: auto, condensed or general"),
        ("predict_ms", "ms", "delay that the controller predicts across"),
        ("gains_changed", "", "gains that differ from the robot's own"),
        (
            "lip_limit_ns",
            "N.s",
            "push of 0.1 s that a linear inverted pendulum of the robot's true mass, height and "
            "support survives",
        ),
        (
            "pushes",
            "",
            "direction, impulse [N.s], share of the limit, duration [s], time [s], height above "
            "the centre of mass [m]",
        ),
        (
            "references",
            "",
            "as asked for: time [s] and offsets from the first pose, x, y, height [m], roll, "
            "pitch, yaw [deg]; an axis that is not named stays where it was asked to be",
        ),
    ),
    "Outcome": (
        ("fell", "", "trunk or leg on the ground, or tilted by more than 60 deg"),
        ("fall_time_s", "s", "when; null if it did not"),
        (
            "settled",
            "",
            "at the end: base within 10 mm and 2 deg of its first pose (with references: of the "
            "pose asked for) relative to the mean and the heading of the true feet, and slower "
            "than 0.05 m/s",
        ),
        (
            "settle_time_s",
            "s",
            "from the end of the last push or the last reference, whichever is later, until "
            "settled for good; null without either or if not",
        ),
    ),
    "Pose": (
        (
            "height_error_mm",
            "mm",
            "at the end: change of the base's height above its true feet (with references: "
            "distance from the height asked for)",
        ),
        (
            "tilt_error_deg",
            "deg",
            "at the end: angle between first and last direction of gravity in the base (with "
            "references: between the one asked for and the last)",
        ),
        (
            "yaw_error_deg",
            "deg",
            "at the end: change of yaw relative to the true feet's heading (with references: "
            "distance from the yaw asked for)",
        ),
        ("max_tilt_deg", "deg", "greatest tilt away from the first attitude"),
        ("max_foot_travel_mm", "mm", "farthest that a foot ever was from its first place"),
    ),
    "References": (
        (
            "reference_error_mm",
            "mm",
            "at the end: distance of the true base from where it was asked to be, relative to the "
            "mean, heading and plane of the true feet; null without references, like the next two",
        ),
        ("reference_error_deg", "deg", "at the end: angle between attitude asked for and true one"),
        (
            "reference_reached",
            "",
            "at the end: true offsets from the first pose, x, y, height [mm] along the heading "
            "and out of the plane of the feet, roll, pitch, yaw [deg] about them",
        ),
        (
            "reference_limit",
            "",
            "what kept the body, in the last 0.1 s, from where it was asked to be: none, joint and "
            "its name, support (the centre of mass near the edge of the feet), foot height (a foot "
            "near the height of its hip axis), unreachable",
        ),
    ),
    "Stillness, last 2 s": (
        ("com_rms_mm", "mm", "RMS distance of the true centre of mass from its mean"),
        ("joint_velocity_rms", "rad/s", "RMS of the true joint velocities, all joints together"),
        ("torque_hf_rms", "N.m", "RMS of the true torque above 30 Hz, of the worst joint"),
    ),
    "Effort": (
        (
            "peak_torque_ratio",
            "",
            "greatest true torque over its motor's limit at low speed; a real one errs by 5 %",
        ),
        ("peak_power_w", "W", "greatest sum over the motors of |torque x velocity|"),
    ),
    "Estimator": (
        (
            "estimator_velocity_rmse",
            "m/s",
            "RMS error of the base velocity, in base axes, against the truth of the same instant",
        ),
        ("estimator_tilt_rmse_deg", "deg", "RMS angle between estimated and true gravity"),
    ),
    "Loop": (
        ("ticks", "", "calls of the controller"),
        ("qp_failures", "", "ticks without an accepted solution: status not usable"),
        ("first_failure", "", "status of the first of them; null if there was none"),
        (
            "cold_solves",
            "",
            "ticks that had to be solved once more, from nothing: usable all the same",
        ),
        ("saturated_ticks", "", "ticks whose torques are usable but were clipped to the motors"),
        (
            "torque_mode_only",
            "",
            "in every command all 12 motors had mode 0x0A, Kp = Kd = 0, q = PosStopF, "
            "dq = VelStopF",
        ),
        ("iterations", "", "of the solver: mean and max"),
        ("tick_us", "us", "wall time of update() called from Python: p50, p90, p99, max"),
    ),
}

FIELDS: tuple[Field, ...] = tuple(
    Field(name, unit, meaning, group)
    for group, rows in _GROUPS.items()
    for name, unit, meaning in rows
)
"""Every entry of surefoot.stand.summarise(), in its order."""
