"""The plant: a quadruped simulated in MuJoCo, with the low-level interface LowCmd and LowState."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from surefoot.sim.flaws import Flaws
from surefoot.sim.mjcf.mapping import FootMatch, JointMatch, ModelMapping
from surefoot.sim.physics.external_lift import Lift
from surefoot.sim.plant import Plant
from surefoot.sim.settings import PlantSettings, Push
from surefoot.sim.terrain import Terrain
from surefoot.sim.truth import Truth

if TYPE_CHECKING:
    from surefoot.sim.render import Renderer

__all__ = [
    "Flaws",
    "FootMatch",
    "JointMatch",
    "Lift",
    "ModelMapping",
    "Plant",
    "PlantSettings",
    "Push",
    "Renderer",
    "Terrain",
    "Truth",
]


def __getattr__(name: str) -> Any:
    # The renderer loads a graphics library. Runs without pictures must work without it.
    if name == "Renderer":
        from surefoot.sim.render import Renderer

        return Renderer
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
