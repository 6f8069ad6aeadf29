"""One condition of a scorecard: the ground, the flaws of the robot, and the lost frames."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

from surefoot._core import Error
from surefoot.messages.low_state_layout import LEGS
from surefoot.robot.robot_toml import suggest
from surefoot.robot.setting_checks import check_number, check_numbers, check_one_of, check_unique

# Sanity limits (lowest, highest) of each field, in the unit of the field.
_RANGES = {
    "friction": (0.01, 10.0),
    "slope_deg": (0.0, 45.0),
    "tilt_deg": (0.0, 30.0),
    "tilt_deg_per_s": (0.1, 90.0),
    "step_m": (0.0, 0.1),
    "payload_share": (0.0, 3.0),
    "mass_share": (-0.6, 3.0),
    "latency_ms": (0.0, 100.0),
    "loss_percent": (0.0, 90.0),
    "joint_friction_scale": (0.0, 100.0),
    "motor_lag_ms": (0.0, 100.0),
    "torque_scale": (0.1, 2.0),
    "soft_ground_mm": (0.0, 100.0),
    "quiet_s": (0.1, 60.0),
    "height_within_mm": (0.0, 1000.0),
    "tilt_within_deg": (0.0, 90.0),
    "foot_within_mm": (0.0, 1000.0),
}


@dataclass(frozen=True)
class Condition:
    """One condition of a scorecard. Every field except `name` has a nominal value as default.

    Attributes:
        name: Unique name; texts and reports show it.
        friction: True friction coefficient between foot and ground; unknown to the controller.
        slope_deg: Steepness of the ground [deg].
        headings_deg: Directions of steepest ascent of slope or platform, from forward towards left
            [deg]; the robot stands once per heading and seed.
        tilt_deg: Final angle of a platform that tilts while the robot stands on it [deg].
        tilt_deg_per_s: Angular speed of the tilting platform [deg/s].
        step_foot: Foot under which the ground rises while the robot stands; "" for none.
        step_m: Height by which the ground under `step_foot` rises within STEP_RISE_TIME [m].
        payload_share: Mass of the payload on the trunk, as a share of the robot's mass.
        payload_offset_m: Position of the payload in the base frame, x, y, z [m].
        mass_share: True trunk mass minus the trunk mass of the model, as a share of the robot's
            mass. The true inertia of the trunk scales with its mass.
        latency_ms: Extra delay of commands, added to the delays of the plant [ms].
        loss_percent: Share of frames lost in each direction of the link [%].
        joint_friction_scale: Ratio of true joint friction and damping to those of the model.
        motor_lag_ms: Time constant of the motor torque [ms].
        torque_scale: Ratio of the true torque of every motor to the commanded torque.
        soft_ground_mm: Depth by which a foot sinks with a quarter of the robot's weight on it [mm].
        quiet_s: Time of undisturbed standing before a push or before the ground moves [s].
        pushes: True: the robot is also pushed under this condition, not only left standing.
        height_within_mm: Tolerance of the body height at the end of a quiet stand [mm].
        tilt_within_deg: Tolerance of the body attitude at the end of a quiet stand [deg].
        foot_within_mm: Tolerance of every foot's displacement over the whole quiet stand [mm].
    """

    name: str
    friction: float = 0.8  # the default of PlantSettings
    slope_deg: float = 0.0
    headings_deg: tuple[float, ...] = (0.0,)
    tilt_deg: float = 0.0
    tilt_deg_per_s: float = 5.0
    step_foot: str = ""
    step_m: float = 0.03
    payload_share: float = 0.0
    payload_offset_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    mass_share: float = 0.0
    latency_ms: float = 0.0
    loss_percent: float = 0.0
    joint_friction_scale: float = 1.0
    motor_lag_ms: float = 2.0  # the default of PlantSettings with real sensors
    torque_scale: float = 1.0
    soft_ground_mm: float = 0.0
    quiet_s: float = 0.4  # chosen: longer than the estimator needs to find the attitude (0.15 s)
    pushes: bool = False
    # The same tolerances as RETURN_DISTANCE, RETURN_ANGLE and MAX_FOOT_DISPLACEMENT of
    # push_outcome.py.
    height_within_mm: float = 10.0
    tilt_within_deg: float = 2.0
    foot_within_mm: float = 10.0

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name.strip():
            raise Error(f"condition: name: got {self.name!r}, expected words")
        try:
            for name, (low, high) in _RANGES.items():
                check_number(name, getattr(self, name), low, high)
            if self.step_foot != "":
                check_one_of("step_foot", self.step_foot, LEGS, ' or "" for none')
            check_numbers("payload_offset_m", self.payload_offset_m, -1.0, 1.0)
            if len(self.payload_offset_m) != 3:
                raise Error(f"payload_offset_m: got {self.payload_offset_m!r}, expected x, y, z")
            check_numbers("headings_deg", self.headings_deg, -360.0, 360.0)
            check_unique("headings_deg", tuple(heading % 360.0 for heading in self.headings_deg))
            if not isinstance(self.pushes, bool):
                raise Error(f"pushes: got {self.pushes!r}, expected true or false")
            if self.ground_moves and (self.slope_deg or self.soft_ground_mm):
                raise Error(
                    "got ground that moves and a slope or soft ground, expected one of them"
                )
            if self.tilt_deg and self.step_foot:
                raise Error("got a platform and a step, expected one of them")
            if self.pushes and (self.slope_deg or self.ground_moves):
                raise Error("pushes: got true, expected false: push limits are of level ground")
        except Error as problem:
            raise Error(f"condition '{self.name}': {problem}") from None

    @property
    def ground_moves(self) -> bool:
        """True if the ground moves while the robot stands."""
        return self.tilt_deg > 0.0 or bool(self.step_foot)


def read_condition(table: Any) -> Condition:
    """Return the condition that a TOML table describes.

    Raises:
        Error: A key is unknown, the key "name" is missing, or a value is out of range.
    """
    if not isinstance(table, dict):
        raise Error(f"condition: got {table!r}, expected a table [[condition]]")
    valid = [field.name for field in fields(Condition)]
    label = f"condition '{table.get('name', '?')}'"
    for key in table:
        if key not in valid:
            hint = suggest(key, valid)
            raise Error(f"{label}: unknown key '{key}'{hint}; valid names: {', '.join(valid)}")
    if "name" not in table:
        raise Error("condition: got none of the key 'name', expected words")
    values: dict[str, Any] = {k: tuple(v) if isinstance(v, list) else v for k, v in table.items()}
    return Condition(**values)
