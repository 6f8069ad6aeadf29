"""Choice of how MuJoCo renders."""

from __future__ import annotations

import ctypes.util
import os
import sys


def choose_graphics() -> None:
    """Choose how MuJoCo renders on a machine without a screen.

    Call this function before MuJoCo is imported.
    """
    if os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY") or sys.platform != "linux":
        return
    # Set MUJOCO_GL=egl only if the EGL library exists: otherwise importing MuJoCo fails, even for
    # a run that renders nothing.
    library = ctypes.util.find_library("EGL")
    os.environ.setdefault("MUJOCO_GL", "egl" if library else "disable")
