"""From goals to gains: each axis designed, its margins computed, what cannot be stable refused."""

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

WARN_GAIN_MARGIN = 2.0  # margins below are warned of
WARN_DELAY_PERIODS = 1.0


@dataclass(frozen=True)
class AxisDesign:
    """One axis, its gains, and its margins in the direction that bears least.

    Attributes:
        name: Of AXES.
        goal: What was asked for, or what the robot's own gains amount to.
        uses_robot_gains: Whether these are the robot's own gains.
        direction: The one that the margins are of.
        margins: There.
        directions: The margins of all the axis's directions.
    """

    name: str
    goal: Goal
    uses_robot_gains: bool
    direction: str
    margins: Margins
    directions: dict[str, Margins]

    def warnings(self, period: float) -> list[str]:
        """Return what is thin, one sentence each."""
        m, out = self.margins, []
        if min(m.boundary, m.gain_up) < WARN_GAIN_MARGIN:
            out.append(
                f"{self.name}: {min(m.boundary, m.gain_up):.2f} times these gains start to "
                f"oscillate, less than {WARN_GAIN_MARGIN:g}"
            )
        if min(m.delay, m.push_delay) < WARN_DELAY_PERIODS * period:
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
    body: StandingBody
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
        Error: An axis that is none, a gain or a number of the settings out of its range; a loop
            that cannot be stable, with the greatest frequency that is; CasADi is missing.
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
            asked = goal, settings.timing, body.axis_directions(name)
            raise Error(unstable_goal_text(subject, *asked, observers))
        directions[direction.name] = margins
    least = min(directions, key=lambda key: directions[key].boundary)
    return AxisDesign(name, goal, uses_robot_gains, least, directions[least], directions)
