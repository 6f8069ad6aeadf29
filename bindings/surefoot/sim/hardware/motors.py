"""Twelve motors with drivers: the SDK's motor law, the torque-speed curve, a first-order lag."""

from __future__ import annotations

import math

import numpy as np

from surefoot import _plant
from surefoot._core import RobotConfig
from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import MOTOR_COUNT
from surefoot.sim.flaws import Flaws

SERVO_MODE = 0x0A  # as in the SDK's comm.h
DAMPING_MODE = 0x00
# [N.m.s/rad] Damping of a motor that is not in servo mode. The vendor publishes no value. This is
# Kd of unitree_guide's passive state, and the default of Gains.damping_kd.
BRAKE_KD = 3.0

MotorLaw = _plant.MotorLaw


def command_law(command: _plant.MotorCommands) -> MotorLaw:
    """Return the motor law of a command: tau' = tau + Kp (q - q') + Kd (dq - dq').

    q, dq, tau, Kp and Kd are the command; q' and dq' are the state of the joint. q = PosStopF, or
    any q of magnitude 1e9 rad or more, switches the position term off. dq = VelStopF switches the
    velocity term off. A motor that is not in servo mode (0x0A) ignores the command and brakes.
    """
    return _plant.command_law(command, BRAKE_KD)


def damping_law() -> MotorLaw:
    """Return the law of braking motors, as in mode 0x00."""
    mode = np.full(MOTOR_COUNT, DAMPING_MODE, np.uint8)
    return MotorLaw(
        np.zeros(MOTOR_COUNT), np.zeros(MOTOR_COUNT), np.full(MOTOR_COUNT, BRAKE_KD), mode
    )


def hold_law(q: Array, kp: float, kd: float) -> MotorLaw:
    """Return the position-mode law that holds joint angles q (12,) [rad].

    Args:
        q: Joint angles (12,) [rad], SDK order.
        kp: Stiffness [N.m/rad].
        kd: Damping [N.m.s/rad].
    """
    return MotorLaw(kp * q, np.full(MOTOR_COUNT, kp), np.full(MOTOR_COUNT, kd))


class Motors(_plant.Motors):
    """Computes joint torques from the present motor law, one physics step at a time.

    Args:
        config: Torque limits: tau_max up to corner_speed, zero at no_load_speed.
        dt: Physics step [s].
        lag: Time constant of the torque [s]; 0: none.
        scale_rng: Source of each motor's constant torque error; None: perfect motors.
        flaws: Flaws with torque_error and torque_scale; None: the defaults.
    """

    def __init__(
        self,
        config: RobotConfig,
        dt: float,
        lag: float,
        scale_rng: np.random.Generator | None,
        flaws: Flaws | None = None,
    ) -> None:
        # Exact discretisation of a first-order lag whose input is constant during a step.
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
