"""What the body is asked to do while the peers are compared."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from surefoot._core import Reference
from surefoot.bench.recording import Recording

BOW_SIDE, BOW_DOWN, BOW_ROLL = 0.01, 0.02, 0.05  # [m], [m], [rad]


def quiet_ticks(recording: Recording) -> int:
    """Return for how many ticks the robot stands still: half of those before the push."""
    return max(1, int(0.5 * recording.push.time / recording.period))


def body_motion(hold: Reference, ticks: int, quiet: int) -> NDArray[np.float64]:
    """Return the targets: a bow to the right and back, between standing still and the push.

    The states do not follow, for they are recorded: what varies is what is asked of the forces.

    Args:
        hold: Where the motion starts and ends.
        ticks: Of the recording.
        quiet: Of standing still; the bow lasts as long.

    Returns:
        Centre of mass [m] and base orientation (quaternion x y z w), shape (ticks, 7).
    """
    targets = np.tile(np.concatenate([hold.p_com, hold.quat_world_base]), (ticks, 1))
    n = min(quiet, ticks - quiet)
    share = 0.5 - 0.5 * np.cos(2.0 * np.pi * np.arange(n) / n)
    bow = targets[quiet : quiet + n]
    bow[:, 1] -= BOW_SIDE * share
    bow[:, 2] -= BOW_DOWN * share
    x, y, z, w = hold.quat_world_base
    sine, cosine = np.sin(0.5 * BOW_ROLL * share), np.cos(0.5 * BOW_ROLL * share)
    # The base's orientation times a turn about its own x axis.
    turned = [x * cosine + w * sine, y * cosine + z * sine, z * cosine - y * sine]
    bow[:, 3:] = np.stack([*turned, w * cosine - x * sine], axis=1)
    return targets
