"""MuJoCo window that shows a virtual robot."""

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
    """Window that shows a plant; the window has its own thread.

    The window also has its own model, with visual meshes, and its own state. So the window does not
    slow down or change the simulation.

    Args:
        plant: Plant to show.

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
        """True while the window is open."""
        return bool(self._window.is_running())

    def show(self) -> None:
        """Show the present state of the plant."""
        with self._window.lock():
            self._data.qpos[:] = self._plant.data.qpos
            mujoco.mj_kinematics(self._model, self._data)
            mujoco.mj_camlight(self._model, self._data)
        self._window.sync()

    def close(self) -> None:
        """Close the window."""
        self._window.close()


def check_display() -> None:
    """Raise Error if there is no display; call this function before any slow step."""
    if sys.platform != "linux":
        return
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise Error("view: got no display, expected DISPLAY or WAYLAND_DISPLAY to be set")


def _launcher() -> Any:
    check_display()
    try:
        import glfw
        from mujoco import viewer

        # Initialise GLFW here, because MuJoCo ends the process if its own initialisation fails.
        with warnings.catch_warnings(action="ignore"):
            if not glfw.init():
                raise Error(
                    "view: cannot open a window: the display does not answer; "
                    "start the virtual robot without --view"
                )
    except (ImportError, OSError) as problem:
        raise Error(f"view: cannot open a window: {problem}") from None
    return viewer.launch_passive
