"""Largest impulses that a linear inverted pendulum (LIP) survives without a step.

Model: a mass m at height h, with w = sqrt(g / h). A force F acts for a time T, at the distance a
(`push_height`) above the centre of mass. F pushes the LIP from x = 0 towards the support edge at
x = d. The body does not rotate, so the ground must also balance the moment a F of the push:

    force of the ground against the push:  b = (m g (p - x) - a F) / h,    p <= d,    b <= B

Here p is the centre of pressure, and B is the largest force that friction (mu m g) or the motors
allow. The LIP survives if its capture point can be kept inside the support edge. Braking with the
largest b at all times is optimal: weaker braking lets x grow, and the largest possible b decreases
with x.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot.sim.lip_push_limit import GRAVITY, max_lip_impulse

_BISECTIONS = 60  # number of halvings; numerical: more than the 53 bits of a double


@dataclass(frozen=True)
class Pendulum:
    """A linear inverted pendulum and the distance to its support edge.

    Attributes:
        mass: Mass m [kg].
        com_height: Height h of the centre of mass [m].
        edge_distance: Horizontal distance d from the centre of mass to the support edge [m].
    """

    mass: float
    com_height: float
    edge_distance: float


def lip_impulse(pendulum: Pendulum, duration: float, push_height: float = 0.0) -> float:
    """Return the LIP push limit J [N.s], without the limits of friction and motors.

    J = m w d (w T) / (1 - exp(-w T)) * h / (h + a)

    Args:
        pendulum: Pendulum that is pushed.
        duration: Duration T of the push [s].
        push_height: Height a of the line of action above the centre of mass [m].
    """
    p = pendulum
    share = p.com_height / (p.com_height + push_height)
    return share * max_lip_impulse(p.mass, p.com_height, p.edge_distance, duration)


def force_limited_impulse(
    pendulum: Pendulum, max_brake_force: float, duration: float, push_height: float = 0.0
) -> float:
    """Return the largest impulse [N.s] that the LIP survives with a ground force of at most B [N].

    For T -> 0, a = 0 and mu = B / (m g) < d / h, the result is m sqrt(mu g (2 d - mu h)). If B
    never limits the braking, the result is lip_impulse(). The function uses bisection.

    Args:
        pendulum: Pendulum that is pushed.
        max_brake_force: Largest horizontal ground force B against the push [N].
        duration: Duration T of the push [s].
        push_height: Height a of the line of action above the centre of mass [m].
    """
    lip_limit = lip_impulse(pendulum, duration, push_height)
    if _survives(pendulum, max_brake_force, lip_limit / duration, duration, push_height):
        return lip_limit
    low, high = 0.0, lip_limit
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        if _survives(pendulum, max_brake_force, middle / duration, duration, push_height):
            low = middle
        else:
            high = middle
    return low


def _survives(
    p: Pendulum, max_brake_force: float, force: float, duration: float, push_height: float
) -> bool:
    """Return True if the pendulum survives a push with a constant force [N]."""
    x, v = _state_after_push(p, max_brake_force, force, duration, push_height)
    max_deceleration = max_brake_force / p.mass  # [m/s^2] deceleration by B
    w2 = GRAVITY / p.com_height
    # [m] At smaller x, B limits the braking force; at larger x, the support edge limits it.
    x_switch = p.edge_distance - max_deceleration / w2
    if x >= x_switch:
        # The factor 1 + 1e-12 lets the exact LIP push limit survive despite rounding.
        return v <= math.sqrt(w2) * (p.edge_distance - x) * (1.0 + 1e-12)
    # The LIP brakes with B up to x_switch. There its speed may be at most w (d - x_switch), the
    # highest speed that the support edge allows it to brake.
    return v**2 - 2.0 * max_deceleration * (x_switch - x) <= max_deceleration**2 / w2


def _state_after_push(
    p: Pendulum, max_brake_force: float, force: float, duration: float, push_height: float
) -> tuple[float, float]:
    """Return position x [m] and velocity v [m/s] of the pendulum at the end of the push."""
    w2 = GRAVITY / p.com_height
    max_deceleration = max_brake_force / p.mass
    x_switch = p.edge_distance - max_deceleration / w2 - push_height * force / (p.mass * GRAVITY)
    x, v, time_left = 0.0, 0.0, duration
    if x_switch > 0.0:
        a = force / p.mass - max_deceleration
        if a <= 0.0:
            return 0.0, 0.0
        time = min(time_left, math.sqrt(2.0 * x_switch / a))
        x, v, time_left = 0.5 * a * time**2, a * time, time_left - time
    # From here on the centre of pressure is at the edge: x'' = w^2 (x - d) +
    # (1 + push_height / h) F / m.
    w = math.sqrt(w2)
    equilibrium = p.edge_distance - (1.0 + push_height / p.com_height) * force / (p.mass * w2)
    c, s = math.cosh(w * time_left), math.sinh(w * time_left)
    return equilibrium + (x - equilibrium) * c + v / w * s, (x - equilibrium) * w * s + v * c
