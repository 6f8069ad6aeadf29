"""Choice of how MuJoCo renders."""

from __future__ import annotations

import ctypes.util
import os
import sys


def choose_graphics() -> None:
    """Choose how MuJoCo renders on a machine without a screen; call before MuJoCo is imported."""
    if os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY") or sys.platform != "linux":
        return
    # With MUJOCO_GL=egl but without the library, importing MuJoCo fails. A run without a film
    # needs no graphics.
    library = ctypes.util.find_library("EGL")
    os.environ.setdefault("MUJOCO_GL", "egl" if library else "disable")
