"""One instant of a robot as the scene draws it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot.geometry.rotations import Array


@dataclass(frozen=True)
class SceneState:
    """A robot on its ground, world axes; feet run FR FL RR RL.

    Attributes:
        qpos: MuJoCo's positions.
        contact_points: (4, 3) of the soles, whether or not they touch [m].
        forces: (4, 3) ground on foot [N].
        contact: (4,) which feet bear.
        com: (3,) centre of mass [m].
        ground: (4,) attitude of the ground, w x y z, ground to world.
        fell: Whether the robot has fallen.
        payload_kg: Mass on the trunk that is to be seen [kg].
        push: Force (3,) [N] and where it acts (3,) [m], or None.
    """

    qpos: Array
    contact_points: Array
    forces: Array
    contact: npt.NDArray[np.bool_]
    com: Array
    ground: Array
    fell: bool = False
    payload_kg: float = 0.0
    push: tuple[Array, Array] | None = None
