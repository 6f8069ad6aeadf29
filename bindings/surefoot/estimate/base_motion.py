"""Motion of the base as every estimator gives it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot.geometry.batch_rotations import Array


@dataclass(frozen=True)
class BaseMotion:
    """Pose and velocity of the base for each of n rows, in a world frame with z up.

    Attributes:
        rotation: (n, 3, 3) rotation matrices, base axes to world axes.
        position: (n, 3) position of the base [m].
        velocity: (n, 3) velocity of the base, world axes [m/s].
    """

    rotation: Array
    position: Array
    velocity: Array

    @property
    def yaw(self) -> Array:
        """(n,) yaw without jumps [rad]."""
        return np.unwrap(np.arctan2(self.rotation[:, 1, 0], self.rotation[:, 0, 0]))

    def rows(self, selection: npt.NDArray[np.bool_] | slice) -> BaseMotion:
        """Return the selected rows."""
        return BaseMotion(
            self.rotation[selection], self.position[selection], self.velocity[selection]
        )
