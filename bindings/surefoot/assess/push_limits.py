"""Push limits in one direction: LIP push limit, quasi-static push limit, and the smaller one."""

from __future__ import annotations

from dataclasses import dataclass, replace

from surefoot._core import Error, Robot
from surefoot.assess.condition import Condition
from surefoot.assess.pendulum_limits import Pendulum, force_limited_impulse, lip_impulse
from surefoot.assess.quasi_static import quasi_static_force
from surefoot.assess.stance_model import StanceModel, stance_model

# Largest depth of a push below the centre of mass, as a share of the height h of the centre of
# mass. The push limits grow with h / (h + a), where a is the push height above the centre of mass,
# so they become infinite at the ground. Chosen: a push near the ground does not tip the robot. The
# lowest push of the scorecard (a = -0.1 m) has a share of about a third.
MAX_DEPTH_SHARE = 0.75


@dataclass(frozen=True)
class PushLimit:
    """Limits of pushes of one direction, duration and height, in the pinned standing pose.

    Attributes:
        lip: LIP push limit [N.s]; it ignores the limits of friction and motors.
        quasi_static_force: Largest static force that friction and motors can balance [N].
        quasi_static: Largest impulse that a LIP survives if its horizontal ground force is at most
            `quasi_static_force` [N.s].
    """

    lip: float
    quasi_static_force: float
    quasi_static: float

    @property
    def limit(self) -> float:
        """Push limit: the smaller of the LIP and the quasi-static push limit [N.s]."""
        return min(self.lip, self.quasi_static)


def push_limit(
    stance: StanceModel, direction_deg: float, duration: float, push_height: float, friction: float
) -> PushLimit:
    """Compute the limits of a push.

    Args:
        stance: Model of the standing robot.
        direction_deg: Direction of the push, from forward towards left [deg].
        duration: Duration of the push [s].
        push_height: Height of the line of action above the centre of mass [m].
        friction: True friction coefficient.

    Raises:
        Error: The robot cannot stand in this pose, or the push acts too close to the ground.
    """
    lowest = -MAX_DEPTH_SHARE * stance.height
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
    """Cache of the push limits of one robot.

    Args:
        robot: Model of the robot.
        stance: Standing robot for which the limits hold; None: that of the model.
    """

    def __init__(self, robot: Robot, stance: StanceModel | None = None) -> None:
        self.stance = stance or stance_model(robot)
        self._cache: dict[tuple[float, ...], PushLimit] = {}

    def true_mass(self, condition: Condition) -> float:
        """Return the true mass of the robot under a condition, including the payload [kg]."""
        return (1.0 + condition.mass_share + condition.payload_share) * self.stance.mass

    def push_limit(
        self, condition: Condition, direction_deg: float, duration: float, push_height: float
    ) -> PushLimit:
        """Return the limits of a push, for the friction and the true mass of a condition.

        Args:
            condition: Condition under which the push acts.
            direction_deg: Direction of the push, from forward towards left [deg].
            duration: Duration of the push [s].
            push_height: Height of the line of action above the centre of mass [m].

        Raises:
            Error: As in the function push_limit().
        """
        mass = self.true_mass(condition)
        key = (direction_deg, duration, push_height, condition.friction, mass)
        if key not in self._cache:
            stance = replace(self.stance, mass=mass)
            self._cache[key] = push_limit(
                stance, direction_deg, duration, push_height, condition.friction
            )
        return self._cache[key]
