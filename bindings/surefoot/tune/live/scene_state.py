"""State of a robot and its surroundings, for drawing."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from surefoot.geometry.rotations import Array


@dataclass(frozen=True)
class SceneState:
    """State to draw, in world axes; feet are ordered FR FL RR RL.

    Attributes:
        qpos: Generalised positions of the MuJoCo model.
        contact_points: Lowest points of the feet (4, 3) [m], also of feet without contact.
        forces: Forces of the ground on the feet (4, 3) [N].
        contact: True for each loaded foot (4,).
        com: Centre of mass (3,) [m].
        ground: Orientation of the ground, w x y z, ground to world (4,).
        fell: True if the robot has fallen.
        payload_kg: Payload on the trunk [kg].
        push: Force (3,) [N] and its point of attack (3,) [m]. None: no push acts.
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

    def moved(self, offset: Array) -> SceneState:
        """Return the state with all positions moved by an offset (3,) [m]."""
        qpos = self.qpos.copy()
        qpos[:3] += offset
        return replace(
            self,
            qpos=qpos,
            contact_points=self.contact_points + offset,
            com=self.com + offset,
            push=None if self.push is None else (self.push[0], self.push[1] + offset),
        )
