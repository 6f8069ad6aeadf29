"""Integrators that the plant can use: those that mj_step2 computes."""

from __future__ import annotations

import mujoco

_USABLE = ("EULER", "IMPLICIT", "IMPLICITFAST")


def integrator_name(spec: mujoco.MjSpec) -> str:
    """Return the name of the file's integrator, such as EULER."""
    name: str = mujoco.mjtIntegrator(int(spec.option.integrator)).name
    return name.removeprefix("mjINT_")


def is_usable_integrator(spec: mujoco.MjSpec) -> bool:
    """Return whether the plant can use the file's integrator."""
    return integrator_name(spec) in _USABLE
