"""Twelve motors with their own drivers: the SDK's law, the torque-speed curve, a lag."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from surefoot._core import RobotConfig, VelStopF
from surefoot.low_state_layout import MOTORS
from surefoot.sim.flaws import Flaws
from surefoot.sim.rotations import Array
from surefoot.sim.wire import Command

SERVO = 0x0A
DAMPING = 0x00
# The SDK's PosStopF is 2.146e9, that of the vendor's Python examples 1e9; no joint turns so far.
POSITION_OFF = 1e9  # [rad]
BRAKE_KD = 3.0  # [N.m.s/rad] of a motor that is not in servo mode


@dataclass(frozen=True)
class Law:
    """The torque that a driver makes from its own joint: offset - kp q' - kd dq', all (12,).

    mode (12,) is what LowState says of the motors meanwhile.
    """

    offset: Array
    kp: Array
    kd: Array
    mode: npt.NDArray[np.uint8] = field(default_factory=lambda: np.full(MOTORS, SERVO, np.uint8))


def command_law(command: Command) -> Law:
    """Return the law tau' = tau + Kp (q - q') + Kd (dq - dq') of a command.

    q = PosStopF (or any angle of 1e9 rad and more) switches the position term off, dq = VelStopF
    the velocity term. A motor in any mode but servo (0x0A) ignores all that and brakes.
    """
    kp = np.where(np.abs(command.q) >= POSITION_OFF, 0.0, command.kp)
    kd = np.where(np.abs(command.dq) >= VelStopF, 0.0, command.kd)
    offset = command.tau + kp * command.q + kd * command.dq
    braking = command.mode != SERVO
    if braking.any():
        offset[braking], kp[braking], kd[braking] = 0.0, 0.0, BRAKE_KD
    return Law(offset, kp, kd, np.where(braking, DAMPING, SERVO).astype(np.uint8))


def damping_law() -> Law:
    """Return the law of motors that brake, as in mode 0x00."""
    mode = np.full(MOTORS, DAMPING, np.uint8)
    return Law(np.zeros(MOTORS), np.zeros(MOTORS), np.full(MOTORS, BRAKE_KD), mode)


def hold_law(q: Array, kp: float, kd: float) -> Law:
    """Return the law of a robot held in position mode at joint angles q (12,) [rad]."""
    return Law(kp * q, np.full(MOTORS, kp), np.full(MOTORS, kd))


class Motors:
    """Turns the law in force into joint torques, one physics step at a time.

    Args:
        config: Limits: tau_max up to corner_speed, none at no_load_speed.
        dt: Physics step [s].
        lag: Time constant of the torque [s]; 0 is none.
        scale_rng: Draws each motor's lasting torque error; None for perfect motors.
        torque_error: Greatest fraction of that error.

    Attributes:
        law: The law in force.
        believed: (12,) torque that the drivers think they make [N.m].
        torque: (12,) torque that they make [N.m].
    """

    def __init__(
        self,
        config: RobotConfig,
        dt: float,
        lag: float,
        scale_rng: np.random.Generator | None,
        torque_error: float = Flaws.torque_error,
    ) -> None:
        self.law = Law(np.zeros(MOTORS), np.zeros(MOTORS), np.zeros(MOTORS))
        self.believed = np.zeros(MOTORS)
        self.torque = np.zeros(MOTORS)
        # A first-order lag, exact for a target that holds for one step.
        self._share = 1.0 if lag <= 0.0 else -math.expm1(-dt / lag)
        self._scale = np.ones(MOTORS)
        if scale_rng is not None:
            self._scale = scale_rng.uniform(1 - torque_error, 1 + torque_error, MOTORS)
        self._tau_max = np.array(config.tau_max)
        self._slope = self._tau_max / (np.array(config.no_load_speed) - config.corner_speed)
        self._stall = self._slope * config.no_load_speed

    def limits(self, dq: Array) -> tuple[Array, Array]:
        """Return the least and the greatest torque (12,) [N.m] at velocities dq (12,) [rad/s].

        Full torque up to corner_speed, from there linear to zero at no_load_speed; a braking
        motor keeps its full torque.
        """
        fall = self._slope * dq
        up = np.maximum(np.minimum(self._stall - fall, self._tau_max), 0.0)
        down = np.maximum(np.minimum(self._stall + fall, self._tau_max), 0.0)
        return -down, up

    def step(self, q: Array, dq: Array) -> Array:
        """Advance one physics step at joint angles q and velocities dq (12,); return torque."""
        law = self.law
        target = law.offset - law.kp * q - law.kd * dq
        least, most = self.limits(dq)
        target = np.minimum(np.maximum(target, least), most)
        self.believed = self.believed + self._share * (target - self.believed)
        # A motor that errs upwards still makes no more than it can.
        self.torque = np.minimum(np.maximum(self._scale * self.believed, least), most)
        return self.torque
