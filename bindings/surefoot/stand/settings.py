"""Settings of a stand."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot.stand.simulation_settings import SimulationSettings


@dataclass(frozen=True)
class StandSettings(SimulationSettings):
    """Settings of a simulated stand: those of SimulationSettings.

    Equal settings give equal runs.
    """
