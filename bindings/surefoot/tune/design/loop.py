"""One direction's sampled closed loop as a CasADi function of one tick.

Sensors, observers, command line, motors and body in the order and with the steps of the simulated
robot. Small motion is linear; beyond it there are the push observer's dead band, dry friction, and
what the whole-body program can give.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import Error
from surefoot.tune.design.axes import Direction
from surefoot.tune.design.timing import Observers, Timing

Array = npt.NDArray[np.float64]

_BLOCK = 200  # ticks that are computed in one call
_STEP = 0.0005  # [s] longest step of motor and body; the simulated robot's
_FORCE_TIME = 0.005  # [s] LegForces: smooths what the torques say of the ground
# MuJoCo's joints stick softly: its friction asks for x'' = -b x' with b = 2 / (0.95 * 20 ms),
# at an impedance of 0.9 (its defaults solreffriction, solimpfriction), up to the friction's force.
_STICK_RATE, _STICK_SHARE = 2.0 / (0.95 * 0.02), 0.9
# State: position, speed, motor, acceleration; the same at the last two samples; what was planned,
# push and payload observers; then the commands on their way, the newest first.
_STATES = (
    *("x", "v", "motor", "a", "x1", "v1", "a1", "v2", "a2"),
    *("planned", "push", "payload", "force"),
)


class ClosedLoop:
    """The loop of one direction; kp and kd stay open.

    Args:
        direction: Of the body.
        timing: Rate, delay, lag.
        observers: The estimator's.

    Raises:
        Error: CasADi is missing.
    """

    def __init__(self, direction: Direction, timing: Timing, observers: Observers) -> None:
        self.direction, self.timing, self.observers = direction, timing, observers
        self._casadi = load_casadi()
        # The command of this tick acts one period and the delay later: so many are on their way.
        self._latency = timing.period + timing.delay
        self._line = math.ceil(self._latency / timing.period - 1e-9)
        self._share = direction.outside_share
        self._jacobian: Any = None
        self._block: Any = None

    @property
    def states(self) -> int:
        """Number of states."""
        return len(_STATES) + self._line

    def matrix(self, kp: float, kd: float) -> Array:
        """Return A of state+ = A state at rest, shape (states, states).

        Without dry friction, the program's limits, and the push observer, which sleeps.
        """
        if self._jacobian is None:
            state, gains, after = self._tick(linear=True)
            jacobian = self._casadi.jacobian(after, state)
            self._jacobian = self._casadi.Function("matrix", [state, gains], [jacobian])
        return np.asarray(self._jacobian(np.zeros(self.states), [kp, kd]))

    def run(self, kp: float, kd: float, duration: float) -> Array:
        """Return the body's acceleration at every tick after the direction's kick.

        Args:
            kp: Stiffness [1/s^2].
            kd: Damping [1/s].
            duration: [s].

        Returns:
            Shape (ticks,) [m/s^2 or rad/s^2].
        """
        if self._block is None:
            self._block = self._casadi.Function("tick", *self._inputs_outputs()).mapaccum(_BLOCK)
        state = np.zeros(self.states)
        state[_STATES.index("v")] = self.direction.kick
        gains = np.tile([[kp], [kd]], _BLOCK)
        ticks = max(1, math.ceil(duration * self.timing.rate))
        rows: list[Array] = []
        for _ in range(0, ticks, _BLOCK):
            after: Array = np.asarray(self._block(state, gains))
            rows.append(after[_STATES.index("a")])
            state = after[:, -1]
        return np.concatenate(rows)[:ticks]

    def _inputs_outputs(self) -> tuple[list[Any], list[Any]]:
        state, gains, after = self._tick(linear=False)
        return [state, gains], [after]

    def _tick(self, linear: bool) -> tuple[Any, Any, Any]:
        """Return the symbols of state and gains, and the next state."""
        ca, period = self._casadi, self.timing.period
        state, gains = ca.SX.sym("state", self.states), ca.SX.sym("gains", 2)
        s = {name: state[k] for k, name in enumerate(_STATES)}
        sent = [state[len(_STATES) + k] for k in range(self._line)]
        # The gyroscope's rate is the mean over the tick; the velocity has no lag, for the
        # accelerometer carries it.
        speed = 0.5 * (s["v1"] + s["v2"]) if self.direction.rotates else s["v1"]
        push, believed = self._push(s, linear)
        outside = self.observers.push_resist * believed + s["payload"]
        pulled = -gains[0] * s["x1"] - gains[1] * speed - outside
        ground = pulled if linear else self._given(pulled)
        planned = ground + believed + s["payload"]
        # The plan has legs and rotors moved by the outside force too; without it, they are not.
        command = planned - self._share * (believed + s["payload"])
        x, v, motor, a = self._move(s, [command, *sent], linear)
        force = s["force"] + period / (period + _FORCE_TIME) * (s["motor"] - s["force"])
        unexplained = ((s["v"] - s["v1"]) / period - force) / self._share - s["payload"]
        payload = s["payload"] + period / self.observers.payload_time * unexplained
        moved = (x, v, motor, a, s["x"], s["v"], s["a"], s["v1"], s["a1"])
        after = ca.vertcat(*moved, planned, push, payload, force, command, *sent[:-1])
        return state, gains, after

    def _push(self, s: dict[str, Any], linear: bool) -> tuple[Any, Any]:
        """Return the push observer's state, and the outside acceleration that it believes in."""
        if linear or self.direction.rotates:
            return 0.0, 0.0
        period, o = self.timing.period, self.observers
        felt = 0.5 * (s["a1"] + s["a2"])
        # Of the base's origin, which moves further; the plan counted with the old belief.
        seen = self.direction.base_share * (felt - s["planned"]) + self._believed(s["push"])
        push = s["push"] + period / (period + o.push_time) * (seen - s["push"])
        return push, self._believed(push)

    def _believed(self, push: Any) -> Any:
        ca, o = self._casadi, self.observers
        size = ca.fmin(ca.fmax(ca.fabs(push) - o.push_dead_band, 0.0), o.push_max)
        return ca.sign(push) * size

    def _given(self, wanted: Any) -> Any:
        """Return what the whole-body program gives: straight lines between what was measured."""
        ca, limits = self._casadi, self.direction.limits
        given = limits[0, 1]
        for (low, start), (high, end) in itertools.pairwise(limits):
            part = ca.fmin(ca.fmax(wanted - low, 0.0), high - low)
            given = given + (end - start) / (high - low) * part
        return given

    def _move(self, s: dict[str, Any], commands: list[Any], linear: bool) -> tuple[Any, ...]:
        """Return position, speed, motor and acceleration one period later."""
        ca, lag, d = self._casadi, self.timing.motor_lag, self.direction
        steps = math.ceil(self.timing.period / _STEP - 1e-9)
        dt = self.timing.period / steps
        share = -math.expm1(-dt / lag) if lag > 0.0 else 1.0
        x, v, motor, a = s["x"], s["v"], s["motor"], s["a"]
        for k in range(steps):
            motor = motor + share * (self._acting(commands, k * dt, dt) - motor)
            a = motor - d.viscous * v
            if not linear:
                stuck = _STICK_SHARE * (a + _STICK_RATE * v)
                a = a - ca.fmin(ca.fmax(stuck, -d.friction), d.friction)
            v = v + dt * a
            x = x + dt * v
        return x, v, motor, a

    def _acting(self, commands: list[Any], time: float, dt: float) -> Any:
        """Return the mean of the commands that act from `time` on for `dt`, newest first."""
        period = self.timing.period
        age = math.ceil((self._latency - time) / period - 1e-9)
        until = self._latency - (age - 1) * period - time
        part = min(until / dt, 1.0)
        if part > 1.0 - 1e-9:
            return commands[age]
        return part * commands[age] + (1.0 - part) * commands[age - 1]


def load_casadi() -> Any:
    """Import CasADi; raises Error without it."""
    try:
        import casadi
    except ImportError:
        raise Error(
            "surefoot tune design needs CasADi, which is missing: pip install surefoot[tune]"
        ) from None
    return casadi
