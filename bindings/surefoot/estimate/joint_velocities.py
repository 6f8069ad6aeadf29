"""Joint velocities from joint angles, by a causal filter that could run in real time."""

from __future__ import annotations

import math

import numpy as np

from surefoot.geometry.batch_rotations import Array

# [Hz] Cut-off of the low-pass. Chosen: it delays dq by 3 ms, and encoder steps of 3e-5 rad at
# 500 Hz give a noise of 0.004 rad/s.
CUTOFF_HZ = 50.0
# [s] Time after which a joint with a repeated angle counts as still. Chosen: five samples at
# 500 Hz. With a larger value, the velocity of a stopped joint stays above zero for longer.
HOLD_TIME = 0.010
METHOD = (
    f"from q: differences between samples, causal first-order low-pass at {CUTOFF_HZ:g} Hz; a "
    f"repeated angle is an old sample for {1000 * HOLD_TIME:g} ms, then a joint at rest"
)


def derive_velocities(time: Array, q: Array) -> Array:
    """Compute dq (n, 12) [rad/s] from angles q (n, 12) [rad] at times (n,) [s].

    The filter is causal: row k depends on rows 0 .. k only, as on a robot. dt is the time since
    the last new angle of a joint. A first-order low-pass at 50 Hz filters difference / dt:
    dq += (1 - exp(-2 pi 50 Hz dt)) (difference / dt - dq).

    A log that is faster than the encoders repeats angles. While an angle repeats, dq is held for
    10 ms and then decays. A row with a non-finite time or angle keeps the last velocity.
    """
    dq = np.zeros_like(q)
    velocity = [0.0] * q.shape[1]
    last_angle: list[float] = [math.nan] * q.shape[1]
    last_time = [0.0] * q.shape[1]
    rate = -2.0 * math.pi * CUTOFF_HZ
    for k, (t, row) in enumerate(zip(time.tolist(), q.tolist(), strict=True)):
        if t == t:  # false for NaN; read_clock() leaves no infinity
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
