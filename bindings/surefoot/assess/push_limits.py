"""What a push is measured by: the pendulum's limit and the robot's own, in one direction."""

from __future__ import annotations

from dataclasses import dataclass, replace

from surefoot._core import Error, Robot
from surefoot.assess.condition import Condition
from surefoot.assess.pendulum_limits import Pendulum, force_limited_impulse, lip_impulse
from surefoot.assess.quasi_static import quasi_static_force
from surefoot.assess.stance_model import StanceModel, stance_model

MIN_HEIGHT_SHARE = 0.75  # of the centre of mass's height that a push may be below it


@dataclass(frozen=True)
class PushLimit:
    """Limits of pushes of one direction, length and height, at the pinned standing pose.

    Attributes:
        lip: Of the linear inverted pendulum, friction and motors without limits [N.s].
        quasi_static_force: The largest that friction and motors can lean against [N].
        quasi_static: Of the pendulum whose ground gives no more than that force [N.s].
    """

    lip: float
    quasi_static_force: float
    quasi_static: float

    @property
    def limit(self) -> float:
        """The robot's own limit: the smaller of both [N.s]."""
        return min(self.lip, self.quasi_static)


def push_limit(
    stance: StanceModel, direction_deg: float, duration: float, push_height: float, friction: float
) -> PushLimit:
    """Return the limits of a push.

    Args:
        stance: The robot.
        direction_deg: From forward towards left [deg].
        duration: [s].
        push_height: Of its line of action above the centre of mass [m].
        friction: True coefficient.

    Raises:
        Error: The robot cannot stand there, or the push is as good as on the ground.
    """
    lowest = -MIN_HEIGHT_SHARE * stance.height
    if push_height < lowest:
        raise Error(
            f"heights_m: got {push_height:g}, expected from {lowest:.3f} up: nearer to the ground, "
            f"{stance.height:.3f} m below the centre of mass, a push does not tip the robot"
        )
    pendulum = Pendulum(stance.mass, stance.height, stance.edge_distance(direction_deg))
    force = quasi_static_force(stance, direction_deg, friction)
    return PushLimit(
        lip_impulse(pendulum, duration, push_height),
        force,
        force_limited_impulse(pendulum, force, duration, push_height),
    )


class PushLimits:
    """Limits of pushes on one robot; each is computed once.

    Args:
        robot: Whose.
    """

    def __init__(self, robot: Robot) -> None:
        self.stance = stance_model(robot)
        self._cache: dict[tuple[float, ...], PushLimit] = {}

    def true_mass(self, condition: Condition) -> float:
        """Return the robot's true mass under a condition, payload included [kg]."""
        return (1.0 + condition.mass_share + condition.payload_share) * self.stance.mass

    def push_limit(
        self, condition: Condition, direction_deg: float, duration: float, push_height: float
    ) -> PushLimit:
        """Return the limits of a push under a condition: of its friction and its true mass."""
        mass = self.true_mass(condition)
        key = (direction_deg, duration, push_height, condition.friction, mass)
        if key not in self._cache:
            stance = replace(self.stance, mass=mass)
            self._cache[key] = push_limit(
                stance, direction_deg, duration, push_height, condition.friction
            )
        return self._cache[key]
