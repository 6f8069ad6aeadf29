"""Stability margins of a closed loop: poles, gain and delay margins, boundary after a push."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from surefoot.tune.design.closed_loop import ClosedLoop
from surefoot.tune.design.directions import Direction
from surefoot.tune.design.goals import Goal, goal_from_gains
from surefoot.tune.design.stability_search import find_delay_margin, first_unstable, last_stable
from surefoot.tune.design.timing import Observers, Timing

# Ends of the search; chosen. A loop has no lower limit down to 1 % of 2 Hz (docs/how-to/design-
# gains.md).
MAX_GAIN_FACTOR = 30.0  # largest gain margin that is searched
MIN_GAIN_FACTOR = 0.02  # smallest gain margin that is searched
# [Hz] Range searched for the greatest stable frequency. Chosen: the upper end is far above all
# goals (FREQUENCY_RANGE), and bounds the search for loops with a high rate.
FREQUENCY_SEARCH_RANGE = (0.2, 40.0)
# [s] Shortest duration of a run, and durations of the windows at its end and at its beginning.
# oscillates() compares the accelerations in both windows. Chosen. Slow loops run for longer.
_RUN_TIME, _END_WINDOW, _START_WINDOW = 2.4, 0.4, 0.2
# Largest ratio of the peak-to-peak acceleration in the last window to that in the first window, for
# which an oscillation counts as decayed. Chosen: larger than the ratio that remains after friction
# has stopped the motion. With a larger value, a slow oscillation would count as decayed.
_DECAY_RATIO = 0.05
# Numerical: rounding of the eigenvalues of an integrator, whose radius is 1.
_STABLE_RADIUS = 1.0 + 1e-9  # spectral radius from which a loop counts as unstable


@dataclass(frozen=True)
class Margins:
    """Margins of one direction at given gains.

    Attributes:
        pole_frequency: Natural frequency [Hz] of the loop's pole nearest to the goal's pole.
        pole_damping: Damping ratio of the same pole; 1 for a real pole.
        spectral_radius: Greatest magnitude of a pole; the loop at rest is stable below 1.
        gain_up: Factor above 1 on kp and kd at which the loop at rest, without friction, becomes
            unstable; MAX_GAIN_FACTOR if the search found none.
        gain_down: Factor below 1 on kp and kd at which the loop at rest becomes unstable; 0 if the
            search found none.
        delay: Additional delay [s] at which the loop at rest becomes unstable.
        boundary: Smallest factor on kp and kd at which the oscillation after a push does not decay.
        push_delay: Smallest additional delay [s] at which the oscillation after a push does not
            decay.
    """

    pole_frequency: float
    pole_damping: float
    spectral_radius: float
    gain_up: float
    gain_down: float
    delay: float
    boundary: float
    push_delay: float

    @property
    def stable(self) -> bool:
        """True if the loop is stable at rest and settles after a push."""
        return self.spectral_radius < _STABLE_RADIUS and self.boundary > 1.0


def spectral_radius(loop: ClosedLoop, kp: float, kd: float) -> float:
    """Return the greatest magnitude of the poles at rest; the loop is stable below 1."""
    return float(np.abs(np.linalg.eigvals(loop.state_matrix(kp, kd))).max())


def goal_pole(loop: ClosedLoop, goal: Goal) -> tuple[float, float]:
    """Return frequency [Hz] and damping ratio of the pole nearest to the goal's pole."""
    z = np.linalg.eigvals(loop.state_matrix(goal.kp, goal.kd)).astype(complex)
    # Ignore the pole of the payload observer, because it hardly moves the body.
    observer = 1.0 - loop.timing.period / loop.observers.payload_time
    z = np.delete(z, int(np.argmin(np.abs(z - observer))))
    # Ignore the poles of delays, which are at 0. The limit is numerical.
    s = np.log(z[np.abs(z) > 1e-6]) * loop.timing.rate
    wn = 2.0 * math.pi * goal.frequency
    desired_pole = wn * (-goal.damping + np.emath.sqrt(goal.damping**2 - 1.0))
    pole = s[int(np.argmin(np.abs(s - desired_pole)))]
    return float(np.abs(pole)) / (2.0 * math.pi), float(-pole.real / np.abs(pole))


def gain_margins(loop: ClosedLoop, kp: float, kd: float) -> tuple[float, float]:
    """Return the lower and upper limit of the factors on kp and kd with a stable loop at rest.

    (1, 1): the loop is unstable at these gains. A lower limit of 0 or an upper limit of
    MAX_GAIN_FACTOR: the search found no limit.
    """

    def unstable(factor: float) -> bool:
        return spectral_radius(loop, factor * kp, factor * kd) >= _STABLE_RADIUS

    if unstable(1.0):
        return 1.0, 1.0
    down = 1.0 / first_unstable(lambda k: unstable(1.0 / k), 1.0, 1.0 / MIN_GAIN_FACTOR)
    return (0.0 if down <= MIN_GAIN_FACTOR else down), first_unstable(
        unstable, 1.0, MAX_GAIN_FACTOR
    )


def delay_margin(loop: ClosedLoop, kp: float, kd: float) -> float:
    """Return the additional delay [s] at which the loop at rest becomes unstable."""
    return find_delay_margin(
        loop, lambda delayed_loop: spectral_radius(delayed_loop, kp, kd) >= _STABLE_RADIUS
    )


def oscillates(loop: ClosedLoop, kp: float, kd: float) -> bool:
    """Return whether a push starts an oscillation that does not decay."""
    goal = goal_from_gains(kp, kd)
    # A slow loop needs more time to settle: 8 time constants.
    settling = 8.0 / (min(goal.damping, 1.0) * 2.0 * math.pi * goal.frequency)
    # The limit of 20 s is chosen; it bounds the run time for very slow goals.
    a = loop.simulate(kp, kd, max(_RUN_TIME, min(settling, 20.0)))
    if not np.isfinite(a).all():
        return True
    rate = loop.timing.rate
    first, last = a[: int(_START_WINDOW * rate)], a[-int(_END_WINDOW * rate) :]
    return float(np.ptp(last)) > _DECAY_RATIO * float(np.ptp(first))


def oscillation_boundary(loop: ClosedLoop, kp: float, kd: float) -> float:
    """Return the smallest factor on kp and kd at which the oscillation after a push stays.

    The model includes dry friction, the dead band of the push observer and the limits of the QP.
    0: the loop also oscillates at all smaller factors that were tried, down to 0.05.
    """

    def unstable(factor: float) -> bool:
        return oscillates(loop, factor * kp, factor * kd)

    if not unstable(1.0):
        return first_unstable(unstable, 1.0, MAX_GAIN_FACTOR)
    lower = 1.0
    while lower > 0.05 and unstable(lower):
        lower /= 1.25
    return 0.0 if lower <= 0.05 else first_unstable(unstable, lower, 1.0)


def push_delay_margin(loop: ClosedLoop, kp: float, kd: float) -> float:
    """Return the smallest additional delay [s] at which the oscillation after a push stays."""
    return find_delay_margin(loop, lambda delayed_loop: oscillates(delayed_loop, kp, kd))


def max_stable_frequency(
    direction: Direction, timing: Timing, observers: Observers, damping: float
) -> float:
    """Return the greatest stable natural frequency [Hz] in FREQUENCY_SEARCH_RANGE.

    The damping ratio is fixed. The result is stable and within 1 % of the limit. 0: no frequency
    in the range is stable.
    """
    loop = ClosedLoop(direction, timing, observers)
    low, high = FREQUENCY_SEARCH_RANGE

    def unstable(frequency: float) -> bool:
        goal = Goal(frequency, damping)
        if spectral_radius(loop, goal.kp, goal.kd) >= _STABLE_RADIUS:
            return True
        return oscillates(loop, goal.kp, goal.kd)

    return 0.0 if unstable(low) else last_stable(unstable, low, high)[0]


def all_margins(loop: ClosedLoop, goal: Goal) -> Margins:
    """Return all margins at the gains of a goal."""
    kp, kd = goal.kp, goal.kd
    frequency, damping = goal_pole(loop, goal)
    down, up = gain_margins(loop, kp, kd)
    return Margins(
        pole_frequency=frequency,
        pole_damping=damping,
        spectral_radius=spectral_radius(loop, kp, kd),
        gain_up=up,
        gain_down=down,
        delay=delay_margin(loop, kp, kd),
        boundary=oscillation_boundary(loop, kp, kd),
        push_delay=push_delay_margin(loop, kp, kd),
    )
