"""Name, unit, meaning and group of each summary field, for report, documentation and tests."""

from __future__ import annotations

from surefoot.reports.summary_field import Field

_GROUPS: dict[str, tuple[tuple[str, str, str], ...]] = {
    "Conditions": (
        ("version", "", "version of Surefoot"),
        ("robot", "", "name of the robot"),
        ("seed", "", "seed of all random numbers of the plant"),
        ("sensors", "", "real: noise, bias, delay, quantisation, motor lag; ideal: none of these"),
        (
            "foot_force",
            "",
            "foot force fields with data: est (footForceEst), raw (footForce) or dead",
        ),
        ("rate", "Hz", "LowStates and LowCmds per second"),
        ("duration", "s", "simulated time; shorter than requested if the robot fell"),
        ("mjcf", "", "MJCF file of the simulated robot; null: it was built from the URDF"),
        ("friction", "", "coefficient between foot and ground"),
        ("soft_ground_sink", "m", "depth of a foot under a quarter of the weight; 0 is rigid"),
        ("slope_deg", "deg", "steepness of the ground"),
        ("slope_heading_deg", "deg", "direction of steepest ascent, from forward towards left"),
        ("payload_kg", "kg", "mass on the trunk that is not in the controller's model"),
        ("payload_position", "m", "centre of the payload in the base frame"),
        ("joint_friction_scale", "", "factor on friction and damping of the true joints"),
        ("armature_scale", "", "factor on the inertia of the true rotors"),
        ("backlash_deg", "deg", "play of every gear at its joint, from end to end"),
        ("motor_lag_ms", "ms", "time constant of the motor torque"),
        ("delay_ms", "ms", "delay of commands besides that of real sensors and link"),
        ("motor_damping", "N.m.s/rad", "motor-side damping in every command"),
        ("form", "", "form of the controller's QP: auto, condensed or general"),
        ("predict_ms", "ms", "delay over which the controller predicts the state"),
        ("gains_changed", "", "gains that differ from the robot's own"),
        (
            "lip_limit_ns",
            "N.s",
            "LIP push limit for 0.1 s, with the true mass, height and support of the robot",
        ),
        (
            "pushes",
            "",
            "direction, impulse [N.s], share of the LIP push limit, duration [s], time [s], height "
            "above the centre of mass [m]",
        ),
        (
            "references",
            "",
            "requests: time [s] and offsets from the first pose, x, y, height [m], roll, pitch, "
            "yaw [deg]; an axis that is not named keeps its last request",
        ),
    ),
    "Outcome": (
        ("fell", "", "trunk or leg on the ground, or tilted by more than 60 deg"),
        ("fall_time_s", "s", "time of the fall; null if it did not fall"),
        (
            "settled",
            "",
            "at the end: base within 10 mm and 2 deg of its first pose (with references: of the "
            "requested pose) relative to the mean and the heading of the true feet, and slower "
            "than 0.05 m/s",
        ),
        (
            "settle_time_s",
            "s",
            "time from the end of the last push or the last reference, whichever is later, until "
            "the robot stays settled; null without such an event or if not settled",
        ),
    ),
    "Pose": (
        (
            "height_error_mm",
            "mm",
            "at the end: change of the base height above the true feet (with references: distance "
            "from the requested height)",
        ),
        (
            "tilt_error_deg",
            "deg",
            "at the end: angle between the first and the last direction of gravity in the base "
            "(with references: between the requested and the last)",
        ),
        (
            "yaw_error_deg",
            "deg",
            "at the end: change of yaw relative to the true feet's heading (with references: "
            "distance from the requested yaw)",
        ),
        ("max_tilt_deg", "deg", "largest tilt from the first attitude"),
        ("max_foot_travel_mm", "mm", "largest distance of a foot from its first position"),
    ),
    "References": (
        (
            "reference_error_mm",
            "mm",
            "at the end: distance of the true base from the requested position, relative to the "
            "mean, heading and plane of the true feet; null without references, as the next two",
        ),
        (
            "reference_error_deg",
            "deg",
            "at the end: angle between the requested and the true attitude",
        ),
        (
            "reference_reached",
            "",
            "at the end: true offsets from the first pose, x, y, height [mm] along the heading "
            "and out of the plane of the feet, roll, pitch, yaw [deg] about them",
        ),
        (
            "reference_limit",
            "",
            "limit that stopped the body reference in the last 0.1 s: none, joint and its name, "
            "support (centre of mass near a support edge), foot height (a foot near the height of "
            "its hip axis), unreachable (a leg is too short)",
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
            "largest ratio of true torque to the motor's limit at low speed; real motors have a "
            "torque error of 5 %",
        ),
        ("peak_power_w", "W", "largest sum over the motors of |torque x velocity|"),
    ),
    "Estimator": (
        (
            "estimator_velocity_rmse",
            "m/s",
            "RMS error of the base velocity in base axes, against the truth at the same instant",
        ),
        ("estimator_tilt_rmse_deg", "deg", "RMS angle between estimated and true gravity"),
    ),
    "Loop": (
        ("ticks", "", "calls of the controller's update()"),
        ("qp_failures", "", "ticks without an accepted solution: their status is not usable"),
        ("first_failure", "", "status of the first such tick; null if there was none"),
        (
            "cold_solves",
            "",
            "ticks whose first solve failed and whose cold start succeeded: their status is usable",
        ),
        (
            "saturated_ticks",
            "",
            "ticks whose torques are usable but were clipped to the motor limits",
        ),
        (
            "torque_mode_only",
            "",
            "true if all 12 motors had mode 0x0A, Kp = Kd = 0, q = PosStopF, dq = VelStopF in "
            "every command",
        ),
        ("iterations", "", "iterations of the QP solver: mean and max"),
        ("tick_us", "us", "wall time of update() as called from Python: p50, p90, p99, max"),
    ),
}

FIELDS: tuple[Field, ...] = tuple(
    Field(name, unit, meaning, group)
    for group, rows in _GROUPS.items()
    for name, unit, meaning in rows
)
"""All fields that surefoot.stand.summarise() returns, in the same order."""
