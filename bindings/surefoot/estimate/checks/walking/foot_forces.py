"""Checks of the foot forces of a walking robot: their order, and values that stop changing."""

from __future__ import annotations

import itertools

import numpy as np
import numpy.typing as npt
from numpy.lib.stride_tricks import sliding_window_view

from surefoot.estimate.checks.walking.identities import LOGGED, Order
from surefoot.estimate.checks.walking.leg_paths import STEP, LegPaths
from surefoot.estimate.checks.walking.samples import finite_samples, interpolated
from surefoot.estimate.checks.walking.stances import Stances, phases
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.column_definitions import FOOT_COLUMNS
from surefoot.sensor_log.sensor_log import SensorLog

# Sum over the feet of the change of log(1 - r^2), with the correlation r of foot force and load,
# below which another order is right. Chosen: half a foot whose sensor follows the load in half of
# its variance.
MIN_ORDER_GAIN = 0.3
# Correlation of the stances of two legs, without torques, above which their sensors cannot be told
# apart. Chosen: the legs of a diagonal of a trot have 0.8 and more, other pairs are negative.
ALIKE = 0.5
# Smallest r^2, mean over the feet, of the right order. Chosen: below the 0.2 of a slow walk
# without torques.
MIN_CORRELATION = 0.1
# Duration [strides] and [s] of the windows in which a foot force must change; the longer one
# counts. A dead sensor does not change in all windows of twice this time.
CHANGE_STRIDES, MIN_CHANGE_TIME = 2.0, 1.0
WINDOW_INTERVAL = 0.1  # [s] from one window to the next
# Standard deviation in a window, as a share of the usual one of the foot, below which the sensor
# is dead. Chosen: above the noise, 3 N of 40 N, and below a third of the load.
DEAD_SHARE = 0.15
# Standard deviation as a share of that of the other feet, below which a foot was never alive.
NEVER_SHARE = 0.03


def check_foot_forces(
    log: SensorLog, paths: LegPaths, stances: Stances, order: Order = LOGGED
) -> list[str]:
    """Compare the foot forces with the loads of the legs; return warnings.

    Args:
        log: The log.
        paths: Paths of the feet.
        stances: Stances of the feet.
        order: Leg of the log at each place FR FL RR RL.
    """
    columns = [
        name
        for name in FOOT_COLUMNS
        if name in log.columns and np.isfinite(log.columns[name]).all(axis=1).any()
    ]
    forces = {name: on_grid(log, name, paths.time) for name in columns}
    forces = {name: force for name, force in forces.items() if np.ptp(force) > 0.0}
    if not forces:
        return []
    walks = np.asarray(stances.stepping.all(axis=1), dtype=np.bool_)
    loads, alike = leg_loads(log, paths), np.eye(4, dtype=np.bool_)
    if loads is None:
        loads = stances.low.astype(float)
        if walks.any():
            alike |= np.asarray(np.corrcoef(loads[walks], rowvar=False) > ALIKE)
    loads = (loads * stances.low)[:, order]
    used = ((stances.middle | ~stances.low) & walks[:, None])[:, order]
    doubts = []
    for name, force in forces.items():
        dead = _dead_feet(name, force, walks, paths, stances)
        doubts += dead or _check_order(name, explained_shares(force, loads, used), alike)
    return doubts


def on_grid(log: SensorLog, name: str, time: Array) -> Array:
    """Return a column (n, k) at the times of the grid."""
    known, (values,) = finite_samples(log, name)
    return interpolated(time, known, values)


def leg_loads(log: SensorLog, paths: LegPaths) -> Array | None:
    """Return the vertical force (n, 4) [N] of each leg from its torques; None without torques."""
    if "tauEst" not in log.columns or not np.any(log.columns["tauEst"]):
        return None
    torque = on_grid(log, "tauEst", paths.time).reshape(-1, 4, 3, 1)
    # A stretched leg is singular.
    transposed = np.swapaxes(paths.jacobian, 2, 3) + 1e-6 * np.eye(3)
    force = -np.linalg.solve(transposed, torque)[:, :, 2, 0]
    return np.asarray(np.maximum(force, 0.0))


def explained_shares(force: Array, load: Array, used: npt.NDArray[np.bool_]) -> Array:
    """Return r^2 (4, 4) of each sensor and the load of each leg; 0 for a negative correlation.

    Args:
        force: (n, 4) values of the sensors.
        load: (n, 4) loads of the legs.
        used: (n, 4) rows that are used for each leg.
    """
    shares = np.zeros((4, 4))
    for leg in range(4):
        rows = used[:, leg]
        if np.count_nonzero(rows) < 2 or load[rows, leg].std() == 0.0:
            continue
        for sensor in np.flatnonzero(force[rows].std(axis=0) > 0.0):
            r = np.corrcoef(force[rows, sensor], load[rows, leg])[0, 1]
            shares[sensor, leg] = max(float(r), 0.0) ** 2
    return shares


def _check_order(name: str, shares: Array, alike: npt.NDArray[np.bool_]) -> list[str]:
    """Return a warning if another order of the legs explains the foot forces better.

    Args:
        name: Name of the column.
        shares: (4, 4) result of explained_shares().
        alike: (4, 4) legs that cannot be told apart.
    """
    unexplained = np.log(np.maximum(1.0 - shares, 1e-6))
    sensors = range(4)
    sums = {o: float(unexplained[sensors, o].sum()) for o in itertools.permutations(sensors)}
    best = min(sums, key=lambda order: sums[order])
    right = min(value for order, value in sums.items() if alike[sensors, order].all())
    if sums[best] > right - MIN_ORDER_GAIN or shares[sensors, best].mean() < MIN_CORRELATION:
        return []
    names = " ".join(LEGS[leg] for leg in best)
    return [f"{name} follows the loads of the legs in the order {names}, expected FR FL RR RL"]


def _dead_feet(
    name: str, force: Array, walks: npt.NDArray[np.bool_], paths: LegPaths, stances: Stances
) -> list[str]:
    """Return a warning for each foot whose values do not change although the leg steps."""
    size = round(max(MIN_CHANGE_TIME, CHANGE_STRIDES * stances.stride) / STEP)
    every = round(WINDOW_INTERVAL / STEP)
    first = np.flatnonzero(sliding_window_view(walks, size).all(axis=1))[::every]
    if len(first) == 0:
        return []
    change = np.array([force[k : k + size].std(axis=0) for k in first])
    usual = np.percentile(change, 90.0, axis=0)
    doubts = []
    for leg, foot in enumerate(LEGS):
        never = usual[leg] < NEVER_SHARE * np.median(np.delete(usual, leg))
        still = (change[:, leg] < DEAD_SHARE * usual[leg]) | never
        longest = max(phases(still).tolist(), key=lambda run: run[1] - run[0], default=[0, 0])
        if (longest[1] - longest[0]) * every < size:
            continue
        onset = first[longest[0]]
        value = float(np.median(force[onset : onset + size, leg]))
        doubts.append(
            f"{name} of {foot} stays at {value:.0f} from {paths.time[onset]:.1f} s on, "
            "although the leg steps"
        )
    return doubts
