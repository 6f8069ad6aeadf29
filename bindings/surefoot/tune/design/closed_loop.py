"""Sampled closed loop of one direction: state matrix at rest, and simulation after a push."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import Error
from surefoot.tune.design.directions import Direction
from surefoot.tune.design.loop_model import STATES, Tick
from surefoot.tune.design.timing import Observers, Timing

Array = npt.NDArray[np.float64]

# Chosen: the overhead of a call is small against its ticks. simulate() computes whole blocks, so a
# larger block would compute more unused ticks.
_BLOCK_TICKS = 200  # number of ticks that one CasADi call computes


class ClosedLoop:
    """Closed loop of one direction as a function of kp and kd.

    Args:
        direction: Direction of the body.
        timing: Rate, delay and motor lag.
        observers: Observers of the estimator.

    Raises:
        Error: CasADi is missing.
    """

    def __init__(self, direction: Direction, timing: Timing, observers: Observers) -> None:
        self.direction, self.timing, self.observers = direction, timing, observers
        self._casadi = load_casadi()
        self._tick = Tick(self._casadi, direction, timing, observers)
        self._state_jacobian: Any = None
        self._simulate_block: Any = None

    @property
    def state_count(self) -> int:
        """Number of states."""
        return self._tick.state_count

    def state_matrix(self, kp: float, kd: float) -> Array:
        """Return the matrix A of (next state) = A (state) at rest, shape (states, states).

        The matrix omits dry friction, the limits of the QP, and the push observer, whose input is
        inside its dead band at rest.
        """
        if self._state_jacobian is None:
            state, gains, after = self._tick.expressions(linear=True)
            jacobian = self._casadi.jacobian(after, state)
            self._state_jacobian = self._casadi.Function("matrix", [state, gains], [jacobian])
        return np.asarray(self._state_jacobian(np.zeros(self.state_count), [kp, kd]))

    def simulate(self, kp: float, kd: float, duration: float) -> Array:
        """Simulate the loop after a push that gives the body direction.push_velocity.

        Args:
            kp: Stiffness [1/s^2].
            kd: Damping [1/s].
            duration: Simulated time [s].

        Returns:
            Acceleration of the body at every tick, shape (ticks,) [m/s^2 or rad/s^2].
        """
        if self._simulate_block is None:
            before, gains, moved = self._tick.expressions(linear=False)
            tick = self._casadi.Function("tick", [before, gains], [moved])
            self._simulate_block = tick.mapaccum(_BLOCK_TICKS)
        state = np.zeros(self.state_count)
        state[STATES.index("v")] = self.direction.push_velocity
        both = np.tile([[kp], [kd]], _BLOCK_TICKS)
        ticks = max(1, math.ceil(duration * self.timing.rate))
        rows: list[Array] = []
        for _ in range(0, ticks, _BLOCK_TICKS):
            after: Array = np.asarray(self._simulate_block(state, both))
            rows.append(after[STATES.index("a")])
            state = after[:, -1]
        return np.concatenate(rows)[:ticks]


def load_casadi() -> Any:
    """Import CasADi and return the module; raise Error if CasADi is missing."""
    try:
        import casadi
    except ImportError:
        raise Error(
            "surefoot tune design needs CasADi, which is missing: pip install surefoot[tune]"
        ) from None
    return casadi
