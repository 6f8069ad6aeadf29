"""Motions of an IMU in a hand: rotations, translations, pauses, taps and vibration."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from surefoot.geometry.batch_rotations import matrices_from_rotation_vectors, products

from estimation.log_rows import Array

GRAVITY = 9.81  # [m/s^2]
RATE = 1000.0  # [Hz] rate at which a motion is integrated
REST_TIME = 3.0  # [s] rest before each motion
RAMP_TIME = 0.3  # [s] in which a motion begins and ends
ROTATION_BAND = (0.1, 1.0)  # [Hz]
TRANSLATION_BAND = (0.2, 1.5)  # [Hz] of the velocity, whose mean is zero
WRIST = 0.1  # [m] from the centre about which the hand turns the IMU
TAP_INTERVAL = (0.3, 1.2)  # [s] between taps
TAP_FREQUENCY, TAP_DECAY, RECOIL_DECAY = 50.0, 0.01, 0.1  # [Hz], [s], [s]
TAP_FORCE, TAP_RATE = 60.0, 3.0  # [m/s^2], [rad/s] amplitudes of a tap
VIBRATION_BAND = (40.0, 100.0)  # [Hz]


@dataclass(frozen=True)
class Hand:
    """One kind of hand motion.

    Attributes:
        rotation: Angular rate that 99 % of the samples stay below [rad/s].
        translation: Acceleration of the hand that 99 % of the samples stay below [m/s^2].
        pauses: Whether the hand rests for 2 to 4 s after every 4 to 8 s.
        taps: Whether a finger taps the IMU.
        vibration: RMS acceleration of a vibration [m/s^2]; its angular rate [rad/s] is 3 % of it.
        speed: Speed at which the hand carries the IMU away [m/s].
    """

    rotation: float = 0.0
    translation: float = 0.0
    pauses: bool = False
    taps: bool = False
    vibration: float = 0.0
    speed: float = 0.0


@dataclass(frozen=True)
class Motion:
    """A motion of the IMU, sampled at RATE.

    Attributes:
        rotation: (n, 3, 3) IMU axes to world axes.
        rate: (n, 3) angular rate, IMU axes [rad/s].
        angular_acceleration: (n, 3) IMU axes [rad/s^2].
        velocity: (n, 3) of the IMU, world axes [m/s].
        acceleration: (n, 3) of the IMU without gravity, world axes [m/s^2].
    """

    rotation: Array
    rate: Array
    angular_acceleration: Array
    velocity: Array
    acceleration: Array


def move(hand: Hand, duration: float, rng: np.random.Generator) -> Motion:
    """Return a random motion of the kind, from rest in a random attitude below 30 deg of tilt."""
    n = round(duration * RATE)
    envelope = _envelope(hand, n, rng)
    rate = _scaled(hand.rotation, envelope * _noise(n, ROTATION_BAND, rng))
    velocity = envelope * _noise(n, TRANSLATION_BAND, rng)
    velocity = velocity * _factor(hand.translation, _derivative(velocity))
    velocity[:, 0] += hand.speed * envelope[:, 0]
    shake = hand.vibration * envelope * _noise(n, VIBRATION_BAND, rng)
    acceleration = _derivative(velocity) + shake
    rate = rate + 0.03 * hand.vibration * envelope * _noise(n, VIBRATION_BAND, rng)
    if hand.taps:
        force, turn = _taps(envelope, rng)
        acceleration, rate = acceleration + force, rate + turn
        velocity = velocity + np.cumsum(force, axis=0) / RATE
    rotation = _start(rng) @ _integrated(rate)
    angular_acceleration = _derivative(rate)
    arm = np.array([WRIST, 0.0, 0.0])
    swing = np.cross(rate, arm)
    centripetal = np.cross(angular_acceleration, arm) + np.cross(rate, swing)
    acceleration = acceleration + np.einsum("nij,nj->ni", rotation, centripetal)
    velocity = velocity + np.einsum("nij,nj->ni", rotation, swing)
    return Motion(rotation, rate, angular_acceleration, velocity, acceleration)


def _envelope(hand: Hand, n: int, rng: np.random.Generator) -> Array:
    """Return the share (n, 1), 0 .. 1, of the motion that takes place."""
    moves = np.ones(n)
    moves[: round(REST_TIME * RATE)] = 0.0
    end = REST_TIME
    while hand.pauses and end < n / RATE:
        start = end + rng.uniform(4.0, 8.0)
        end = start + rng.uniform(2.0, 4.0)
        moves[round(start * RATE) : round(end * RATE)] = 0.0
    window = np.hanning(round(RAMP_TIME * RATE) + 2)[1:-1]
    return np.convolve(moves, window / window.sum(), mode="same")[:, None]


def _noise(n: int, band: tuple[float, float], rng: np.random.Generator) -> Array:
    """Return noise (n, 3) of a band of frequencies [Hz], with an RMS of 1."""
    spectrum = np.fft.rfft(rng.standard_normal((n, 3)), axis=0)
    frequency = np.fft.rfftfreq(n, 1.0 / RATE)
    spectrum[(frequency < band[0]) | (frequency > band[1])] = 0.0
    values = np.fft.irfft(spectrum, n, axis=0)
    return np.asarray(values / np.sqrt(np.mean(values**2)))


def _factor(size: float, values: Array) -> float:
    largest = float(np.percentile(np.linalg.norm(values, axis=1), 99.0))
    return size / max(largest, 1e-9)


def _scaled(size: float, values: Array) -> Array:
    return values * _factor(size, values)


def _derivative(values: Array) -> Array:
    return np.asarray(np.gradient(values, 1.0 / RATE, axis=0))


def _taps(envelope: Array, rng: np.random.Generator) -> tuple[Array, Array]:
    """Return accelerations and rates (n, 3) of taps; the hand takes back their velocity."""
    n = len(envelope)
    time = np.arange(round(0.6 * RATE)) / RATE
    blow = np.exp(-time / TAP_DECAY) * np.sin(2.0 * np.pi * TAP_FREQUENCY * time)
    recoil = np.exp(-time / RECOIL_DECAY)
    pulse = blow - recoil * blow.sum() / recoil.sum()
    force, turn = np.zeros((n, 3)), np.zeros((n, 3))
    start = REST_TIME
    while (k := round((start := start + rng.uniform(*TAP_INTERVAL)) * RATE)) < n - len(time):
        rows, strength = slice(k, k + len(time)), envelope[k] * rng.uniform(0.3, 1.0)
        force[rows] += np.outer(pulse, strength * TAP_FORCE * _direction(rng))
        turn[rows] += np.outer(pulse, strength * TAP_RATE * _direction(rng))
    return force, turn


def _direction(rng: np.random.Generator) -> Array:
    vector = rng.standard_normal(3)
    return np.asarray(vector / np.linalg.norm(vector))


def _start(rng: np.random.Generator) -> Array:
    vector = np.radians(rng.uniform(0.0, 30.0)) * _direction(rng)
    return np.asarray(matrices_from_rotation_vectors(vector[None])[0])


def _integrated(rate: Array) -> Array:
    """Return the rotations (n, 3, 3) since the first sample."""
    steps = 0.5 * (rate + np.roll(rate, 1, axis=0)) / RATE
    steps[0] = 0.0
    return products(matrices_from_rotation_vectors(steps))
