"""MuJoCo's window on a virtual robot."""

from __future__ import annotations

import os
import sys
import warnings
from typing import Any

import mujoco

from surefoot._core import Error
from surefoot.sim import Plant
from surefoot.sim.model.mujoco_model import build_model


class Viewer:
    """Shows a plant in a window of its own thread.

    The window has a model and a state of its own, with the visual meshes, so that it neither slows
    the physics down nor touches them.

    Raises:
        Error: There is no display, or the window cannot be opened.
    """

    def __init__(self, plant: Plant) -> None:
        self._plant = plant
        launch = _launcher()
        self._model = build_model(plant.robot, plant.description, plant.settings, visuals=True)
        self._data = mujoco.MjData(self._model)
        try:
            self._window: Any = launch(self._model, self._data)
        except RuntimeError as problem:
            raise Error(f"view: cannot open a window: {problem}") from None

    @property
    def open(self) -> bool:
        """Whether nobody has closed the window."""
        return bool(self._window.is_running())

    def show(self) -> None:
        """Show this instant."""
        with self._window.lock():
            self._data.qpos[:] = self._plant.data.qpos
            mujoco.mj_kinematics(self._model, self._data)
            mujoco.mj_camlight(self._model, self._data)
        self._window.sync()

    def close(self) -> None:
        """Close the window."""
        self._window.close()


def check_display() -> None:
    """Raise Error if there is no display, before anything takes time."""
    if sys.platform != "linux":
        return
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise Error("view: there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set)")


def _launcher() -> Any:
    check_display()
    try:
        import glfw
        from mujoco import viewer

        # MuJoCo would end the process where this fails.
        with warnings.catch_warnings(action="ignore"):
            if not glfw.init():
                raise Error("view: cannot open a window: the display does not answer")
    except (ImportError, OSError) as problem:
        raise Error(f"view: cannot open a window: {problem}") from None
    return viewer.launch_passive
