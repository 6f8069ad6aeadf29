"""Refuses settings of a plant that an MJCF file replaces."""

from __future__ import annotations

from dataclasses import fields

from surefoot._core import Error
from surefoot.sim.settings import PlantSettings

REPLACED = (
    *("friction", "soft_ground_sink", "slope_deg", "terrain"),
    *("platform_heading_deg", "block_foot"),
)
"""Settings of ground and contacts. Soft soles and collisions of legs have no effect."""


def check_replaced_settings(settings: PlantSettings) -> None:
    """Raise Error if a setting that the MJCF replaces does not have its default."""
    defaults = PlantSettings()
    for field in fields(settings):
        value, default = getattr(settings, field.name), getattr(defaults, field.name)
        if field.name in REPLACED and value != default:
            raise Error(
                f"{field.name}: got {value!r} with an MJCF, expected the default {default!r}, "
                "because ground and contacts are those of the file; change the file instead"
            )
