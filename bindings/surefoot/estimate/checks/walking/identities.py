"""Identities that correct sensors of a walking robot fulfil, as linear equations of their faults.

Feet: the distance of two stance feet is constant, d(p_i - p_j) + theta x (p_i - p_j) = 0, with the
paths p of the feet relative to the base and the rotation theta of the gyroscope.

Force: a stance foot stays in place, so the second difference of its path is minus the second
integral of the accelerometer.

Only horizontal components are used, because soles and ground yield vertically.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot.estimate.checks.walking.imu_path import ImuPath
from surefoot.estimate.checks.walking.leg_paths import STEP, LegPaths
from surefoot.estimate.checks.walking.stances import Stances, phases
from surefoot.geometry.batch_rotations import Array

Order = tuple[int, int, int, int]
"""Leg of the log at each place FR FL RR RL."""
LOGGED: Order = (0, 1, 2, 3)
# [s] Duration of a difference. Chosen: two fit into the middle part of a short stance (0.1 s).
FEET_SPAN, FORCE_SPAN = 0.04, 0.03
PAIRS = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))
# Slices of the parameters in the coefficients.
GAIN, GYRO_BIAS, ACC_BIAS, CALF = slice(0, 3), slice(3, 6), slice(6, 9), slice(9, 13)
ALL_CALVES = 13
PARAMETERS = 14


@dataclass(frozen=True)
class Equations:
    """Linear equations y + C x = 0 of one identity.

    The parameters x are the errors of the gyroscope's gains (3), its bias (3) [rad/s], the bias of
    the accelerometer (3) [m/s^2], all in base axes, the corrections of the calf angles (4) [rad],
    and a common correction of all calves (1) [rad]: yielding soles and a wrong radius of the feet
    change the length of all legs.

    Attributes:
        y: (m, d) residuals of healthy sensors [m or m/s^2].
        C: (m, d, PARAMETERS) coefficients.
        count: Number of independent stances or turns.
    """

    y: Array
    C: Array
    count: int


def feet_equations(
    paths: LegPaths,
    stances: Stances,
    imu: ImuPath,
    order: Order = LOGGED,
    coefficients: bool = True,
) -> Equations:
    """Return the equations of the pairs of stance feet; C is empty without `coefficients`."""
    span = round(FEET_SPAN / STEP)
    path, arm, middle = _at_places(paths, stances, order)
    stays = _stays(middle, span)
    ys, Cs, count = [np.zeros((0, 2))], [np.zeros((0, 2, PARAMETERS))], 0
    for i, j in PAIRS:
        both = stays[:, i] & stays[:, j]
        count += len(phases(both))
        first = np.flatnonzero(both)
        last = first + span
        theta = imu.rotation[last] - imu.rotation[first]
        moved = path[last, i] - path[first, i] - path[last, j] + path[first, j]
        distance = 0.5 * (arm[last, i] + arm[first, i] - arm[last, j] - arm[first, j])
        ys.append((moved + _cross(theta, distance))[:, :2])
        if coefficients:
            C = np.zeros((len(first), 3, PARAMETERS))
            turn = turn_columns(distance)
            C[:, :, GAIN] = turn * theta[:, None]
            C[:, :, GYRO_BIAS] = -FEET_SPAN * turn
            for sign, leg in ((1.0, order[i]), (-1.0, order[j])):
                start, end = paths.calf[first, leg], paths.calf[last, leg]
                C[:, :, CALF.start + leg] = sign * (end - start + _cross(theta, start))
            C[:, :, ALL_CALVES] = C[:, :, CALF].sum(axis=2)
            Cs.append(C[:, :2])
    return Equations(np.concatenate(ys), np.concatenate(Cs), count)


def force_equations(
    paths: LegPaths,
    stances: Stances,
    imu: ImuPath,
    order: Order = LOGGED,
    coefficients: bool = True,
) -> Equations:
    """Return the equations of single stance feet; C is empty without `coefficients`."""
    span = round(FORCE_SPAN / STEP)
    path, arm, middle = _at_places(paths, stances, order)
    stays = _stays(middle, 2 * span)
    ys, Cs, count = [np.zeros((0, 2))], [np.zeros((0, 2, PARAMETERS))], 0
    for place in range(4):
        count += len(phases(stays[:, place]))
        first = np.flatnonzero(stays[:, place])
        now, last = first + span, first + 2 * span
        ahead = imu.rotation[last] - imu.rotation[now]
        behind = imu.rotation[now] - imu.rotation[first]
        foot, reach = path[:, place], arm[:, place]
        moved = foot[last] - 2.0 * foot[now] + foot[first]
        carried = imu.position[last] - 2.0 * imu.position[now] + imu.position[first]
        turned = _cross(ahead, reach[last]) - _cross(behind, reach[first])
        ys.append((moved + carried + turned)[:, :2] / FORCE_SPAN**2)
        if coefficients:
            calf = paths.calf[:, order[place]]
            C = np.zeros((len(first), 3, PARAMETERS))
            C[:, :, GAIN] = turn_columns(reach[last]) * ahead[:, None]
            C[:, :, GAIN] -= turn_columns(reach[first]) * behind[:, None]
            bent = calf[last] - 2.0 * calf[now] + calf[first]
            bent += _cross(ahead, calf[last]) - _cross(behind, calf[first])
            C[:, :, CALF.start + order[place]] = C[:, :, ALL_CALVES] = bent
            Cs.append(C[:, :2] / FORCE_SPAN**2)
    return Equations(np.concatenate(ys), np.concatenate(Cs), count)


def turn_columns(arm: Array) -> Array:
    """Return the matrices (..., 3, 3) whose column k is axis k x arm, for arms (..., 3)."""
    x, y, z = np.moveaxis(arm, -1, 0)
    o = np.zeros_like(x)
    return np.stack(
        [np.stack([o, z, -y], -1), np.stack([-z, o, x], -1), np.stack([y, -x, o], -1)], axis=-2
    )


def _cross(a: Array, b: Array) -> Array:
    """Return the cross products (m, 3) of rows; faster than np.cross."""
    ax, ay, az = a.T
    bx, by, bz = b.T
    return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], axis=1)


def _at_places(
    paths: LegPaths, stances: Stances, order: Order
) -> tuple[Array, Array, npt.NDArray[np.bool_]]:
    place = np.arange(4)
    return paths.path[:, place, order], paths.arm[:, place, order], stances.middle[:, order]


def _stays(middle: npt.NDArray[np.bool_], span: int) -> npt.NDArray[np.bool_]:
    """Return whether a foot is in stance from a row to the row `span` later (n - span, 4)."""
    total = np.concatenate([np.zeros((1, 4), int), np.cumsum(middle, axis=0)])
    return np.asarray(total[span + 1 :] - total[: -span - 1] == span + 1)
