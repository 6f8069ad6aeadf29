"""Pictures of a plant: robot and ground, pushes as red arrows, foot forces as green arrows."""

from __future__ import annotations

import math

import mujoco
import numpy as np
import numpy.typing as npt

from surefoot.geometry.rotations import Array
from surefoot.sim.model.mujoco_model import build_model
from surefoot.sim.plant import Plant

# Colours (red, green, blue, opacity). All sizes and angles below are chosen by eye.
PUSH_RED = (0.86, 0.12, 0.12, 1.0)
FORCE_GREEN = (0.15, 0.62, 0.32, 0.9)


class Renderer:
    """Renders a plant with a camera that follows the robot.

    Needs a graphics context. On a machine without a screen, set MUJOCO_GL=egl first.

    Args:
        plant: The plant; the renderer only reads it.
        width: Width of the picture [pixels].
        height: Height of the picture [pixels].
        visuals: Whether to draw the visual meshes; False draws the collision geometry instead.
        azimuth: Viewing direction of the camera [deg], from world x towards world y.
        elevation: Elevation of the viewing direction [deg]; negative: downwards.
    """

    def __init__(
        self,
        plant: Plant,
        width: int = 640,
        height: int = 480,
        visuals: bool = True,
        azimuth: float = 130.0,
        elevation: float = -14.0,
    ) -> None:
        self._plant = plant
        # A separate model, because visual meshes would slow the physics down.
        self._model = build_model(plant.robot, plant.description, plant.settings, visuals)
        self._model.vis.global_.offwidth = max(width, 640)
        self._model.vis.global_.offheight = max(height, 480)
        self._data = mujoco.MjData(self._model)
        # [m] Length that grows with the mass of the robot; all drawn sizes are multiples of it.
        self._size = float(plant.model.body_subtreemass[plant.handles.root]) ** (1 / 3) / 8.0
        _set_visual_options(self._model, self._size)
        self._renderer = mujoco.Renderer(self._model, height, width)
        self._camera = mujoco.MjvCamera()
        self._camera.type = mujoco.mjtCamera.mjCAMERA_FREE
        self._camera.azimuth, self._camera.elevation = azimuth, elevation
        self._camera.distance = 3.8 * self._size
        self._option = mujoco.MjvOption()
        self._option.flags[mujoco.mjtVisFlag.mjVIS_STATIC] = True

    def frame(self) -> npt.NDArray[np.uint8]:
        """Return a picture of the present state, RGB, shape (height, width, 3)."""
        plant = self._plant
        self._data.qpos[:] = plant.data.qpos
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_camlight(self._model, self._data)
        base = plant.data.xpos[plant.handles.root]
        self._camera.lookat[:] = [base[0], base[1], base[2] - 0.35 * self._size]
        self._renderer.update_scene(self._data, self._camera, self._option)
        self._draw_forces()
        return np.array(self._renderer.render())

    def close(self) -> None:
        """Free the graphics context."""
        self._renderer.close()

    def _draw_forces(self) -> None:
        plant, truth = self._plant, self._plant.truth
        metres_per_newton = (
            2.5 * self._size / (plant.model.body_subtreemass[plant.handles.root] * 9.81)
        )
        radius = plant.handles.foot_radius
        for leg in range(4):
            start = truth.p_world_feet[:, leg] - radius * plant.handles.ground_normal
            self._arrow(
                start, start + metres_per_newton * truth.foot_forces[:, leg], 0.4, FORCE_GREEN
            )
        force, point = plant.push_force
        if np.any(force):
            # The arrow ends near the point where the force acts; its length is proportional to the
            # force.
            tip = point - 0.3 * self._size * force / np.linalg.norm(force)  # outside the trunk
            self._arrow(tip - metres_per_newton * force, tip, 1.0, PUSH_RED)

    def _arrow(
        self, start: Array, end: Array, width: float, rgba: tuple[float, float, float, float]
    ) -> None:
        scene = self._renderer.scene
        if scene.ngeom >= scene.maxgeom or math.dist(start, end) < 1e-3:
            return
        geom = scene.geoms[scene.ngeom]
        arrow = mujoco.mjtGeom.mjGEOM_ARROW
        mujoco.mjv_initGeom(
            geom, arrow, np.zeros(3), np.zeros(3), np.eye(3).ravel(), np.array(rgba, np.float32)
        )
        mujoco.mjv_connector(geom, arrow, 0.06 * width * self._size, start, end)
        scene.ngeom += 1


def _set_visual_options(model: mujoco.MjModel, size: float) -> None:
    model.stat.extent = 6.0 * size  # unit of length of the shadow and the clipping planes
    model.vis.headlight.ambient[:] = 0.35
    model.vis.headlight.diffuse[:] = 0.35
    model.vis.headlight.specular[:] = 0.1
    model.vis.quality.shadowsize = 2048
    model.vis.map.shadowclip = 0.5
    model.vis.map.znear = 0.02
    model.vis.map.zfar = 60.0
