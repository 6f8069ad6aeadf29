"""How hard a standing robot can be pushed with its feet where they are: closed formulas.

A linear inverted pendulum: mass m at height h, w = sqrt(g / h), pushed from x = 0 towards the edge
of support at x = d by a force F for a time T, along a line `push_height` above the centre of mass. The
body does not turn, so the moment of the push takes its share of the ground's leverage:

    ground on robot, backwards:  b = (m g (p - x) - lift F) / h,    pressure p <= d,    b <= B

where B is what friction (mu m g) or the motors allow. It survives if its capture point is inside
the edge once it can only brake. Braking as hard as can be is best, for b <= ... only falls with x.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot.sim.lip_push_limit import GRAVITY, max_lip_impulse

_BISECTIONS = 60


@dataclass(frozen=True)
class Pendulum:
    """A pendulum and its edge.

    Attributes:
        mass: m [kg].
        com_height: h of the centre of mass [m].
        edge_distance: d from there to the edge of support, seen from above [m].
    """

    mass: float
    com_height: float
    edge_distance: float


def lip_impulse(pendulum: Pendulum, duration: float, push_height: float = 0.0) -> float:
    """Return the greatest impulse with friction and motors without limits [N.s].

    J = m w d (w T) / (1 - exp(-w T)) * h / (h + lift)

    Args:
        pendulum: Who is pushed.
        duration: Of the push, T [s].
        push_height: Of its line of action above the centre of mass [m].
    """
    p = pendulum
    share = p.com_height / (p.com_height + push_height)
    return share * max_lip_impulse(p.mass, p.com_height, p.edge_distance, duration)


def force_limited_impulse(
    pendulum: Pendulum, max_brake_force: float, duration: float, push_height: float = 0.0
) -> float:
    """Return the greatest impulse where the ground gives no more than a force B [N.s].

    For T -> 0 and lift = 0 it is m sqrt(mu g (2 d - mu h)) with mu = B / (m g) < d / h; with a B
    that the pendulum never needs it is lip_impulse().

    Args:
        pendulum: Who is pushed.
        max_brake_force: B, against the push [N].
        duration: T [s].
        push_height: See lip_impulse().
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
    most = max_brake_force / p.mass  # [m/s^2] of braking
    w2 = GRAVITY / p.com_height
    x_switch = p.edge_distance - most / w2  # from here on the edge, not B, is what limits
    if x >= x_switch:
        return v <= math.sqrt(w2) * (p.edge_distance - x) * (1.0 + 1e-12)
    # v^2 left after braking by B to x_switch must be what the edge can still take: w (d - x_switch).
    return v**2 - 2.0 * most * (x_switch - x) <= most**2 / w2


def _state_after_push(
    p: Pendulum, max_brake_force: float, force: float, duration: float, push_height: float
) -> tuple[float, float]:
    """Return where the pendulum is at the push's end, and how fast: x [m], v [m/s]."""
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
    # Pressure at the edge: x'' = w^2 (x - d) + (1 + lift / h) F / m.
    w = math.sqrt(w2)
    equilibrium = p.edge_distance - (1.0 + push_height / p.com_height) * force / (p.mass * w2)
    c, s = math.cosh(w * time_left), math.sinh(w * time_left)
    return equilibrium + (x - equilibrium) * c + v / w * s, (x - equilibrium) * w * s + v * c
