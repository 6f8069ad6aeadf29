"""Design of gains and margins from goals; a goal that cannot be stable is refused."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, Gains
from surefoot.tune.design.closed_loop import ClosedLoop
from surefoot.tune.design.directions import AXES, StandingBody
from surefoot.tune.design.goals import Goal, goal_from_gains
from surefoot.tune.design.margins import Margins, all_margins
from surefoot.tune.design.settings import IMU_NOISE_GAINS, LEG_NOISE_GAINS, DesignSettings
from surefoot.tune.design.standing_body import compute_standing_body
from surefoot.tune.design.timing import Observers
from surefoot.tune.design.unstable_goal import unstable_goal_text

# Chosen: the usual gain margin of a factor of two (6 dB).
WARN_GAIN_MARGIN = 2.0  # gain margin below which a warning is given
# Chosen: one lost sample must not make the loop unstable.
WARN_DELAY_PERIODS = 1.0  # [periods] delay margin below which a warning is given


@dataclass(frozen=True)
class AxisDesign:
    """Design of one axis, with the stability margins of its directions.

    Attributes:
        name: One of AXES.
        goal: Desired frequency and damping; without a goal, those of the robot's own gains.
        uses_robot_gains: True if the axis has no goal and keeps the robot's own gains.
        direction: Direction with the smallest Margins.boundary.
        margins: Margins of `direction`.
        directions: Margins of all directions of the axis.
    """

    name: str
    goal: Goal
    uses_robot_gains: bool
    direction: str
    margins: Margins
    directions: dict[str, Margins]

    def warnings(self, period: float) -> list[str]:
        """Return one sentence for each margin that is too small; `period` [s]."""
        m, out = self.margins, []
        if min(m.boundary, m.gain_up) < WARN_GAIN_MARGIN:
            out.append(
                f"{self.name}: oscillates at {min(m.boundary, m.gain_up):.2f} times these gains, "
                f"expected at least {WARN_GAIN_MARGIN:g}"
            )
        if min(m.delay, m.push_delay) < WARN_DELAY_PERIODS * period:
            out.append(
                f"{self.name}: oscillates with {1000.0 * min(m.delay, m.push_delay):.1f} ms more "
                f"delay, expected at least one period of {1000.0 * period:g} ms"
            )
        return out


@dataclass(frozen=True)
class Design:
    """Designed gains and their margins in the model.

    Attributes:
        settings: Settings of the design.
        body: Model of the standing robot.
        gains: All gains of the controller.
        axes: Designs of the axes, in the order of AXES.
    """

    settings: DesignSettings
    body: StandingBody
    gains: Gains
    axes: list[AxisDesign]

    @property
    def warnings(self) -> list[str]:
        """Warnings about small margins, for all axes."""
        period = self.settings.timing.period
        return [text for axis in self.axes for text in axis.warnings(period)]


def design_gains(settings: DesignSettings) -> Design:
    """Compute the gains of the axes with goals, and the margins of all axes.

    The gains are kp = (2 pi f)^2 and kd = 2 zeta 2 pi f.

    Raises:
        Error: An axis is unknown, a gain or a setting is out of its range, a goal cannot be stable
            (the message names the greatest stable frequency), or CasADi is missing.
    """
    settings.check()
    body = compute_standing_body(settings.robot, settings.joint_friction_scale, settings.start)
    gains = _gains(settings, body)
    observers = Observers.of(gains)
    axes = [_design_axis(name, settings, body, gains, observers) for name in AXES]
    return Design(settings, body, gains, axes)


def _gains(settings: DesignSettings, body: StandingBody) -> Gains:
    start = settings.start or body.robot.config.gains
    gains = start.__copy__()
    for name, goal in settings.goals.items():
        kp, kd, _ = AXES[name]
        setattr(gains, kp, goal.kp)
        setattr(gains, kd, goal.kd)
    for trust, names in (
        (settings.trust_imu, IMU_NOISE_GAINS),
        (settings.trust_legs, LEG_NOISE_GAINS),
    ):
        for name in names:
            setattr(gains, name, getattr(gains, name) / trust)
    gains.validate()
    return gains


def _design_axis(
    name: str, settings: DesignSettings, body: StandingBody, gains: Gains, observers: Observers
) -> AxisDesign:
    kp, kd, _ = AXES[name]
    uses_robot_gains = name not in settings.goals
    goal = (
        goal_from_gains(getattr(gains, kp), getattr(gains, kd))
        if uses_robot_gains
        else settings.goals[name]
    )
    directions = {}
    for direction in body.axis_directions(name):
        loop = ClosedLoop(direction, settings.timing, observers)
        margins = all_margins(loop, goal)
        if not margins.stable:
            subject = f"{name}: the robot's own gains, " if uses_robot_gains else f"{name}: "
            goal_args = goal, settings.timing, body.axis_directions(name)
            raise Error(unstable_goal_text(subject, *goal_args, observers))
        directions[direction.name] = margins
    least_stable = min(directions, key=lambda key: directions[key].boundary)
    return AxisDesign(
        name, goal, uses_robot_gains, least_stable, directions[least_stable], directions
    )
