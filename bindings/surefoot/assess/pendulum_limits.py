"""Largest impulses that a linear inverted pendulum (LIP) survives without a step.

Model: mass m at height h, w = sqrt(g / h). A force F acts for a time T at `push_height` a above the
centre of mass and pushes the LIP from x = 0 towards the support edge at x = d. The body does not
rotate, so the ground must balance the moment a F of the push as well:

    force of the ground against the push:  b = (m g (p - x) - a F) / h,    p <= d,    b <= B

Here p is the centre of pressure, and B is the limit by friction (mu m g) or by the motors. The LIP
survives if its capture point is inside the edge once it can only brake. Braking with the largest b
is optimal, because the bound on b decreases with x.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot.sim.lip_push_limit import GRAVITY, max_lip_impulse

_BISECTIONS = 60  # numerical: more halvings than the 53 bits of a double


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
    """Return the LIP push limit [N.s]; friction and motors have no limits.

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
    """Return the largest impulse that is survived with a ground force of at most B [N.s].

    For T -> 0 and a = 0 the result is m sqrt(mu g (2 d - mu h)) with mu = B / (m g) < d / h. If B
    never limits the braking, the result is lip_impulse(). Found by bisection.

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
    x, v = _state_after_push(p, max_brake_force, force, duration, push_height)
    most = max_brake_force / p.mass  # [m/s^2] largest deceleration by B
    w2 = GRAVITY / p.com_height
    x_switch = p.edge_distance - most / w2  # [m] beyond it the edge limits braking, before it B
    if x >= x_switch:
        # 1e-12: rounding must not turn the exact LIP push limit into a fall.
        return v <= math.sqrt(w2) * (p.edge_distance - x) * (1.0 + 1e-12)
    # Braking by B to x_switch must leave no more speed than the edge can brake: w (d - x_switch).
    return v**2 - 2.0 * most * (x_switch - x) <= most**2 / w2


def _state_after_push(
    p: Pendulum, max_brake_force: float, force: float, duration: float, push_height: float
) -> tuple[float, float]:
    """Return position x [m] and velocity v [m/s] of the pendulum at the end of the push."""
    w2 = GRAVITY / p.com_height
    most = max_brake_force / p.mass
    x_switch = p.edge_distance - most / w2 - push_height * force / (p.mass * GRAVITY)
    x, v, time_left = 0.0, 0.0, duration
    if x_switch > 0.0:
        a = force / p.mass - most
        if a <= 0.0:
            return 0.0, 0.0
        time = min(time_left, math.sqrt(2.0 * x_switch / a))
        x, v, time_left = 0.5 * a * time**2, a * time, time_left - time
    # With the centre of pressure at the edge: x'' = w^2 (x - d) + (1 + a / h) F / m.
    w = math.sqrt(w2)
    equilibrium = p.edge_distance - (1.0 + push_height / p.com_height) * force / (p.mass * w2)
    c, s = math.cosh(w * time_left), math.sinh(w * time_left)
    return equilibrium + (x - equilibrium) * c + v / w * s, (x - equilibrium) * w * s + v * c
