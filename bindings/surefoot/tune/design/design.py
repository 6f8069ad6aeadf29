"""From goals to gains: each axis designed, its margins computed, what cannot be stable refused."""

from __future__ import annotations

from dataclasses import dataclass, field

from surefoot._core import Error, Gains
from surefoot.robot_files import RobotDescription
from surefoot.tune.design.axes import AXES, Body, measure_body
from surefoot.tune.design.goals import Goal, goal_of
from surefoot.tune.design.loop import ClosedLoop
from surefoot.tune.design.margins import Margins, all_margins, greatest_frequency
from surefoot.tune.design.timing import Observers, Timing

THIN_GAIN = 2.0  # margins below are warned of
THIN_PERIODS = 1.0
# Trust in a sensor divides these of the robot's own gains.
IMU_DOUBTS = ("noise_gyroscope", "noise_accelerometer", "push_time", "push_dead_band")
LEG_DOUBTS = ("noise_foot_position", "noise_foot_slip", "noise_foot_motion")


@dataclass(frozen=True)
class DesignSettings:
    """What is asked for.

    Attributes:
        robot: Its files.
        goals: By axis (see AXES); an axis that is not there keeps the robot's own gains.
        timing: Rate, further delay, motor lag.
        start: Gains that all others are taken from; None is the robot's own.
        trust_imu: Divides the noise that is first assumed of gyroscope and accelerometer, and the
            push observer's time and dead band.
        trust_legs: Divides the noise that is first assumed of standing feet.
        joint_friction_scale: Factor on the joints' friction.
    """

    robot: RobotDescription
    goals: dict[str, Goal]
    timing: Timing = field(default_factory=Timing)
    start: Gains | None = None
    trust_imu: float = 1.0
    trust_legs: float = 1.0
    joint_friction_scale: float = 1.0


@dataclass(frozen=True)
class AxisDesign:
    """One axis, its gains, and its margins in the direction that bears least.

    Attributes:
        name: Of AXES.
        goal: What was asked for, or what the robot's own gains amount to.
        own: Whether these are the robot's own gains.
        direction: The one that the margins are of.
        margins: There.
        directions: The margins of all the axis's directions.
    """

    name: str
    goal: Goal
    own: bool
    direction: str
    margins: Margins
    directions: dict[str, Margins]

    def warnings(self, period: float) -> list[str]:
        """Return what is thin, one sentence each."""
        m, out = self.margins, []
        if min(m.boundary, m.gain_up) < THIN_GAIN:
            out.append(
                f"{self.name}: {min(m.boundary, m.gain_up):.2f} times these gains start to "
                f"oscillate, less than {THIN_GAIN:g}"
            )
        if min(m.delay, m.push_delay) < THIN_PERIODS * period:
            out.append(
                f"{self.name}: {1000.0 * min(m.delay, m.push_delay):.1f} ms more delay start an "
                f"oscillation, less than a period of {1000.0 * period:g} ms"
            )
        return out


@dataclass(frozen=True)
class Design:
    """Gains, and what the model says of them.

    Attributes:
        settings: What was asked for.
        body: The robot, standing.
        gains: All of them.
        axes: In the order of AXES.
    """

    settings: DesignSettings
    body: Body
    gains: Gains
    axes: list[AxisDesign]

    @property
    def warnings(self) -> list[str]:
        """What is thin."""
        period = self.settings.timing.period
        return [text for axis in self.axes for text in axis.warnings(period)]


def design_gains(settings: DesignSettings) -> Design:
    """Compute gains and margins.

    kp = (2 pi f)^2, kd = 2 zeta 2 pi f for each axis with a goal.

    Raises:
        Error: An axis that is none, a gain out of its range, trust that is not above 0; a loop
            that cannot be stable, with the greatest frequency that is; CasADi is missing.
    """
    for name in settings.goals:
        if name not in AXES:
            raise Error(f"axis: got '{name}', expected one of {', '.join(AXES)}")
    body = measure_body(settings.robot, settings.joint_friction_scale, settings.start)
    gains = _gains(settings, body)
    observers = Observers.of(gains)
    axes = [_design_axis(name, settings, body, gains, observers) for name in AXES]
    return Design(settings, body, gains, axes)


def _gains(settings: DesignSettings, body: Body) -> Gains:
    start = settings.start or body.robot.config.gains
    gains = start.__copy__()
    for name, goal in settings.goals.items():
        kp, kd, _ = AXES[name]
        setattr(gains, kp, goal.kp)
        setattr(gains, kd, goal.kd)
    for trust, names, what in (
        (settings.trust_imu, IMU_DOUBTS, "trust in the IMU"),
        (settings.trust_legs, LEG_DOUBTS, "trust in the legs"),
    ):
        if not 0.1 <= trust <= 10.0:
            raise Error(f"{what}: got {trust:g}, expected 0.1 .. 10")
        for name in names:
            setattr(gains, name, getattr(gains, name) / trust)
    gains.validate()
    return gains


def _design_axis(
    name: str, settings: DesignSettings, body: Body, gains: Gains, observers: Observers
) -> AxisDesign:
    kp, kd, _ = AXES[name]
    own = name not in settings.goals
    goal = goal_of(getattr(gains, kp), getattr(gains, kd)) if own else settings.goals[name]
    directions = {}
    for direction in body.of_axis(name):
        loop = ClosedLoop(direction, settings.timing, observers)
        margins = all_margins(loop, goal)
        if not margins.stable:
            raise Error(_refusal(name, settings, body, goal, observers, own))
        directions[direction.name] = margins
    least = min(directions, key=lambda key: directions[key].boundary)
    return AxisDesign(name, goal, own, least, directions[least], directions)


def _refusal(
    name: str, settings: DesignSettings, body: Body, goal: Goal, observers: Observers, own: bool
) -> str:
    timing = settings.timing
    greatest = min(
        greatest_frequency(direction, timing, observers, goal.damping)
        for direction in body.of_axis(name)
    )
    whose = "the robot's own gains, " if own else ""
    hint = (
        f"expected at most {greatest:.2g} Hz at this damping"
        if greatest > 0.0
        else "no frequency is stable at this damping"
    )
    return (
        f"{name}: {whose}{goal.frequency:.3g} Hz with damping {goal.damping:.3g} cannot be stable "
        f"with {1000.0 * timing.delay:g} ms of further delay at {timing.rate:g} Hz; {hint}"
    )
