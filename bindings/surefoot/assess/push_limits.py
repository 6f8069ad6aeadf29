"""What a push is measured by: the pendulum's limit and the robot's own, in one direction."""

from __future__ import annotations

from dataclasses import dataclass, replace

from surefoot._core import Error, Robot
from surefoot.assess.condition import Condition
from surefoot.assess.limits import Pendulum, braked_impulse, lip_impulse
from surefoot.assess.pinned import Pinned, pin
from surefoot.assess.quasi_static import quasi_static_force

LOWEST_SHARE = 0.75  # of the centre of mass's height that a push may be below it


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
    def own(self) -> float:
        """The robot's own limit: the smaller of both [N.s]."""
        return min(self.lip, self.quasi_static)


def push_limit(
    pinned: Pinned, degrees: float, duration: float, lift: float, friction: float
) -> PushLimit:
    """Return the limits of a push.

    Args:
        pinned: The robot.
        degrees: From forward towards left [deg].
        duration: [s].
        lift: Of its line of action above the centre of mass [m].
        friction: True coefficient.

    Raises:
        Error: The robot cannot stand there, or the push is as good as on the ground.
    """
    lowest = -LOWEST_SHARE * pinned.height
    if lift < lowest:
        raise Error(
            f"heights_m: got {lift:g}, expected from {lowest:.3f} up: nearer to the ground, "
            f"{pinned.height:.3f} m below the centre of mass, a push does not tip the robot"
        )
    pendulum = Pendulum(pinned.mass, pinned.height, pinned.reach(degrees))
    force = quasi_static_force(pinned, degrees, friction)
    return PushLimit(
        lip_impulse(pendulum, duration, lift),
        force,
        braked_impulse(pendulum, force, duration, lift),
    )


class Limits:
    """Limits of pushes on one robot; each is computed once.

    Args:
        robot: Whose.
    """

    def __init__(self, robot: Robot) -> None:
        self.pinned = pin(robot)
        self._known: dict[tuple[float, ...], PushLimit] = {}

    def mass(self, condition: Condition) -> float:
        """Return the robot's true mass under a condition, payload included [kg]."""
        return (1.0 + condition.mass_share + condition.payload_share) * self.pinned.mass

    def of(self, condition: Condition, degrees: float, duration: float, lift: float) -> PushLimit:
        """Return the limits of a push under a condition: of its friction and its true mass."""
        mass = self.mass(condition)
        key = (degrees, duration, lift, condition.friction, mass)
        if key not in self._known:
            pinned = replace(self.pinned, mass=mass)
            self._known[key] = push_limit(pinned, degrees, duration, lift, condition.friction)
        return self._known[key]
