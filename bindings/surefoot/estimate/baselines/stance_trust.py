"""Trust in a foot over its stance."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot.estimate.contact_events import joined_stances
from surefoot.geometry.batch_rotations import Array

# Share of a stance over which the trust rises at its start and falls at its end, as in
# Cheetah-Software, PositionVelocityEstimator.cpp, trust_window.
TRUST_WINDOW = 0.2


def stance_trust(time: Array, contact: npt.NDArray[np.bool_]) -> Array:
    """Return the trust (n, 4), 0 .. 1, in each foot from its contact (n, 4).

    The trust is 0 in swing, rises over the first fifth of a stance and falls over the last fifth.
    A stance that is longer than the median stance of the foot, as of a robot that stands, counts
    as long as the median. The end of a stance must be known in advance: on a robot it is known
    from the schedule of the gait, here from the log. At the ends of the log nothing rises or falls.
    """
    trust = np.zeros(contact.shape)
    for leg in range(contact.shape[1]):
        stances = joined_stances(time, contact[:, leg])
        inner = [time[b - 1] - time[a] for a, b in stances if a > 0 and b < len(time)]
        usual = float(np.median(inner)) if inner else np.inf
        for a, b in stances:
            start, end = float(time[a]), float(time[b - 1])
            ramp = max(TRUST_WINDOW * min(end - start, usual), 1e-9)
            since = np.inf if a == 0 else time[a:b] - start
            until = np.inf if b == len(time) else end - time[a:b]
            trust[a:b, leg] = np.clip(np.minimum(since, until) / ramp, 0.0, 1.0)
    return trust
