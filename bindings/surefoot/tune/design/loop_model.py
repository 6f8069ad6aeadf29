"""Model of one tick of a direction's sampled closed loop, as CasADi expressions of state and gains.

The model has sensors, observers, command delay, motors and body, in the order and with the time
steps of the simulated robot. The linear model is valid for small motion. The complete model adds
the dead band of the push observer, dry friction and the limits of the QP.
docs/how-to/design-gains.md has the equations.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

from surefoot.tune.design.directions import Direction
from surefoot.tune.design.timing import Observers, Timing

# [s] Longest time step of motor and body: the default physics step of the simulated robot.
_MAX_STEP = 0.0005
# Copy of LegForces::kFilterTime.
_FORCE_FILTER_TIME = 0.005  # [s] filter time of the ground forces computed from torques
# Constants of the PushObserver, copied from
# controller/src/estimator/external_wrench/push_observer.cpp:
# - _NOISE_BANDS (kNoiseLevel): innovation above which the filter time is shortened, as a multiple
#   of push_dead_band;
# - _HALVING_BANDS (kHalvingLevel): amount by which the innovation must exceed this value to halve
#   the filter time, as a multiple of push_dead_band;
# - _MIN_TIME_RATIO (kMinTimeScale): shortest filter time as a share of push_time;
# - _MAX_SURPRISE_TIME [s] (kMaxInnovationTime): limit of surprise_time, the duration of large
#   innovations; only below this limit, large innovations shorten the filter time;
# - _SURPRISE_DECAY [1] (kInnovationTimeDecay): decrease of surprise_time per time with small
#   innovations.
_NOISE_BANDS, _HALVING_BANDS, _MIN_TIME_RATIO, _MAX_SURPRISE_TIME, _SURPRISE_DECAY = (
    3.0,
    1.0,
    3.0 / 8.0,
    0.05,
    0.05,
)
# MuJoCo's dry friction is a soft constraint: x'' = -b x', limited to the friction force. By default
# (solreffriction, solimpfriction) b is 2 / (0.95 * 20 ms) and the impedance is 0.9.
_FRICTION_RATE, _FRICTION_IMPEDANCE = 2.0 / (0.95 * 0.02), 0.9
# States of the loop. Line 1: position, velocity, acceleration that the motors cause, acceleration;
# then x, v, a at the last sample (1), and v, a at the sample before (2). Line 2: planned
# acceleration of the base, newest first ("made", "planned_base1", "planned_base2"); then the states
# of the push and payload observers. In the state vector, the commands in flight follow after these
# states, newest first.
STATES = (
    *("x", "v", "motor", "a", "x1", "v1", "a1", "v2", "a2"),
    *("made", "planned_base1", "planned_base2", "push", "payload", "force", "surprise_time"),
)


class Tick:
    """Step of one direction's loop: next state as a function of the state, kp and kd.

    Args:
        casadi: The CasADi module.
        direction: Direction of the body.
        timing: Rate, delay and motor lag.
        observers: Observers of the estimator.
    """

    def __init__(
        self, casadi: Any, direction: Direction, timing: Timing, observers: Observers
    ) -> None:
        self.direction, self.timing, self.observers = direction, timing, observers
        self._casadi = casadi
        # A command is in flight for one period plus the delay, and then acts.
        self._latency = timing.period + timing.delay
        self._commands_in_flight = math.ceil(self._latency / timing.period - 1e-9)
        self._external_ratio = direction.external_acceleration_ratio

    @property
    def state_count(self) -> int:
        """Number of states."""
        return len(STATES) + self._commands_in_flight

    def expressions(self, linear: bool) -> tuple[Any, Any, Any]:
        """Return the symbols of the state and of the gains (kp, kd), and the next state.

        `linear`: whether to omit dry friction, the dead band and the limits of the QP.
        """
        ca, period = self._casadi, self.timing.period
        state, gains = ca.SX.sym("state", self.state_count), ca.SX.sym("gains", 2)
        s = {name: state[k] for k, name in enumerate(STATES)}
        sent = [state[len(STATES) + k] for k in range(self._commands_in_flight)]
        # The gyroscope measures the mean angular velocity over the tick. The estimator integrates
        # the accelerometer to get the linear velocity, so the linear velocity has no lag.
        speed = 0.5 * (s["v1"] + s["v2"]) if self.direction.rotates else s["v1"]
        push, surprise_time, push_estimate = self._update_push_observer(s, linear)
        external = self.observers.push_resist * push_estimate + s["payload"]
        desired = -gains[0] * s["x1"] - gains[1] * speed - external
        achieved = desired if linear else self._qp_response(desired)
        planned = achieved + push_estimate + s["payload"]
        # The controller assumes that the estimated external force also accelerates legs and rotors,
        # and subtracts this part. The model has no external force, so this part is lost.
        command = planned - self._external_ratio * (push_estimate + s["payload"])
        x, v, motor, a = self._step_body(s, [command, *sent], linear)
        force = s["force"] + period / (period + _FORCE_FILTER_TIME) * (s["motor"] - s["force"])
        unexplained = ((s["v"] - s["v1"]) / period - force) / self._external_ratio - s["payload"]
        payload = s["payload"] + period / self.observers.payload_time * unexplained
        moved = (x, v, motor, a, s["x"], s["v"], s["a"], s["v1"], s["a1"])
        # Planned acceleration of the base origin, without the estimated push.
        planned_base = self.direction.base_motion_ratio * planned - push_estimate
        observers = (
            planned_base,
            s["made"],
            s["planned_base1"],
            push,
            payload,
            force,
            surprise_time,
        )
        next_state = ca.vertcat(*moved, *observers, command, *sent[:-1])
        return state, gains, next_state

    def _update_push_observer(self, s: dict[str, Any], linear: bool) -> tuple[Any, Any, Any]:
        """Return the next push and surprise_time, and the estimated external acceleration."""
        if linear or self.direction.rotates:
            return 0.0, 0.0, 0.0
        period = self.timing.period
        measured_acceleration = 0.5 * (s["a1"] + s["a2"])
        innovation = (
            self.direction.base_motion_ratio * measured_acceleration
            - s["planned_base2"]
            - s["push"]
        )
        share, surprise_time = self._push_time_ratio(innovation, s["surprise_time"])
        push = s["push"] + period / (period + self.observers.push_time * share) * innovation
        return push, surprise_time, self._push_estimate(push)

    def _push_time_ratio(self, innovation: Any, surprise_time: Any) -> tuple[Any, Any]:
        """Return the filter time as a share of push_time, and the next surprise_time [s].

        Large innovations shorten the filter time for at most _MAX_SURPRISE_TIME. In the direction
        z, the share is always 1.
        """
        if self.direction.name == "z":
            return 1.0, 0.0
        ca, period, halving_excess = (
            self._casadi,
            self.timing.period,
            _HALVING_BANDS * self.observers.push_dead_band,
        )
        excess = ca.fabs(innovation) - _NOISE_BANDS * self.observers.push_dead_band
        surprise_time = surprise_time + period * ca.if_else(excess > 0.0, 1.0, -_SURPRISE_DECAY)
        surprise_time = ca.fmin(ca.fmax(surprise_time, 0.0), _MAX_SURPRISE_TIME)
        shorter_ratio = ca.fmax(
            halving_excess / (halving_excess + ca.fmax(excess, 1e-9)), _MIN_TIME_RATIO
        )
        uses_full_time = ca.logic_or(excess <= 0.0, surprise_time >= _MAX_SURPRISE_TIME)
        return ca.if_else(uses_full_time, 1.0, shorter_ratio), surprise_time

    def _push_estimate(self, push: Any) -> Any:
        ca, o = self._casadi, self.observers
        size = ca.fmin(ca.fmax(ca.fabs(push) - o.push_dead_band, 0.0), o.push_max)
        return ca.sign(push) * size

    def _qp_response(self, desired: Any) -> Any:
        """Return the acceleration that the QP achieves, looked up in direction.limits."""
        ca, limits = self._casadi, self.direction.limits
        given = limits[0, 1]
        for (low, start), (high, end) in itertools.pairwise(limits):
            part = ca.fmin(ca.fmax(desired - low, 0.0), high - low)
            given = given + (end - start) / (high - low) * part
        return given

    def _step_body(self, s: dict[str, Any], commands: list[Any], linear: bool) -> tuple[Any, ...]:
        """Return position, velocity, motor acceleration and acceleration after one period."""
        ca, lag, d = self._casadi, self.timing.motor_lag, self.direction
        steps = math.ceil(self.timing.period / _MAX_STEP - 1e-9)
        dt = self.timing.period / steps
        share = -math.expm1(-dt / lag) if lag > 0.0 else 1.0
        x, v, motor, a = s["x"], s["v"], s["motor"], s["a"]
        for k in range(steps):
            motor = motor + share * (self._mean_active_command(commands, k * dt, dt) - motor)
            a = motor - d.viscous * v
            if not linear:
                friction_deceleration = _FRICTION_IMPEDANCE * (a + _FRICTION_RATE * v)
                a = a - ca.fmin(ca.fmax(friction_deceleration, -d.friction), d.friction)
            v = v + dt * a
            x = x + dt * v
        return x, v, motor, a

    def _mean_active_command(self, commands: list[Any], time: float, dt: float) -> Any:
        """Return the mean of the commands that act from `time` to `time + dt` [s] in this period.

        `commands` has the newest command first.
        """
        period = self.timing.period
        age = math.ceil((self._latency - time) / period - 1e-9)
        until = self._latency - (age - 1) * period - time
        part = min(until / dt, 1.0)
        if part > 1.0 - 1e-9:
            return commands[age]
        return part * commands[age] + (1.0 - part) * commands[age - 1]
