"""Statistics of two implementations that computed the same ticks."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from surefoot.bench.peers.surefoot_implementations import CPU, FORCES, SOLVED, TORQUES, WALL, Ticks
from surefoot.bench.timing_statistics import distribution

# Largest differences between our answer and that of a peer, before the first push, for which both
# count as the same answer. Chosen: the peers weight the contact forces differently, which causes
# smaller differences than these (docs/benchmarks/peers.md).
FORCE_TOLERANCE = 0.03  # of a foot force, as a share of the robot's weight
TORQUE_TOLERANCE = 0.05  # of a joint torque, as a share of our largest joint torque
SAME_ANSWER = "same answer"


def median_time_ratio(our_ticks: Ticks, peer_ticks: Ticks, clock: int = WALL) -> float:
    """Return the median over ticks k of our_ticks[k] / peer_ticks[k]."""
    return round(float(np.median(our_ticks[:, clock] / np.maximum(peer_ticks[:, clock], 1.0))), 4)


def tick_statistics(ticks: Ticks) -> dict[str, Any]:
    """Return the distributions of the tick times and the number of unsolved ticks."""
    return {
        "wall_us": distribution(ticks[:, WALL] / 1000.0),
        "cpu_us": distribution(ticks[:, CPU] / 1000.0),
        "failures": int(np.count_nonzero(ticks[:, SOLVED] == 0.0)),
    }


def compare_answers(
    our_ticks: Ticks, peer_ticks: Ticks, weight: float, calm: NDArray[np.bool_]
) -> dict[str, Any]:
    """Compare foot forces and joint torques.

    Args:
        our_ticks: Our ticks from state to torque.
        peer_ticks: The same ticks of the peer.
        weight: Weight of the robot [N].
        calm: (n,) true for the ticks before the first push.

    Returns:
        The largest differences; "ticks_apart", the number of ticks in which a torque differs by
        more than TORQUE_TOLERANCE; and "verdict", which is SAME_ANSWER if the answers agree before
        the first push, and otherwise states the difference.
    """
    force = _max_force_difference(our_ticks, peer_ticks)
    calm_force = float(force[calm].max())
    torque = np.abs(our_ticks[:, TORQUES:] - peer_ticks[:, TORQUES:]).max(axis=1)
    greatest = float(np.abs(our_ticks[calm, TORQUES:]).max())
    calm_torque = float(torque[calm].max())
    verdict = SAME_ANSWER
    if calm_force > FORCE_TOLERANCE * weight:
        verdict = f"another answer: a foot force differs by up to {calm_force:.3g} N"
    elif calm_torque > TORQUE_TOLERANCE * greatest:
        verdict = (
            f"another answer: torques differ by up to {calm_torque:.3g} N.m of {greatest:.3g} N.m"
        )
    return {
        "verdict": verdict,
        "weight_n": round(weight, 3),
        "greatest_force_difference_n": _difference_summary(force, calm),
        "greatest_torque_difference_nm": _difference_summary(torque, calm),
        "ticks_apart": int(np.count_nonzero(torque > TORQUE_TOLERANCE * greatest)),
        "greatest_calm_torque_nm": round(greatest, 6),
    }


def _max_force_difference(our_ticks: Ticks, peer_ticks: Ticks) -> NDArray[np.float64]:
    """Return the largest difference of a foot force for each tick [N]."""
    difference = (peer_ticks - our_ticks)[:, FORCES:TORQUES].reshape(len(our_ticks), 4, 3)
    largest: NDArray[np.float64] = np.linalg.norm(difference, axis=2).max(axis=1)
    return largest


def _difference_summary(
    difference: NDArray[np.float64], calm: NDArray[np.bool_]
) -> dict[str, float]:
    return {
        "calm": round(float(difference[calm].max()), 6),
        "all": round(float(difference.max()), 6),
        "p90": round(float(np.percentile(difference, 90.0)), 6),
    }
