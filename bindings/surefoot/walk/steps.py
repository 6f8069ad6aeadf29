"""Steps of a walk, from the true loads of the feet."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot.walk.walk_motion import WalkMotion

LOADED = 0.05  # share of the weight above which a foot counts as loaded; of the slip's definition
# [s] A shorter gap in the load is a bounce of the same step: soft soles bounce for up to 40 ms, and
# swings take 150 ms and more.
MIN_SWING = 0.06
TOUCHDOWN_TIME = 0.03  # [s] time after a touchdown in which its largest force counts


@dataclass(frozen=True)
class Stance:
    """One stance phase of a foot.

    Attributes:
        leg: Leg 0 .. 3.
        start: First loaded tick.
        end: Tick after the last loaded one.
        stepped: False if the foot was loaded from the first tick of the log on.
    """

    leg: int
    start: int
    end: int
    stepped: bool


def stance_phases(log: WalkMotion) -> list[Stance]:
    """Return all stance phases, leg by leg. A bounce does not begin a new one."""
    loaded = log.normal_forces > LOADED * log.weight
    gap = round(MIN_SWING * log.rate)
    phases = []
    for leg in range(4):
        edges = np.flatnonzero(np.diff(np.concatenate([[False], loaded[:, leg], [False]])))
        runs = edges.reshape(-1, 2).tolist()
        merged: list[list[int]] = []
        for start, end in runs:
            if merged and start - merged[-1][1] < gap:
                merged[-1][1] = end
            else:
                merged.append([start, end])
        phases += [Stance(leg, start, end, start > 0) for start, end in merged]
    return phases


def slip_per_step(log: WalkMotion) -> float | None:
    """Return the mean path of the contact point while its foot is loaded, per step [m].

    Only the part along the ground counts, and only ticks at which the load exceeds LOADED. None:
    no foot stepped.
    """
    n = log.ground_normal
    along = log.slip_velocity - np.einsum("i,j,njk->nik", n, n, log.slip_velocity)
    loaded = log.normal_forces > LOADED * log.weight
    path = np.where(loaded, np.linalg.norm(along, axis=1), 0.0) / log.rate
    steps = [phase for phase in stance_phases(log) if phase.stepped]
    if not steps:
        return None
    return float(np.mean([path[s.start : s.end, s.leg].sum() for s in steps]))


def touchdown_force(log: WalkMotion) -> float | None:
    """Return the largest normal force of a foot just after a touchdown, in weights; None: no step.

    The force of each physics step at the end of a tick counts, so the peak between two ticks is
    missing.
    """
    window = max(1, round(TOUCHDOWN_TIME * log.rate))
    forces = log.normal_forces
    peaks = [
        forces[s.start : s.start + window, s.leg].max() for s in stance_phases(log) if s.stepped
    ]
    return float(max(peaks) / log.weight) if peaks else None
