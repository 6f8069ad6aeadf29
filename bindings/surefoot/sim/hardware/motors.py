"""Twelve motors with their own drivers: the SDK's law, the torque-speed curve, a lag."""

from __future__ import annotations

import math

import numpy as np

from surefoot import _plant
from surefoot._core import RobotConfig
from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import MOTOR_COUNT
from surefoot.sim.flaws import Flaws

SERVO_MODE = 0x0A
DAMPING_MODE = 0x00
BRAKE_KD = 3.0  # [N.m.s/rad] of a motor that is not in servo mode

MotorLaw = _plant.MotorLaw


def command_law(command: _plant.MotorCommands) -> MotorLaw:
    """Return the law tau' = tau + Kp (q - q') + Kd (dq - dq') of a command.

    q = PosStopF (or any angle of 1e9 rad and more) switches the position term off, dq = VelStopF
    the velocity term. A motor in any mode but servo (0x0A) ignores all that and brakes.
    """
    return _plant.command_law(command, BRAKE_KD)


def damping_law() -> MotorLaw:
    """Return the law of motors that brake, as in mode 0x00."""
    mode = np.full(MOTOR_COUNT, DAMPING_MODE, np.uint8)
    return MotorLaw(
        np.zeros(MOTOR_COUNT), np.zeros(MOTOR_COUNT), np.full(MOTOR_COUNT, BRAKE_KD), mode
    )


def hold_law(q: Array, kp: float, kd: float) -> MotorLaw:
    """Return the law of a robot held in position mode at joint angles q (12,) [rad]."""
    return MotorLaw(kp * q, np.full(MOTOR_COUNT, kp), np.full(MOTOR_COUNT, kd))


class Motors(_plant.Motors):
    """Turns the law in force into joint torques, one physics step at a time.

    Args:
        config: Limits: tau_max up to corner_speed, none at no_load_speed.
        dt: Physics step [s].
        lag: Time constant of the torque [s]; 0 is none.
        scale_rng: Draws each motor's lasting torque error; None for perfect motors.
        flaws: Greatest fraction of that error, and a factor on all torques.
    """

    def __init__(
        self,
        config: RobotConfig,
        dt: float,
        lag: float,
        scale_rng: np.random.Generator | None,
        flaws: Flaws | None = None,
    ) -> None:
        # A first-order lag, exact for a target that holds for one step.
        lag_blend = 1.0 if lag <= 0.0 else -math.expm1(-dt / lag)
        scale = np.ones(MOTOR_COUNT)
        if scale_rng is not None:
            flaws = flaws or Flaws()
            error = flaws.torque_error
            scale = flaws.torque_scale * scale_rng.uniform(1 - error, 1 + error, MOTOR_COUNT)
        super().__init__(
            np.array(config.tau_max),
            np.array(config.corner_speed),
            np.array(config.no_load_speed),
            lag_blend,
            scale,
        )
