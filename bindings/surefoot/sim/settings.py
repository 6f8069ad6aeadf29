"""Settings of a plant, and pushes. Both check their values when they are constructed."""

from __future__ import annotations

from dataclasses import dataclass, field

from surefoot._core import Error
from surefoot.messages.low_state_layout import LEGS
from surefoot.robot.setting_checks import check_number, check_one_of
from surefoot.sim.flaws import Flaws
from surefoot.sim.terrain import Terrain

# [s] Physics step of scorecard and fault matrix: twice the default, so that the runs take half of
# the time. Push limits are the same with both steps. Upper bound: a fifth of the time constant of
# FOOT_SOLREF (5 ms).
COARSE_DT = 0.001
_SENSORS = ("real", "ideal")
_FOOT_FORCE = ("est", "raw", "dead")
_DIRECTIONS = {"forward": 0.0, "lateral": 90.0}
# [m] Range of soft_ground_sink. The minimum exceeds the 20 um by which feet sink into rigid ground.
# The maximum is below half of the length of a calf.
MIN_SINK, MAX_SINK = 1e-4, 0.1
# [m] Depth by which a soft sole yields under a quarter of the robot's own weight. Assumed, because
# the vendor publishes no stiffness: a quarter of the foot radius of a Go1. If larger: a foot that
# touches down moves for longer after its force has risen.
SOLE_SINK = 0.005


@dataclass(frozen=True)
class PlantSettings:
    """Settings of a plant: sensors, ground, payload, flaws, rates, seed.

    A plant from an MJCF takes ground and contacts from the file: there, friction, soft ground,
    slope, terrain and moving ground must have their defaults, and soft_soles and leg_collisions
    have no effect. The two scales multiply the values of the file.

    Attributes:
        sensors: "real" (noise, bias, attitude filter, one period of delay for commands and one for
            samples, quantised wire format, motor lag) or "ideal" (exact, without delay).
        foot_force: "est" (newtons and raw counts), "raw" (raw counts alone), "dead" (zeros);
            None: "est" if the robot's TOML sets simulation.foot_force_est, else "dead".
        walking_sensors: Whether real sensors have the errors that walking adds: the IMU vibrates
            after impacts and clips, the accelerometer repeats its values, and foot forces fall late
            (sim/hardware/walking_errors.py). No effect on ideal sensors.
        soft_soles: Whether the feet have soft soles (SOLE_SINK); else they are rigid. The soles are
            part of the contact, so they act with ideal sensors too.
        leg_collisions: Whether legs collide with each other and with the trunk even where the SRDF
            disables it (sim/model/leg_collisions.py); Plant.leg_contacts lists the contacts.
        friction: Friction coefficient between foot and ground.
        soft_ground_sink: Depth to which a foot sinks under a quarter of the robot's own weight [m].
            0: rigid ground; 0.1 mm or more: a spring and a damper (sim/model/soft_ground.py).
        slope_deg: Slope of the ground [deg]; gravity stays along world z.
        slope_heading_deg: Direction of steepest ascent, from forward towards left [deg].
        terrain: Platform, stairs or blocks on level ground (sim/terrain.py).
        payload_kg: Mass welded to the trunk, unknown to the controller [kg].
        payload_position: Centre of the payload in the base frame [m].
        control_rate: Rate of LowCmd and LowState [Hz].
        physics_dt: Physics step [s]; the control period must be a whole number of steps.
        joint_friction_scale: Factor on joint friction and joint damping.
        armature_scale: Factor on the reflected rotor inertia.
        backlash_deg: Backlash of every gear, measured at its joint from end to end [deg]. The
            encoder is on the rotor's side (sim/model/backlash.py).
        motor_lag: Time constant of the motor torque [s]; None: 2 ms if real, 0 if ideal.
        extra_delay: Additional delay of commands [s], rounded to physics steps.
        flaws: IMU biases, torque errors, trunk mass (sim/flaws.py).
        platform_heading_deg: Heading [deg] of the side that goes up when the ground, a platform,
            tilts (sim/model/moving_ground.py); None: fixed ground.
        block_foot: Foot, of FR FL RR RL, that stands on a block which can rise
            (sim/model/moving_ground.py); None: no block.
        hung: Whether the base is fixed in the air, level, with free legs (sim/physics/hanging.py).
        seed: Seed of all random numbers; the same seed gives the same run.
    """

    sensors: str = "real"
    foot_force: str | None = None
    walking_sensors: bool = False
    soft_soles: bool = False
    leg_collisions: bool = False
    friction: float = 0.8  # feet of MuJoCo Menagerie's Unitree quadrupeds
    soft_ground_sink: float = 0.0
    slope_deg: float = 0.0
    slope_heading_deg: float = 0.0
    terrain: Terrain = field(default_factory=Terrain)
    payload_kg: float = 0.0
    payload_position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    control_rate: float = 500.0  # dt = 0.002 s of the SDK's examples
    # Chosen: half of this step changes sway by less than 2 % (test_plant_standing.py), and a pushed
    # stand by less than 5 % (test_stand_physics_step.py).
    physics_dt: float = 0.0005
    joint_friction_scale: float = 1.0
    armature_scale: float = 1.0
    backlash_deg: float = 0.0
    motor_lag: float | None = None
    extra_delay: float = 0.0
    flaws: Flaws = field(default_factory=Flaws)
    platform_heading_deg: float | None = None
    block_foot: str | None = None
    hung: bool = False
    seed: int = 0

    def __post_init__(self) -> None:
        check_one_of("sensors", self.sensors, _SENSORS)
        for name in ("walking_sensors", "soft_soles", "leg_collisions"):
            if not isinstance(getattr(self, name), bool):
                raise Error(f"{name}: got {getattr(self, name)!r}, expected True or False")
        if self.foot_force is not None:
            check_one_of("foot_force", self.foot_force, _FOOT_FORCE)
        self._check_moving_ground()
        # Ranges of values that make sense. From a physics_dt of 2.5 ms on, MuJoCo softens the foot
        # contacts (FOOT_SOLREF).
        for name, low, high in (
            ("friction", 0.0, 10.0),
            ("soft_ground_sink", 0.0, MAX_SINK),
            ("slope_deg", -45.0, 45.0),
            ("slope_heading_deg", -360.0, 360.0),
            ("payload_kg", 0.0, 1000.0),
            ("control_rate", 10.0, 10_000.0),
            ("physics_dt", 1e-5, 0.002),
            ("joint_friction_scale", 0.0, 100.0),
            ("armature_scale", 0.0, 100.0),
            ("backlash_deg", 0.0, 5.0),
            ("extra_delay", 0.0, 1.0),
        ):
            check_number(name, getattr(self, name), low, high)
        if self.motor_lag is not None:
            check_number("motor_lag", self.motor_lag, 0.0, 1.0)
        if 0.0 < self.soft_ground_sink < MIN_SINK:
            raise Error(
                f"soft_ground_sink: got {self.soft_ground_sink!r}, expected 0 (rigid ground) or a "
                f"number from {MIN_SINK:g} to {MAX_SINK:g}"
            )
        if self.hung and self.slope_deg:
            raise Error(f"slope_deg: got {self.slope_deg:g}, expected 0 for a hung robot")
        self._check_terrain()
        self._check_position()
        self._check_physics_dt()
        if isinstance(self.seed, bool) or not isinstance(self.seed, int) or self.seed < 0:
            raise Error(f"seed: got {self.seed!r}, expected a whole number from 0 up")

    @property
    def steps_per_tick(self) -> int:
        """Number of physics steps in a control period."""
        return round(1.0 / (self.control_rate * self.physics_dt))

    @property
    def real(self) -> bool:
        """Whether sensors, wire format and motors have real errors, see `sensors`."""
        return self.sensors == "real"

    @property
    def contact_sink(self) -> float:
        """Depth by which ground and sole together yield under a quarter of the weight [m]."""
        return self.soft_ground_sink + (SOLE_SINK if self.soft_soles else 0.0)

    @property
    def lag(self) -> float:
        """Time constant of the motor torque [s]: motor_lag, or its default if None."""
        if self.motor_lag is not None:
            return self.motor_lag
        return 0.002 if self.real else 0.0  # assumed: one control period; no data sheet states it

    def _check_position(self) -> None:
        try:
            size = len(self.payload_position)
        except TypeError:
            size = 0
        if size != 3:
            raise Error(f"payload_position: got {self.payload_position!r}, expected x, y, z [m]")
        for value in self.payload_position:
            check_number("payload_position", value, -10.0, 10.0)

    def _check_moving_ground(self) -> None:
        if self.block_foot is not None:
            check_one_of("block_foot", self.block_foot, LEGS)
        if self.platform_heading_deg is not None:
            check_number("platform_heading_deg", self.platform_heading_deg, -360.0, 360.0)
        moving = [self.block_foot, self.platform_heading_deg]
        others = self.hung or self.slope_deg != 0.0 or self.contact_sink > 0.0
        if moving.count(None) < (2 if others else 1):
            raise Error(
                "moving ground: got it together with a second one, a slope, soft ground, soft "
                "soles or a hung robot, expected platform_heading_deg or block_foot alone"
            )

    def _check_terrain(self) -> None:
        if not isinstance(self.terrain, Terrain):
            raise Error(f"terrain: got {self.terrain!r}, expected a Terrain")
        moving = self.block_foot is not None or self.platform_heading_deg is not None
        if not self.terrain.is_flat and (moving or self.hung or self.slope_deg != 0.0):
            raise Error(
                "terrain: got it together with a slope, moving ground or a hung robot, expected "
                "level ground"
            )

    def _check_physics_dt(self) -> None:
        steps = 1.0 / (self.control_rate * self.physics_dt)
        if steps < 0.5 or abs(steps - round(steps)) > 1e-6 * steps:
            raise Error(
                f"physics_dt: got {self.physics_dt} s, expected the control period "
                f"{1.0 / self.control_rate:.6g} s (control_rate {self.control_rate} Hz) "
                "divided by a whole number"
            )


@dataclass(frozen=True)
class Push:
    """A push: a horizontal force with constant world direction and a rectangular profile in time.

    The force acts at the true centre of mass, or at a height above the centre of mass, and follows
    the motion of the centre of mass.

    Attributes:
        direction: "forward", "lateral" (left), or degrees from forward towards left, relative to
            the robot's heading when the push begins.
        impulse: Impulse [N.s]; the force is impulse / duration.
        duration: Duration [s].
        time: Start of the push, measured from reset [s].
        height: Height of the line of action above the centre of mass [m].
    """

    direction: str | float
    impulse: float
    duration: float = 0.1  # the standard push of the scorecard
    time: float = 0.0
    height: float = 0.0

    def __post_init__(self) -> None:
        direction_degrees(self.direction)
        check_number("impulse", self.impulse, -10_000.0, 10_000.0)
        check_number("duration", self.duration, 1e-6, 1e6)
        check_number("time", self.time, 0.0, 1e9)
        check_number("height", self.height, -10.0, 10.0)

    @property
    def degrees(self) -> float:
        """Direction from forward towards left [deg]."""
        return direction_degrees(self.direction)


def direction_degrees(direction: str | float) -> float:
    """Return a push direction in degrees from forward towards left; raise Error if invalid."""
    if isinstance(direction, str):
        check_one_of("direction", direction, tuple(_DIRECTIONS), " or a number of degrees")
        return _DIRECTIONS[direction]
    check_number("direction", direction, -360.0, 360.0)
    return float(direction)
