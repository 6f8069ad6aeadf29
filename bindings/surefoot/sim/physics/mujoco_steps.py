"""Finds mj_step1() and mj_step2() of the installed MuJoCo; C++ calls both in a loop."""

from __future__ import annotations

import ctypes
import functools
from pathlib import Path

import mujoco

from surefoot import _plant
from surefoot._core import Error
from surefoot.sim.hardware.sensors import mujoco_state
from surefoot.sim.model.mujoco_handles import Handles


def make_physics(model: mujoco.MjModel, data: mujoco.MjData, handles: Handles) -> _plant.Physics:
    """Return the C++ object that advances the state, with motors and sensors between half steps."""
    return _plant.Physics(*_load_half_steps(), model, data, mujoco_state(data, handles))


@functools.cache
def _load_half_steps() -> tuple[int, int]:
    folder = Path(mujoco.__file__).parent
    names = [
        path for path in folder.glob("libmujoco*") if ".so" in path.name or ".dylib" in path.name
    ]
    if len(names) != 1:
        raise Error(f"mujoco: got {len(names)} libraries libmujoco* in {folder}, expected one")
    library = ctypes.CDLL(str(names[0]))  # the library that the mujoco module has loaded
    step1, step2 = (
        ctypes.cast(f, ctypes.c_void_p).value for f in (library.mj_step1, library.mj_step2)
    )
    assert step1 is not None and step2 is not None
    return step1, step2
