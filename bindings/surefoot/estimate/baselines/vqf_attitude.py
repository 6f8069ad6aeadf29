"""Attitude from the IMU alone, by the package vqf."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import Error
from surefoot.estimate.baselines.inputs import BaselineInputs
from surefoot.geometry.batch_rotations import Array, matrices_from_xyzw, rotations_about_z


def check_vqf() -> Any:
    """Import and return the package vqf.

    Raises:
        Error: The package is not installed.
    """
    try:
        import vqf
    except ModuleNotFoundError:
        raise Error(
            "module 'vqf' not found: the baselines need the extra 'baselines'; "
            "run: pip install 'surefoot[baselines]'"
        ) from None
    return vqf


def vqf_attitude(inputs: BaselineInputs) -> Array:
    """Return the rotation matrices (n, 3, 3), base axes to world axes, by VQF.

    VQF (Laidig and Seel, Information Fusion 91, 2023) with its default parameters and without a
    magnetometer. Row k depends on rows 0 .. k only. VQF assumes a constant rate. The heading of
    the first row is x.

    Raises:
        Error: The package vqf is not installed.
    """
    vqf = check_vqf()
    samples = (np.ascontiguousarray(a) for a in (inputs.gyroscope, inputs.accelerometer))
    wxyz = vqf.VQF(inputs.period).updateBatch(*samples)["quat6D"]
    rotation = matrices_from_xyzw(wxyz[:, [1, 2, 3, 0]])
    yaw = np.arctan2(rotation[:1, 1, 0], rotation[:1, 0, 0])
    return np.asarray(rotations_about_z(-yaw)[0] @ rotation)
