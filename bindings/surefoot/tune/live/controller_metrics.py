"""Metrics of a controller, computed only from its own reference and estimate."""

from __future__ import annotations

import math

import numpy as np

from surefoot._core import BodyReference, StandController
from surefoot.geometry.rotations import Array


def pose_errors(controller: StandController) -> tuple[float, float]:
    """Return distance [mm] and angle [deg] between the estimated base and its reference."""
    reference, q = controller.reference, controller.state.q
    distance = 1000.0 * float(np.linalg.norm(reference.p_base - q[:3]))
    # The scalar product of two unit quaternions is the cosine of half the rotation between them.
    cosine = min(1.0, abs(float(np.dot(reference.quat_world_base, q[3:7]))))
    return distance, math.degrees(2.0 * math.acos(cosine))


def torque_ratio(tau: Array, tau_max: Array) -> float:
    """Return the largest ratio of torque magnitude to torque limit; both are (12,) [N.m]."""
    return float(np.max(np.abs(tau) / tau_max))


def body_reference(values: dict[str, float]) -> BodyReference:
    """Return a BodyReference from values by axis [m, deg]."""
    angles = {"roll", "pitch", "yaw"}
    return BodyReference(
        **{name: math.radians(v) if name in angles else v for name, v in values.items()}
    )
