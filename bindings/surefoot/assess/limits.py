"""How hard a standing robot can be pushed with its feet where they are: closed formulas.

A linear inverted pendulum: mass m at height h, w = sqrt(g / h), pushed from x = 0 towards the edge
of support at x = d by a force F for a time T, along a line `lift` above the centre of mass. The
body does not turn, so the moment of the push takes its share of the ground's leverage:

    ground on robot, backwards:  b = (m g (p - x) - lift F) / h,    pressure p <= d,    b <= B

where B is what friction (mu m g) or the motors allow. It survives if its capture point is inside
the edge once it can only brake. Braking as hard as can be is best, for b <= ... only falls with x.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from surefoot.sim.support import GRAVITY, pendulum_impulse

_HALVINGS = 60


@dataclass(frozen=True)
class Pendulum:
    """A pendulum and its edge.

    Attributes:
        mass: m [kg].
        height: h of the centre of mass [m].
        distance: d from there to the edge of support, seen from above [m].
    """

    mass: float
    height: float
    distance: float


def lip_impulse(pendulum: Pendulum, duration: float, lift: float = 0.0) -> float:
    """Return the greatest impulse with friction and motors without limits [N.s].

    J = m w d (w T) / (1 - exp(-w T)) * h / (h + lift)

    Args:
        pendulum: Who is pushed.
        duration: Of the push, T [s].
        lift: Of its line of action above the centre of mass [m].
    """
    p = pendulum
    share = p.height / (p.height + lift)
    return share * pendulum_impulse(p.mass, p.height, p.distance, duration)


def braked_impulse(pendulum: Pendulum, brake: float, duration: float, lift: float = 0.0) -> float:
    """Return the greatest impulse where the ground gives no more than a force B [N.s].

    For T -> 0 and lift = 0 it is m sqrt(mu g (2 d - mu h)) with mu = B / (m g) < d / h; with a B
    that the pendulum never needs it is lip_impulse().

    Args:
        pendulum: Who is pushed.
        brake: B, against the push [N].
        duration: T [s].
        lift: See lip_impulse().
    """
    most = lip_impulse(pendulum, duration, lift)
    if _survives(pendulum, brake, most / duration, duration, lift):
        return most
    low, high = 0.0, most
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        if _survives(pendulum, brake, middle / duration, duration, lift):
            low = middle
        else:
            high = middle
    return low


def _survives(p: Pendulum, brake: float, force: float, duration: float, lift: float) -> bool:
    x, v = _pushed(p, brake, force, duration, lift)
    most = brake / p.mass  # [m/s^2] of braking
    w2 = GRAVITY / p.height
    turn = p.distance - most / w2  # from here on the edge, not B, is what limits
    if x >= turn:
        return v <= math.sqrt(w2) * (p.distance - x) * (1.0 + 1e-12)
    # v^2 left after braking by B to the turn must be what the edge can still take: w (d - turn).
    return v**2 - 2.0 * most * (turn - x) <= most**2 / w2


def _pushed(
    p: Pendulum, brake: float, force: float, duration: float, lift: float
) -> tuple[float, float]:
    """Return where the pendulum is at the push's end, and how fast: x [m], v [m/s]."""
    w2 = GRAVITY / p.height
    most = brake / p.mass
    turn = p.distance - most / w2 - lift * force / (p.mass * GRAVITY)
    x, v, left = 0.0, 0.0, duration
    if turn > 0.0:
        a = force / p.mass - most
        if a <= 0.0:
            return 0.0, 0.0
        time = min(left, math.sqrt(2.0 * turn / a))
        x, v, left = 0.5 * a * time**2, a * time, left - time
    # Pressure at the edge: x'' = w^2 (x - d) + (1 + lift / h) F / m.
    w = math.sqrt(w2)
    centre = p.distance - (1.0 + lift / p.height) * force / (p.mass * w2)
    c, s = math.cosh(w * left), math.sinh(w * left)
    return centre + (x - centre) * c + v / w * s, (x - centre) * w * s + v * c
