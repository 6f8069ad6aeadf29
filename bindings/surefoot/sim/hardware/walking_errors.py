"""Sensor errors that walking adds: vibration after impacts, ranges, repeated values, late counts.

"Go1 log" below is a public log of a trotting Go1 at 400 Hz: evaluation/unit_tests/data/go1.csv of
github.com/mrsp/serow.
"""

from __future__ import annotations

import math

import numpy as np

from surefoot import _plant
from surefoot._core import Robot
from surefoot.sim.settings import PlantSettings

# [Hz] Range of the uniform draw of the natural frequency of each axis. Chosen: in the Go1 log,
# gyroscope and accelerometer swing with periods of 2 to 6 samples after a touchdown. If lower, the
# second differences that estimate white noise contain less of the vibration.
VIBRATION_FREQUENCY = (80.0, 150.0)
# Damping ratio. Chosen: an amplitude halves in 8 to 15 ms. In the Go1 log, most of a vibration is
# over 30 ms after the touchdown.
VIBRATION_DAMPING = 0.09
# [rad/s] Mean change of a gyroscope axis if the normal force of one foot jumps by a quarter of the
# weight. Calibrated: in a trot at 0.5 m/s on soft soles, second differences of the gyroscope give
# 0.08 to 0.11 rad/s, depending on the seed; those of the Go1 log give 0.11 rad/s.
GYRO_VIBRATION = 0.8
# [m/s^2] The same for an accelerometer axis. Calibrated: peaks of 10 to 20 m/s^2 at touchdown, as
# in the Go1 log.
ACCELEROMETER_VIBRATION = 20.0
# Factor on both with rigid soles, whose forces jump at touchdown. Calibrated: with this factor, the
# trot at 0.5 m/s has the same vibration as on soft soles.
RIGID_SOLE_FACTOR = 0.2
# Range of the uniform draw of the coupling of a foot and an axis, as a multiple of its mean; the
# sign is drawn too. Assumed: the shapes of the trunk's modes are unknown.
VIBRATION_COUPLING = (0.5, 1.5)
# Assumed, because the vendor names no IMU: common ranges of MEMS IMUs. If smaller: touchdowns clip.
GYRO_RANGE = math.radians(2000.0)  # [rad/s]
ACCELEROMETER_RANGE = 8.0 * 9.81  # [m/s^2]
# [s] Time between new values of the accelerometer. In the Go1 log every second LowState at 400 Hz
# repeats the value of the one before: the sensor has a rate of its own, near 200 Hz. Chosen:
# 250 Hz, so that this is so at 500 Hz too.
ACCELEROMETER_PERIOD = 0.004
# [s] Time constant with which the measured foot force follows a falling force. In the Go1 log,
# counts fall from 100 or 200 to 10 within 15 to 20 ms after the calf has begun to lift the foot.
FORCE_FALL_TIME = 0.008
# [counts/N] Range of the uniform draw of the gain of footForce. In the Go1 log, the counts of both
# stance feet are 6 to 10 times the load [N] that the accelerometer gives.
COUNT_GAIN = (6.0, 10.0)


def draw_vibration(
    robot: Robot, settings: PlantSettings, rng: np.random.Generator
) -> _plant.Vibration:
    """Draw the vibration of one robot.

    Args:
        robot: The robot, for its weight.
        settings: Kind of soles, physics step.
        rng: Source of frequencies and couplings.
    """
    frequency = 2.0 * math.pi * rng.uniform(*VIBRATION_FREQUENCY, 6)
    coupling = rng.uniform(*VIBRATION_COUPLING, (6, 4)) * rng.choice([-1.0, 1.0], (6, 4))
    coupling[:3] *= GYRO_VIBRATION
    coupling[3:] *= ACCELEROMETER_VIBRATION
    coupling *= 1.0 if settings.soft_soles else RIGID_SOLE_FACTOR
    coupling /= robot.mass * 9.81 / 4.0
    return _plant.Vibration(frequency, VIBRATION_DAMPING, coupling, settings.physics_dt)


def accelerometer_readings(control_rate: float) -> int:
    """Return the number of LowStates for each new accelerometer value."""
    return max(1, round(ACCELEROMETER_PERIOD * control_rate))


def force_fall_blend(dt: float) -> float:
    """Return the share by which the measured force approaches a smaller one in a step of dt [s]."""
    return -math.expm1(-dt / FORCE_FALL_TIME)
