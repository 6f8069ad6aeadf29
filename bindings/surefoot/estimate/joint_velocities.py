"""Joint velocities from joint angles, as a real-time program could have made them."""

from __future__ import annotations

import math

import numpy as np

from surefoot.geometry.batch_rotations import Array

CUTOFF_HZ = 50.0  # [Hz] delays by 3 ms; an encoder's steps of 3e-5 rad at 500 Hz leave 0.004 rad/s
HOLD_TIME = 0.010  # [s] an angle that repeats for longer stands still
METHOD = (
    f"from q: differences between samples, causal first-order low-pass at {CUTOFF_HZ:g} Hz; an angle "
    f"that repeats is an old sample for {1000 * HOLD_TIME:g} ms, then a joint that stands still"
)


def derive_velocities(time: Array, q: Array) -> Array:
    """Return dq (n, 12) [rad/s] for angles q (n, 12) [rad] at times (n,) [s].

    Causal: row k depends on rows up to k alone, as in a robot. Each joint's angle is differenced
    over the time since its last new sample, however long that is, and low-passed by a first-order
    filter with its cut-off at 50 Hz whose share is 1 - exp(-2 pi 50 Hz x that time). Logs faster
    than the encoders repeat samples: for up to 10 ms the velocity holds, after that it falls.
    Rows whose time or angle is not finite keep the velocity that was.
    """
    dq = np.zeros_like(q)
    velocity = [0.0] * q.shape[1]
    last_angle: list[float] = [math.nan] * q.shape[1]
    last_time = [0.0] * q.shape[1]
    rate = -2.0 * math.pi * CUTOFF_HZ
    for k, (t, row) in enumerate(zip(time.tolist(), q.tolist(), strict=True)):
        if t == t:  # neither NaN nor, by read_clock(), infinite
            for i, angle in enumerate(row):
                step = t - last_time[i]
                if last_angle[i] != last_angle[i]:
                    if math.isfinite(angle):
                        last_angle[i], last_time[i] = angle, t
                elif (
                    step > 0.0
                    and math.isfinite(angle)
                    and (angle != last_angle[i] or step >= HOLD_TIME)
                ):
                    slope = (angle - last_angle[i]) / step
                    velocity[i] -= math.expm1(rate * step) * (slope - velocity[i])
                    last_angle[i], last_time[i] = angle, t
        dq[k] = velocity
    return dq
