"""From goals to gains: each axis designed, its margins computed, what cannot be stable refused."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, Gains
from surefoot.tune.design.axes import AXES, Body
from surefoot.tune.design.goals import Goal, goal_of
from surefoot.tune.design.loop import ClosedLoop
from surefoot.tune.design.margins import Margins, all_margins
from surefoot.tune.design.measure import measure_body
from surefoot.tune.design.refusal import refusal_text
from surefoot.tune.design.settings import IMU_DOUBTS, LEG_DOUBTS, DesignSettings
from surefoot.tune.design.timing import Observers

THIN_GAIN = 2.0  # margins below are warned of
THIN_PERIODS = 1.0


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
        Error: An axis that is none, a gain or a number of the settings out of its range; a loop
            that cannot be stable, with the greatest frequency that is; CasADi is missing.
    """
    settings.check()
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
    for trust, names in (
        (settings.trust_imu, IMU_DOUBTS),
        (settings.trust_legs, LEG_DOUBTS),
    ):
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
            whose = f"{name}: the robot's own gains, " if own else f"{name}: "
            asked = goal, settings.timing, body.of_axis(name)
            raise Error(refusal_text(whose, *asked, observers))
        directions[direction.name] = margins
    least = min(directions, key=lambda key: directions[key].boundary)
    return AxisDesign(name, goal, own, least, directions[least], directions)
