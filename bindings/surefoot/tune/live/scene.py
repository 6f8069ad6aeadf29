"""3D scene: robot, contact forces, polygon of the loaded feet, pushes."""

from __future__ import annotations

import mujoco
import numpy as np
import viser

from surefoot.geometry.rotations import Array
from surefoot.robot.description import RobotDescription
from surefoot.robot.loading import build_robot
from surefoot.sim.model.mujoco_model import build_model
from surefoot.sim.settings import PlantSettings
from surefoot.tune.live.ground_and_payload import GRID_SECTION, GroundAndPayload
from surefoot.tune.live.robot_mesh import body_meshes
from surefoot.tune.live.scene_state import SceneState
from surefoot.tune.live.support_polygon import SupportPolygon
from surefoot.tune.live.treadmill import Treadmill

FORCE_GREEN, PUSH_RED = (38, 158, 82), (219, 31, 31)
# [m], [quaternion component] Smallest change that is sent. Chosen: less than a pixel.
_MIN_DISPLACEMENT, _MIN_ROTATION = 2e-5, 1e-5
# Chosen by eye.
_REFLECTION_INTENSITY = 0.4  # intensity of the environment map
_AMBIENT_INTENSITY = 1.2  # intensity of the ambient light, used without environment map
# Chosen: less than the weight of a foot, and more than the noise of unloaded feet.
_MIN_ARROW_FORCE = 1.0  # [N] smallest force that is drawn as an arrow


class Scene:
    """Drawing of one robot's SceneState in a viser server.

    Args:
        server: The server.
        description: The robot's files.
    """

    def __init__(self, server: viser.ViserServer, description: RobotDescription) -> None:
        self._server = server
        robot = build_robot(description)
        self._model = build_model(robot, description, PlantSettings(), visuals=True)
        self._data = mujoco.MjData(self._model)
        self._weight = 9.81 * float(np.sum(self._model.body_mass))
        # [m] Length scale of all drawn objects, from the cube root of the mass: 0.29 m for 12 kg.
        self._size = (self._weight / 9.81) ** (1 / 3) / 8.0
        self._frames = self._add_robot()
        self._ground_and_payload = GroundAndPayload(server, self._base_name, self._size)
        self._support_polygon = SupportPolygon(server, self._size)
        self._treadmill = Treadmill(0.5 * self._size, GRID_SECTION)
        self._arrows: viser.ArrowsHandle | None = None
        self._ambient_light = server.scene.add_light_ambient(
            "/lamp", intensity=_AMBIENT_INTENSITY, visible=False
        )
        self._aim_camera()

    def show(self, scene_state: SceneState) -> None:
        """Draw a state; send only those poses that changed visibly.

        The view follows the robot.
        """
        scene_state = self._treadmill.follow(scene_state)
        self._data.qpos[:] = scene_state.qpos
        mujoco.mj_kinematics(self._model, self._data)
        with self._server.atomic():
            for body, frame in self._frames.items():
                position, wxyz = self._data.xpos[body], self._data.xquat[body]
                if np.abs(position - frame.position).max() > _MIN_DISPLACEMENT:
                    frame.position = position
                if np.abs(wxyz - frame.wxyz).max() > _MIN_ROTATION:
                    frame.wxyz = wxyz
            ground_position = self._treadmill.ground_position(scene_state.ground)
            self._ground_and_payload.show(scene_state, ground_position)
            self._support_polygon.show(scene_state)
            self._show_forces(scene_state)

    def set_plain(self, plain: bool) -> None:
        """Switch shadows and reflections off (`plain`) or on.

        Without a GPU, shadows and reflections take most of the drawing time.
        """
        self._server.scene.configure_default_lights(True, cast_shadow=not plain)
        self._server.scene.configure_environment_map(
            None if plain else "warehouse", environment_intensity=_REFLECTION_INTENSITY
        )
        self._ambient_light.visible = plain

    @property
    def _base_name(self) -> str:
        return f"/robot/{self._model.body(1).name}"

    def _add_robot(self) -> dict[int, viser.FrameHandle]:
        scene, frames = self._server.scene, {}
        for k, part in enumerate(body_meshes(self._model)):
            name = f"/robot/{self._model.body(part.body).name}"
            if part.body not in frames:
                frames[part.body] = scene.add_frame(name, show_axes=False)
            scene.add_mesh_simple(
                f"{name}/{k}", part.vertices, part.faces, color=part.colour, side="double"
            )
        return frames

    def _show_forces(self, scene_state: SceneState) -> None:
        metres_per_newton = 2.0 * self._size / self._weight  # length of an arrow per newton
        loaded = np.linalg.norm(scene_state.forces, axis=1) > _MIN_ARROW_FORCE
        starts, colours = scene_state.contact_points[loaded], [FORCE_GREEN] * int(loaded.sum())
        ends = starts + metres_per_newton * scene_state.forces[loaded]
        if scene_state.push is not None:
            # The tip of the arrow is near the point of attack, but outside the trunk.
            force, point = scene_state.push
            tip = point - 0.3 * self._size * force / np.linalg.norm(force)
            starts, ends = (
                np.vstack([starts, tip - metres_per_newton * force]),
                np.vstack([ends, tip]),
            )
            colours.append(PUSH_RED)
        self._draw_arrows(np.stack([starts, ends], axis=1), colours)

    def _draw_arrows(self, points: Array, colours: list[tuple[int, int, int]]) -> None:
        if self._arrows is not None and len(colours) == len(self._arrows.points):
            if np.abs(points - self._arrows.points).max(initial=0.0) > 1e-3 * self._size:
                self._arrows.points = points.astype(np.float32)
            return
        self._arrows = self._server.scene.add_arrows(
            "/forces",
            points,
            np.array(colours, dtype=np.uint8).reshape(-1, 3),
            shaft_radius=0.016 * self._size,
            head_radius=0.04 * self._size,
            head_length=0.09 * self._size,
        )

    def _aim_camera(self) -> None:
        camera = self._server.initial_camera
        camera.position = (1.5 * self._size, -2.3 * self._size, 1.5 * self._size)
        camera.look_at = (0.0, 0.0, 0.55 * self._size)
