"""Choice of how MuJoCo renders."""

from __future__ import annotations

import ctypes.util
import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager

from surefoot._core import Error

_VARIABLE = "MUJOCO_GL"
_NO_GRAPHICS = "disable"
_NO_GRAPHICS_NAMES = (_NO_GRAPHICS, "disabled", "off", "false", "0")  # as in MuJoCo


@contextmanager
def kept_environment() -> Iterator[None]:
    """Restore MUJOCO_GL at the end, for programs that call main() and draw pictures themselves."""
    before = os.environ.get(_VARIABLE)
    try:
        yield
    finally:
        os.environ.pop(_VARIABLE, None)
        if before is not None:
            os.environ[_VARIABLE] = before


def choose_graphics(pictures: bool) -> None:
    """Choose how MuJoCo renders; call this function before MuJoCo is imported.

    Args:
        pictures: Whether the command draws pictures. If not, MuJoCo loads no graphics library, so
            that a wrong MUJOCO_GL or a broken driver does not matter.

    Raises:
        Error: Pictures are requested, and MUJOCO_GL names graphics that do not work.
    """
    chosen = os.environ.get(_VARIABLE, "").strip()
    if not pictures:
        os.environ[_VARIABLE] = _NO_GRAPHICS
    elif chosen:
        _check_graphics(chosen)
    elif sys.platform == "linux" and not _has_display():
        os.environ[_VARIABLE] = "egl" if ctypes.util.find_library("EGL") else _NO_GRAPHICS


def _has_display() -> bool:
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _check_graphics(chosen: str) -> None:
    """Open and close a graphics context; raise Error if this fails."""
    if chosen.lower() in _NO_GRAPHICS_NAMES:
        return  # a report then says why it has no film
    if chosen.lower() == "glfw" and sys.platform == "linux" and not _has_display():
        raise _unusable(chosen, "there is no display")
    try:
        import mujoco

        if chosen.lower() == "glfw":
            _start_glfw()
        mujoco.GLContext(1, 1).free()
    except ModuleNotFoundError as problem:
        if problem.name == "mujoco":
            return  # the command says how to install it
        raise _unusable(chosen, str(problem)) from None
    except AttributeError:  # PyOpenGL found no library, so its functions are None
        raise _unusable(chosen, "its library was not found") from None
    # MuJoCo and graphics libraries raise errors of many types.
    except Exception as problem:
        raise _unusable(chosen, str(problem)) from None


def _start_glfw() -> None:
    """Start GLFW, which only warns if the display does not answer; raise OSError instead."""
    import glfw

    with warnings.catch_warnings(action="ignore"):
        if not glfw.init():
            raise OSError("the display does not answer")


def _unusable(chosen: str, reason: str) -> Error:
    return Error(
        f"{_VARIABLE}: got '{chosen}', which does not work here ({reason}), expected egl, osmesa "
        "or glfw, whichever works; run: unset MUJOCO_GL"
    )
