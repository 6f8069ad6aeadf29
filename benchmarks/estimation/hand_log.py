"""Logs of a robot whose IMU is moved by a hand, with still legs that touch nothing."""

from __future__ import annotations

import mujoco
import numpy as np
from surefoot import Robot
from surefoot.sim import Plant
from surefoot.sim.hardware.imu import ACCELEROMETER_NOISE, GYRO_NOISE

from estimation.hand_motion import GRAVITY, Hand, Motion, move
from estimation.log_rows import Array, Log

SAMPLE_STEPS = 4  # steps of a motion per row: 250 Hz
DURATION = 60.0  # [s]
GYRO_BIAS, ACCELEROMETER_BIAS = 0.01, 0.05  # [rad/s], [m/s^2] bounds of the uniform draws
MATRIX_ERROR = 0.003  # standard deviation of the scale and axis errors of both sensors
# Quantisation of 16 bits with ranges of 2000 deg/s and 16 g.
GYRO_STEP, ACCELEROMETER_STEP = np.radians(2000.0) / 2**15, 16.0 * GRAVITY / 2**15
TORQUE_NOISE = 0.05  # [N.m] standard deviation

HANDS: dict[str, Hand] = {
    "rotation, slow": Hand(rotation=1.0),
    "rotation, fast": Hand(rotation=5.0),
    "translation, slow": Hand(translation=0.7),
    "translation, fast": Hand(translation=2.0),
    "both, medium, pauses": Hand(rotation=2.5, translation=1.0, pauses=True),
    "both, fast": Hand(rotation=5.0, translation=2.0),
    "both, fast, pauses": Hand(rotation=5.0, translation=2.0, pauses=True),
    "taps": Hand(rotation=1.0, translation=0.7, pauses=True, taps=True),
    "vibration": Hand(rotation=2.5, translation=1.0, pauses=True, vibration=3.0),
    "carried at 1 m/s": Hand(rotation=1.0, translation=0.7, pauses=True, speed=1.0),
}


def hand_log(robot: Robot, hand: Hand, seed: list[int]) -> Log:
    """Return a log without torques and foot forces, and with zero quaternions.

    The entry "tau_hanging" (n, 12) has the torques that hold the legs in the air, with noise.
    """
    rng = np.random.default_rng(seed)
    motion = move(hand, DURATION, rng)
    rows = slice(None, None, SAMPLE_STEPS)
    gyroscope, accelerometer, biases = _imu(motion, rng)
    n = len(gyroscope[rows])
    torques = _hanging_torques(robot, motion, rows)
    return {
        "tick": (np.arange(n) * SAMPLE_STEPS).astype(np.uint32),
        "gyroscope": gyroscope[rows],
        "accelerometer": accelerometer[rows],
        "quaternion": np.zeros((n, 4)),
        "q": np.tile(robot.config.q_standing, (n, 1)),
        "dq": np.zeros((n, 12)),
        "tauEst": np.zeros((n, 12)),
        "tau_hanging": torques + TORQUE_NOISE * rng.standard_normal(torques.shape),
        "footForce": np.zeros((n, 4), np.int16),
        "footForceEst": np.zeros((n, 4), np.int16),
        "truth_rotation": motion.rotation[rows],
        "truth_v": motion.velocity[rows],
        "truth_gyro_bias": biases[0],
    }


def _imu(motion: Motion, rng: np.random.Generator) -> tuple[Array, Array, Array]:
    """Return gyroscope (n, 3), accelerometer (n, 3), and the biases (2, 3) of both."""
    n = len(motion.rate)
    up = motion.acceleration + np.array([0.0, 0.0, GRAVITY])
    force = np.einsum("nij,ni->nj", motion.rotation, up)
    biases = rng.uniform(-1.0, 1.0, (2, 3)) * [[GYRO_BIAS], [ACCELEROMETER_BIAS]]
    sensors = []
    for value, bias, noise, step in (
        (motion.rate, biases[0], GYRO_NOISE, GYRO_STEP),
        (force, biases[1], ACCELEROMETER_NOISE, ACCELEROMETER_STEP),
    ):
        matrix = np.eye(3) + MATRIX_ERROR * rng.standard_normal((3, 3))
        measured = value @ matrix.T + bias + noise * rng.standard_normal((n, 3))
        sensors.append(step * np.round(measured / step))
    return sensors[0], sensors[1], biases


def _hanging_torques(robot: Robot, motion: Motion, rows: slice) -> Array:
    """Return the motor torques (n, 12) [N.m] that hold the legs still, by inverse dynamics."""
    plant = Plant(robot.name)
    model, data, handles = plant.model, plant.data, plant.handles
    arm = np.asarray(robot.config.p_base_imu)
    w, alpha, R = motion.rate[rows], motion.angular_acceleration[rows], motion.rotation[rows]
    lever = np.cross(alpha, arm) + np.cross(w, np.cross(w, arm))
    acceleration = motion.acceleration[rows] - np.einsum("nij,nj->ni", R, lever)
    torques = np.zeros((len(w), 12))
    for k in range(len(w)):
        data.qpos[:3] = [0.0, 0.0, 10.0]
        mujoco.mju_mat2Quat(data.qpos[3:7], R[k].ravel())
        data.qpos[handles.motor_q] = robot.config.q_standing
        data.qvel[:], data.qacc[:] = 0.0, 0.0
        data.qvel[3:6], data.qacc[:3], data.qacc[3:6] = w[k], acceleration[k], alpha[k]
        mujoco.mj_inverse(model, data)
        torques[k] = data.qfrc_inverse[handles.motor_v]
    return torques
