"""Figures of a walk over the last seconds: how well the true robot follows its command."""

from __future__ import annotations

import math
from collections import deque

import mujoco
import numpy as np

from surefoot._core import WalkController
from surefoot.geometry.rotations import Array, matrix_from_wxyz
from surefoot.sim import Plant

WINDOW = 3.0  # [s] chosen: some strides, and short enough to see the effect of a gain
_EVERY = 5  # ticks per row; chosen: at 500 Hz 100 rows a second, ten times the rate of steps


class WalkFigures:
    """RMS of velocity error, roll and pitch of a simulated robot that walks.

    Args:
        plant: The plant.
        controller: Its controller.
    """

    def __init__(self, plant: Plant, controller: WalkController) -> None:
        self._plant, self._controller = plant, controller
        rows = round(WINDOW * plant.settings.control_rate / _EVERY)
        self._rows: deque[Array] = deque(maxlen=rows)
        self._ticks = 0

    def record(self) -> None:
        """Record a tick; call after each step of the plant."""
        self._ticks += 1
        if not self._controller.walking:
            self._rows.clear()
        elif self._ticks % _EVERY == 0:
            self._rows.append(self._row())

    @property
    def rms(self) -> Array | None:
        """RMS of the errors of vx, vy [m/s], yaw rate [rad/s], and of roll and pitch [deg].

        None: the robot does not walk.
        """
        rows = list(self._rows)  # a copy, because another thread records
        return np.asarray(np.sqrt(np.mean(np.square(rows), axis=0))) if rows else None

    def text(self) -> str:
        """Return command and RMS errors as Markdown."""
        rms = self.rms
        if rms is None:
            return "The robot stands."
        v = self._controller.commanded_velocity
        limit = self._controller.velocity_limit.name.lower()
        limited = "" if limit == "none" else f", limit: {limit}"
        return (
            f"Command {v.vx:.2f}, {v.vy:.2f} m/s, {v.yaw_rate:.2f} rad/s{limited}\n\n"
            f"**RMS error** {rms[0]:.3f}, {rms[1]:.3f} m/s, {rms[2]:.3f} rad/s; "
            f"roll {rms[3]:.1f}, pitch {rms[4]:.1f} deg (last {WINDOW:g} s)"
        )

    def _row(self) -> Array:
        data, handles = self._plant.data, self._plant.handles
        mujoco.mj_subtreeVel(self._plant.model, data)
        velocity = data.subtree_linvel[handles.root]
        ground = matrix_from_wxyz(self._plant.model.geom_quat[handles.ground_geom])
        rotation = matrix_from_wxyz(data.qpos[3:7])
        forward, up = ground.T @ rotation[:, 0], ground.T @ rotation[:, 2]
        yaw = math.atan2(forward[1], forward[0])
        c, s = math.cos(yaw), math.sin(yaw)
        command = self._controller.commanded_velocity
        return np.array(
            [
                c * velocity[0] + s * velocity[1] - command.vx,
                c * velocity[1] - s * velocity[0] - command.vy,
                float(rotation[2] @ data.qvel[3:6]) - command.yaw_rate,
                math.degrees(math.asin(s * up[0] - c * up[1])),
                math.degrees(math.asin(c * up[0] + s * up[1])),
            ]
        )
